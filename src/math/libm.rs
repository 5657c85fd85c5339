//! The backends that use the `libm` crate: [`Portable`], which is the default, and [`Libm`], the reference.

use crate::math::{Math, cbrt, sqrt};

/// Computes all functions in f32, with the same bits on every target; this is the default backend.
///
/// It takes exp, expm1, ln, pow and atan2 from the crate `libm`, which computes them in f32, and the other
/// functions from kernels of this crate. Therefore it needs no emulated f64 on a processor whose FPU has f32
/// only.
///
/// # Example
/// ```
/// use nanospectra::math::{Math, Portable};
///
/// assert!((Portable::exp(1.0) - core::f32::consts::E).abs() < 3e-7);
/// assert!((Portable::powf(2.0, 0.5) - core::f32::consts::SQRT_2).abs() < 2e-7);
/// assert_eq!(Portable::atan2(1.0, 0.0), core::f32::consts::FRAC_PI_2);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Portable;

/// Takes every function from the crate `libm`, as a reference to compare other backends with.
///
/// Sine, cosine and the cube root are computed in f64 there, which takes from 1620 (cube root) to 2090 (sine)
/// instructions on a Cortex-M4F. See the [example](Portable#example) of `Portable`.
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
