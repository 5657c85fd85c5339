//! How far numbers are off from what is right, and in what unit errors are allowed there.

/// The unit of rounding, e in the table: half the distance between 1 and the next f32.
const EPS: f64 = 1.0 / 16_777_216.0;

/// How far numbers are off, given the input and the numbers.
pub type Judge = fn(&[f64], &[f64]) -> Off;

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

/// Nothing but zeros is right.
pub fn zero(_: &[f64], got: &[f64]) -> Off {
    absolute(got, &vec![0.0; got.len()])
}
