//! The table of hard cases. Each row has a form that fails in f32 as textbooks write it, the error of the
//! crate at the same inputs on this machine and on a Cortex-M4F, the error that is allowed, and the test that
//! holds it.
//!
//! The forms and inputs are those of [`nanospectra_hard::cases`], which a device runs too. [`device`] reads
//! the results of the device, [`claim`] reads what each row claims, and [`judge`] measures errors against
//! f64.

mod claim;
mod colors;
mod device;
mod judge;
mod light;
mod linear;
mod surfaces;
mod text;

pub use claim::rules;
use claim::{Claim, Naive, claims};
use device::Recorded;
use judge::Judge;
use nanospectra_hard::cases::{self, Cases};
pub use text::markdown;

/// The errors of the results of one row.
#[derive(Clone, Copy, Default)]
struct Error {
    /// The largest finite error, as the row measures it.
    size: f64,
    /// The largest finite error as a share of what is allowed at that input.
    share: f64,
    /// How many results are NaN and should not be; `infinite` counts those that are infinitely far off.
    nan: usize,
    infinite: usize,
}

impl Error {
    /// Returns whether every result is within its limit.
    fn within(&self) -> bool {
        self.share <= 1.0 && self.nan + self.infinite == 0
    }

    /// Adds the error of the results `got` at the input `at`.
    fn add(&mut self, judge: Judge, limit: f64, at: &[f32], got: &[f32]) {
        if got.is_empty() {
            // No device has run this row yet.
            self.nan += 1;
            return;
        }
        let wide = |numbers: &[f32]| numbers.iter().map(|x| f64::from(*x)).collect::<Vec<_>>();
        let off = judge(&wide(at), &wide(got));
        if off.error.is_nan() {
            self.nan += 1;
        } else if off.error.is_infinite() {
            self.infinite += 1;
        } else {
            self.size = self.size.max(off.error);
            self.share = self.share.max(if off.error == 0.0 { 0.0 } else { off.error / (limit * off.unit) });
        }
    }
}

/// A row of the table, or a part of one.
pub struct HardCase {
    pub claim: Claim,
    /// The number of inputs of the row.
    count: usize,
    naive: Error,
    /// The naive form on a Cortex-M4F that flushes subnormal numbers to zero.
    naive_m4f_ftz: Error,
    ours: Error,
    m4f: Error,
    m4f_ftz: Error,
    /// The number of inputs where a Cortex-M4F without flush-to-zero gives other bits than this machine.
    other_bits: usize,
}

impl HardCase {
    /// Returns the reasons why this row differs from what it claims.
    pub fn faults(&self) -> Vec<String> {
        let mut faults = Vec::new();
        for (place, error) in [("here", self.ours), ("on M4F", self.m4f), ("on M4F, flushing", self.m4f_ftz)]
        {
            if !error.within() {
                let allowed = self.claim.tolerance();
                faults.push(format!("ours is off by {} {place}, allowed {allowed}", error.size));
            }
        }
        if self.other_bits > 0 {
            faults.push(format!("{} results have other bits on M4F", self.other_bits));
        }
        let naive_holds = self.naive.within() && self.naive_m4f_ftz.within();
        if naive_holds != (self.claim.naive == Naive::Holds) {
            faults.push(format!("the naive form {}", if naive_holds { "holds" } else { "fails" }));
        }
        faults.into_iter().map(|fault| format!("row {}: {fault}", self.claim.row)).collect()
    }
}

/// Computes every row, in the order of their numbers.
pub fn hard_cases() -> Vec<HardCase> {
    let mut table = Table { recorded: Recorded::read(), claims: claims(), rows: Vec::new() };
    cases::all(&mut table);
    assert_eq!(table.rows.len(), table.claims.len(), "a claim about a row that is not there");
    table.rows.sort_by(|a, b| a.claim.place().cmp(&b.claim.place()));
    table.rows
}

struct Table {
    recorded: Recorded,
    claims: Vec<Claim>,
    rows: Vec<HardCase>,
}

impl Cases for Table {
    fn row<const A: usize, const K: usize>(
        &mut self,
        row: &str,
        inputs: &[[f32; A]],
        naive: fn(&[f32; A]) -> [f32; K],
        ours: fn(&[f32; A]) -> [f32; K],
    ) {
        let mut claims = self.claims.iter().filter(|claim| claim.row == row);
        let mut judges = [light::JUDGES, surfaces::JUDGES, colors::JUDGES, linear::JUDGES]
            .into_iter()
            .flatten()
            .filter(|(of, _)| *of == row);
        let (Some(claim), None, Some((_, judge)), None) =
            (claims.next(), claims.next(), judges.next(), judges.next())
        else {
            panic!("not one claim and one judge of row {row}");
        };
        let none = Error::default();
        let mut case = HardCase {
            claim: claim.clone(),
            count: inputs.len(),
            naive: none,
            naive_m4f_ftz: none,
            ours: none,
            m4f: none,
            m4f_ftz: none,
            other_bits: 0,
        };
        for (k, input) in inputs.iter().enumerate() {
            let (naive, ours) = (naive(input), ours(input));
            let [plain, flushed] = self.recorded.at(row, k);
            for (error, got) in [
                (&mut case.naive, &naive[..]),
                (&mut case.ours, &ours),
                (&mut case.m4f, &plain.ours),
                (&mut case.m4f_ftz, &flushed.ours),
                (&mut case.naive_m4f_ftz, &flushed.naive),
            ] {
                error.add(*judge, claim.limit, input, got);
            }
            let same = |(a, b): (&f32, &f32)| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
            if plain.ours.len() != K || !plain.ours.iter().zip(&ours).all(same) {
                case.other_bits += 1;
            }
        }
        self.rows.push(case);
    }
}
