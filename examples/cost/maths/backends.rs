//! All backends of the crate. Two of them are behind features there; so that the study needs none, their own sources
//! are read here once more.

use crate::report::Cell;
pub use nanospectra::math::{Fast, Libm, Math, Portable};
use nanospectra::math::{cos_turns, sin_turns};

#[path = "../../../src/math/std.rs"]
mod std_source;

pub use crate::hard_cases::Micromath;
pub use std_source::Std;

/// A largest error. Other platforms have another `Std`, with other last bits: of that two digits, rounded up.
pub fn error_of(backend: &str, error: f64) -> Cell {
    if backend != "Std" || error <= 0.0 {
        return Cell::figure(error);
    }
    let second_digit = 10f64.powf(error.log10().floor() - 1.0);
    // (What is two digits already stays, whatever the power is off by.)
    Cell::figure((error / second_digit - 1e-9).ceil() * second_digit)
}
