//! The `micromath` crate as a backend, to compare with: it is small and well known.

use crate::math::Math;
use micromath::F32Ext;

/// Takes every function from the crate `micromath`, whose approximations are too coarse for color.
///
/// Use this backend to see what the others gain. It needs the feature `micromath`.
///
/// # Example
/// ```
/// use nanospectra::math::{Math, Micromath};
///
/// let root = Micromath::sqrt(0.5);
/// assert!((root / 0.5f32.sqrt() - 1.0).abs() < 0.062);
/// ```
///
/// # Accuracy
/// exp is off by 2.4e-3, ln by 0.12, the square root by 6.1 %, the cube root by 3.9 %, and powf by 5 % in
/// sRGB (twelve 8-bit codes) and by 69 % at worst.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Micromath;

impl Math for Micromath {
    fn sqrt(x: f32) -> f32 {
        F32Ext::sqrt(x)
    }
    fn cbrt(x: f32) -> f32 {
        let size = F32Ext::powf(F32Ext::abs(x), 1.0 / 3.0);
        if x < 0.0 { -size } else { size }
    }
    fn exp(x: f32) -> f32 {
        F32Ext::exp(x)
    }
    fn expm1(x: f32) -> f32 {
        F32Ext::exp(x) - 1.0
    }
    fn ln(x: f32) -> f32 {
        F32Ext::ln(x)
    }
    fn powf(x: f32, y: f32) -> f32 {
        F32Ext::powf(x, y)
    }
    fn atan2(y: f32, x: f32) -> f32 {
        F32Ext::atan2(y, x)
    }
    fn cos_turns(turns: f32) -> f32 {
        F32Ext::cos(turns * core::f32::consts::TAU)
    }
    fn sin_turns(turns: f32) -> f32 {
        F32Ext::sin(turns * core::f32::consts::TAU)
    }
}
