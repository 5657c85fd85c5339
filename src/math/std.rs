//! The functions of the platform's standard library, which are fast but do not have the same bits on every
//! platform. (The feature `std` does nothing on targets that have no standard library.)

use crate::math::{Math, cos_turns, sin_turns};

extern crate std;

/// Takes most functions from the standard library of a host, where they are fast.
///
/// The results do not have the same bits on every host; sine and cosine are those of this crate. This backend
/// needs the feature `std`.
///
/// # Example
/// ```
/// use nanospectra::math::{Math, Std};
///
/// assert_eq!(Std::powf(2.0, 0.5), 2.0f32.powf(0.5));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Std;

impl Math for Std {
    fn sqrt(x: f32) -> f32 {
        f32::sqrt(x)
    }
    fn cbrt(x: f32) -> f32 {
        f32::cbrt(x)
    }
    fn exp(x: f32) -> f32 {
        f32::exp(x)
    }
    fn expm1(x: f32) -> f32 {
        f32::exp_m1(x)
    }
    fn ln(x: f32) -> f32 {
        f32::ln(x)
    }
    fn powf(x: f32, y: f32) -> f32 {
        f32::powf(x, y)
    }
    fn atan2(y: f32, x: f32) -> f32 {
        f32::atan2(y, x)
    }
    fn cos_turns(turns: f32) -> f32 {
        cos_turns(turns)
    }
    fn sin_turns(turns: f32) -> f32 {
        sin_turns(turns)
    }
}
