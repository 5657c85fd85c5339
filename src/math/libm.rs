//! Backends on the `libm` crate: [`Portable`], the default, and [`Libm`], the reference.

use crate::math::{Math, cbrt, sqrt};

/// The default backend: the same bits on every target, and no soft f64 on a core that has an
/// FPU for f32 only.
///
/// `libm` where it computes in f32 (exp, expm1, ln, pow, atan2), own kernels elsewhere.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Portable;

/// Every function from `libm`, the reference to compare with: sine, cosine and cube root run
/// in f64 there, which takes from 1620 (cube root) to 2090 (sine) instructions on a Cortex-M4F.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Libm;

impl Math for Portable {
    fn sqrt(x: f32) -> f32 {
        sqrt(x)
    }
    fn cbrt(x: f32) -> f32 {
        cbrt(x)
    }
    fn exp(x: f32) -> f32 {
        libm::expf(x)
    }
    fn expm1(x: f32) -> f32 {
        libm::expm1f(x)
    }
    fn ln(x: f32) -> f32 {
        libm::logf(x)
    }
    fn powf(x: f32, y: f32) -> f32 {
        libm::powf(x, y)
    }
    fn atan2(y: f32, x: f32) -> f32 {
        libm::atan2f(y, x)
    }
    fn cos_turns(turns: f32) -> f32 {
        crate::math::turns::cos(turns)
    }
    fn sin_turns(turns: f32) -> f32 {
        crate::math::turns::sin(turns)
    }
}

impl Math for Libm {
    fn sqrt(x: f32) -> f32 {
        libm::sqrtf(x)
    }
    fn cbrt(x: f32) -> f32 {
        libm::cbrtf(x)
    }
    fn exp(x: f32) -> f32 {
        libm::expf(x)
    }
    fn expm1(x: f32) -> f32 {
        libm::expm1f(x)
    }
    fn ln(x: f32) -> f32 {
        libm::logf(x)
    }
    fn powf(x: f32, y: f32) -> f32 {
        libm::powf(x, y)
    }
    fn atan2(y: f32, x: f32) -> f32 {
        libm::atan2f(y, x)
    }
    fn cos_turns(turns: f32) -> f32 {
        libm::cosf(core::f32::consts::TAU * turns)
    }
    fn sin_turns(turns: f32) -> f32 {
        libm::sinf(core::f32::consts::TAU * turns)
    }
}
