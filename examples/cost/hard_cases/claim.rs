//! What the table says of a row before it is computed, and how errors are measured.

use super::Error;

/// The unit of rounding, e in the table: half the distance between 1 and the next f32.
pub const EPS: f64 = 1.0 / 16_777_216.0;

#[derive(PartialEq)]
pub enum Naive {
    Fails,
    Holds,
}

/// A row.
pub struct Claim {
    pub row: &'static str,
    pub what: &'static str,
    pub inputs: &'static str,
    /// How errors are measured.
    pub measured: &'static str,
    /// What ours may be off by: so many of the judge's units, and what they are called.
    pub limit: f64,
    pub unit: &'static str,
    /// What was asked for, where that is less.
    pub asked: &'static str,
    pub naive: Naive,
    pub test: &'static str,
    /// How far numbers are off at an input.
    pub judge: fn(&[f64], &[f64]) -> Off,
}

/// An error, and the unit in which errors are allowed there.
#[derive(Clone, Copy)]
pub struct Off {
    pub error: f64,
    pub unit: f64,
}

impl Off {
    /// Allowed as many times as much.
    pub fn per(self, k: f64) -> Off {
        Off { unit: self.unit * k, ..self }
    }
}

impl Claim {
    pub fn tolerance(&self) -> String {
        match (self.limit, self.unit) {
            (limit, "") if limit > 0.0 && limit < 0.01 => format!("{limit:e}"),
            (limit, "") => format!("{limit}"),
            (1.0, unit) => unit.to_string(),
            (limit, unit) => format!("{limit} {unit}"),
        }
    }

    /// Adds the error of these numbers.
    pub fn add(&self, all: &mut Error, at: &[f32], got: &[f32]) {
        if got.is_empty() {
            // A device has not said yet.
            all.nan += 1;
            return;
        }
        let wide = |numbers: &[f32]| numbers.iter().map(|x| f64::from(*x)).collect::<Vec<_>>();
        let off = (self.judge)(&wide(at), &wide(got));
        if off.error.is_nan() {
            all.nan += 1;
        } else if off.error.is_infinite() {
            all.infinite += 1;
        } else {
            all.size = all.size.max(off.error);
            let allowed = self.limit * off.unit;
            all.share = all.share.max(if off.error == 0.0 { 0.0 } else { off.error / allowed });
        }
    }
}

/// The largest, or NaN if one is.
fn largest(errors: impl Iterator<Item = f64>) -> f64 {
    errors.fold(0.0, |most, error| if error.is_nan() || error > most { error } else { most })
}

/// Relative errors, allowed in units of rounding.
pub fn relative(got: &[f64], exact: &[f64]) -> Off {
    let error =
        |(got, exact): (&f64, &f64)| if got == exact { 0.0 } else { (got - exact).abs() / exact.abs() };
    Off { error: largest(got.iter().zip(exact).map(error)), unit: EPS }
}

/// Relative errors, allowed as they are.
pub fn share(got: &[f64], exact: &[f64]) -> Off {
    Off { unit: 1.0, ..relative(got, exact) }
}

/// Absolute errors.
pub fn absolute(got: &[f64], exact: &[f64]) -> Off {
    let error = |(got, exact): (&f64, &f64)| if got == exact { 0.0 } else { (got - exact).abs() };
    Off { error: largest(got.iter().zip(exact).map(error)), unit: 1.0 }
}

/// A relative error in units of rounding.
pub fn in_eps(got: f64, exact: f64) -> Off {
    Off { error: (got - exact).abs() / (exact.abs() * EPS), unit: 1.0 }
}
