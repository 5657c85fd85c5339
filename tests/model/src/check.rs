//! Compares numbers with a golden, row by row, and counts what it compared.

use super::csv::Row;

/// The unit of rounding of f32: half the distance between 1 and the next number.
pub const EPS: f64 = 1.0 / 16_777_216.0;

/// Passes when `|got - expected| <= absolute + relative * |expected|`.
pub struct Check {
    what: &'static str,
    absolute: f64,
    relative: f64,
    pub compared: usize,
    /// Largest error in units of what is allowed, and where.
    worst: f64,
    worst_at: String,
    failures: Vec<String>,
    hold: Option<Hold>,
}

/// Judges what a check has measured: its name, and the largest error in both its parts, absolute and
/// relative.
pub type Hold = fn(&'static str, [f64; 2]);

impl Check {
    pub fn new(what: &'static str, absolute: f64, relative: f64) -> Check {
        Check {
            what,
            absolute,
            relative,
            compared: 0,
            worst: 0.0,
            worst_at: String::new(),
            failures: Vec::new(),
            hold: None,
        }
    }

    /// Holds the largest error to what `hold` says, besides.
    pub fn held_to(self, hold: Hold) -> Check {
        Check { hold: Some(hold), ..self }
    }

    /// Compares with one cell of a golden.
    pub fn cell(&mut self, row: Row<'_>, column: &str, got: f64) {
        let expected = row.number(column);
        self.value(&format!("{} {column}", row.place()), got, expected);
    }

    pub fn cells<const N: usize>(&mut self, row: Row<'_>, columns: [&str; N], got: [f64; N]) {
        for (column, value) in columns.into_iter().zip(got) {
            self.cell(row, column, value);
        }
    }

    pub fn value(&mut self, place: &str, got: f64, expected: f64) {
        self.compared += 1;
        if got == expected || got.is_nan() && expected.is_nan() {
            return;
        }
        let error = (got - expected).abs() / (self.absolute + self.relative * expected.abs());
        if error > self.worst {
            self.worst = error;
            self.worst_at = place.to_string();
        }
        // written so that NaN fails too
        if error.is_nan() || error > 1.0 {
            self.failures.push(format!("{place}: got {got}, expected {expected}"));
        }
    }

    /// As [`finish`](Check::finish), and fails too if less than half of the allowance was needed.
    pub fn tight(self, expected: usize) {
        let (what, worst) = (self.what, self.worst);
        if self.failures.is_empty() {
            assert!(
                worst >= 0.5,
                "{what}: the allowance is {:.1} times what is needed; lower it",
                1.0 / worst
            );
        }
        self.finish(expected);
    }

    /// As [`tight`](Check::tight), of as many numbers as there were.
    pub fn tight_over_all(self) {
        self.tight_over_more_than(0);
    }

    pub fn tight_over_more_than(self, least: usize) {
        let compared = self.compared;
        assert!(compared > least, "{}: {compared} numbers compared", self.what);
        self.tight(compared);
    }

    /// Fails unless exactly `expected` numbers were compared and all were near enough.
    pub fn finish(self, expected: usize) {
        println!(
            "{}: {} numbers, worst {:.3} of the allowed error at {}",
            self.what, self.compared, self.worst, self.worst_at
        );
        let shown: Vec<&str> = self.failures.iter().take(20).map(String::as_str).collect();
        assert!(
            self.failures.is_empty(),
            "{}: {} of {} numbers are off:\n{}",
            self.what,
            self.failures.len(),
            self.compared,
            shown.join("\n")
        );
        assert_eq!(self.compared, expected, "{}: numbers compared", self.what);
        if let Some(hold) = self.hold {
            hold(self.what, [self.absolute, self.relative].map(|allowed| self.worst * allowed));
        }
    }
}
