//! The hard-case table: what fails in f32 if it is written naively, what the crate is off by at the same inputs, on
//! this machine and on a Cortex-M4F, what it may be off by, and the test that guards it.
//!
//! The forms and inputs are those of [`hard`], which a device runs too (`tests/data/hard_m4f.txt` is what it said);
//! what is right is computed here, in f64.

mod claim;
mod colors;
mod device;
#[path = "../hard/mod.rs"]
mod hard;
mod light;
mod linear;
mod micromath;
mod semantics;
mod surfaces;
mod text;

use claim::{Claim, Naive};
use device::Recorded;
pub use micromath::Micromath;
pub use text::markdown;

/// What is wrong with some numbers.
#[derive(Clone, Copy, Debug, Default)]
pub struct Error {
    /// The largest finite error, as the row measures it.
    pub size: f64,
    /// The largest finite error as a share of what is allowed there.
    pub share: f64,
    /// Results that are NaN and should not be, or that are infinitely far off.
    pub nan: usize,
    pub infinite: usize,
}

impl Error {
    /// Whether all is as it must be.
    pub fn within(&self) -> bool {
        self.share <= 1.0 && self.nan + self.infinite == 0
    }
}

/// A row of the table, or a part of one.
pub struct HardCase {
    /// Number of the row, and the letter of its part.
    pub row: u8,
    pub part: &'static str,
    pub what: &'static str,
    pub inputs: &'static str,
    /// How many inputs there are.
    pub count: usize,
    /// How errors are measured.
    pub unit: &'static str,
    pub naive: Error,
    /// The naive form on a Cortex-M4F that flushes subnormal numbers to zero.
    pub naive_m4f_ftz: Error,
    pub ours: Error,
    pub m4f: Error,
    pub m4f_ftz: Error,
    /// Inputs where a Cortex-M4F has other bits than this machine, flush-to-zero off.
    pub other_bits: usize,
    /// What ours may be off by.
    pub tolerance: String,
    /// What was asked for, where that is less.
    pub asked: &'static str,
    /// Whether the naive form must be found wrong.
    pub naive_fails: bool,
    /// The test that guards it, `file::name`.
    pub test: &'static str,
}

impl HardCase {
    /// The reasons why this row is not as it claims to be.
    pub fn faults(&self) -> Vec<String> {
        let mut faults = Vec::new();
        for (place, error) in [("here", self.ours), ("on M4F", self.m4f), ("on M4F, flushing", self.m4f_ftz)]
        {
            if !error.within() {
                faults.push(format!("ours is off by {} {place}, allowed {}", error.size, self.tolerance));
            }
        }
        if self.other_bits > 0 {
            faults.push(format!("{} results have other bits on M4F", self.other_bits));
        }
        let naive_holds = self.naive.within() && self.naive_m4f_ftz.within();
        if naive_holds == self.naive_fails {
            faults.push(format!("the naive form {}", if naive_holds { "holds" } else { "fails" }));
        }
        faults.into_iter().map(|fault| format!("row {}{}: {fault}", self.row, self.part)).collect()
    }
}

/// A rule of behaviour, and the test that pins it.
pub struct Semantic {
    pub what: &'static str,
    pub test: &'static str,
}

/// Every rule.
pub fn semantics() -> &'static [Semantic] {
    semantics::ALL
}

/// Every row, computed, in the order of their numbers.
pub fn hard_cases() -> Vec<HardCase> {
    let mut table = Table { recorded: Recorded::read(), rows: Vec::new() };
    hard::all(&mut table);
    assert_eq!(table.rows.len(), claims().count(), "a claim about a row that is not there");
    table.rows.sort_by_key(|case| (case.row, case.part));
    table.rows
}

fn claims() -> impl Iterator<Item = &'static Claim> {
    [light::CLAIMS, surfaces::CLAIMS, colors::CLAIMS, linear::CLAIMS].into_iter().flatten()
}

struct Table {
    recorded: Recorded,
    rows: Vec<HardCase>,
}

impl hard::Cases for Table {
    fn row<const A: usize, const K: usize>(
        &mut self,
        row: &str,
        inputs: &[[f32; A]],
        naive: fn(&[f32; A]) -> [f32; K],
        ours: fn(&[f32; A]) -> [f32; K],
    ) {
        let mut claims = claims().filter(|claim| claim.row == row);
        let (Some(claim), None) = (claims.next(), claims.next()) else {
            panic!("not one claim about row {row}");
        };
        let mut case = claim.case(inputs.len());
        for (k, input) in inputs.iter().enumerate() {
            let (naive, ours) = (naive(input), ours(input));
            let [plain, flushed] = self.recorded.at(row, k);
            claim.add(&mut case.naive, input, &naive);
            claim.add(&mut case.ours, input, &ours);
            claim.add(&mut case.m4f, input, &plain.ours);
            claim.add(&mut case.m4f_ftz, input, &flushed.ours);
            claim.add(&mut case.naive_m4f_ftz, input, &flushed.naive);
            let same = |(a, b): (&f32, &f32)| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
            if plain.ours.len() != K || !plain.ours.iter().zip(&ours).all(same) {
                case.other_bits += 1;
            }
        }
        self.rows.push(case);
    }
}

impl Claim {
    fn case(&self, count: usize) -> HardCase {
        let digits = self.row.trim_end_matches(|c: char| c.is_ascii_alphabetic());
        HardCase {
            row: digits.parse().unwrap_or(0),
            part: &self.row[digits.len()..],
            what: self.what,
            inputs: self.inputs,
            count,
            unit: self.measured,
            naive: Error::default(),
            naive_m4f_ftz: Error::default(),
            ours: Error::default(),
            m4f: Error::default(),
            m4f_ftz: Error::default(),
            other_bits: 0,
            tolerance: self.tolerance(),
            asked: self.asked,
            naive_fails: self.naive == Naive::Fails,
            test: self.test,
        }
    }
}
