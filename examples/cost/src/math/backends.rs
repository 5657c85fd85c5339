//! The list of all backends of the crate, and how their errors are reported.

use crate::report::Cell;
pub use nanospectra::math::Math;

/// Collects the rows that `$of` gives for every backend and its name.
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

/// Returns the cell of a largest error, which is rounded up to two digits, so that no error is larger than
/// what is said. (`Std` differs in the last bits from platform to platform anyway.)
pub fn error_of(error: f64) -> Cell {
    if error <= 0.0 || !error.is_finite() {
        return Cell::figure(error);
    }
    let second_digit = 10f64.powf(error.log10().floor() - 1.0);
    // A number that has two digits already stays the same, even if the power of ten is not exact.
    Cell::figure((error / second_digit - 1e-9).ceil() * second_digit)
}
