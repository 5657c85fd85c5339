//! The functions that measure errors: how far results are from the right ones, and in which unit the limit of
//! the row is given.

/// The unit of rounding, e in the table: half the distance between 1 and the next f32.
const EPS: f64 = 1.0 / 16_777_216.0;

/// A function that gets the input and the results of a row and returns their error.
pub type Judge = fn(&[f64], &[f64]) -> Off;

/// An error, and the unit in which the limit of the row is given.
#[derive(Clone, Copy)]
pub struct Off {
    pub error: f64,
    pub unit: f64,
}

impl Off {
    /// Allows `k` times as much.
    pub fn per(self, k: f64) -> Off {
        Off { unit: self.unit * k, ..self }
    }
}

/// Returns the largest error, or NaN if one of them is NaN.
fn largest(errors: impl Iterator<Item = f64>) -> f64 {
    errors.fold(0.0, |most, error| if error.is_nan() || error > most { error } else { most })
}

/// Returns the largest relative error, whose limit is given in units of rounding.
pub fn relative(got: &[f64], exact: &[f64]) -> Off {
    let error =
        |(got, exact): (&f64, &f64)| if got == exact { 0.0 } else { (got - exact).abs() / exact.abs() };
    Off { error: largest(got.iter().zip(exact).map(error)), unit: EPS }
}

/// Returns the largest relative error, whose limit is a plain number.
pub fn share(got: &[f64], exact: &[f64]) -> Off {
    Off { unit: 1.0, ..relative(got, exact) }
}

/// Returns the largest absolute error.
pub fn absolute(got: &[f64], exact: &[f64]) -> Off {
    let error = |(got, exact): (&f64, &f64)| if got == exact { 0.0 } else { (got - exact).abs() };
    Off { error: largest(got.iter().zip(exact).map(error)), unit: 1.0 }
}

/// Returns a relative error in units of rounding.
pub fn in_eps(got: f64, exact: f64) -> Off {
    Off { error: (got - exact).abs() / (exact.abs() * EPS), unit: 1.0 }
}

/// Returns the largest result where only zeros are right.
pub fn zero(_: &[f64], got: &[f64]) -> Off {
    absolute(got, &vec![0.0; got.len()])
}
