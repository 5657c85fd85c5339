//! The platform's own functions: fast on a host, but not the same bits on every one. (The feature
//! `std` is empty where there is no std.)

use crate::math::{Math, cos_turns, sin_turns};

extern crate std;

/// The standard library's functions (hosts only).
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
