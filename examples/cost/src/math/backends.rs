//! All backends of the crate, and what is said of their errors.

use crate::report::Cell;
pub use nanospectra::math::Math;

/// The rows that `$of` gives for every backend and its name.
macro_rules! of_each {
    ($of:ident $(, $argument:expr)*) => {
        [
            $of::<nanospectra::math::Portable>("Portable" $(, $argument)*),
            $of::<nanospectra::math::Fast>("Fast" $(, $argument)*),
            $of::<nanospectra::math::Libm>("Libm" $(, $argument)*),
            $of::<nanospectra::math::Micromath>("Micromath" $(, $argument)*),
            $of::<nanospectra::math::Std>("Std" $(, $argument)*),
        ]
        .into_iter()
        .flatten()
        .collect()
    };
}
pub(crate) use of_each;

/// A largest error. Other platforms have another `Std`, with other last bits: of that two digits, rounded up.
pub fn error_of(backend: &str, error: f64) -> Cell {
    if backend != "Std" || error <= 0.0 {
        return Cell::figure(error);
    }
    let second_digit = 10f64.powf(error.log10().floor() - 1.0);
    // (What is two digits already stays, whatever the power is off by.)
    Cell::figure((error / second_digit - 1e-9).ceil() * second_digit)
}
