//! The length of a vector whose squares may be out of the range of f32.

use crate::math::sqrt;

const TWO_TO_100: f32 = 1.267_650_6e30;

/// Returns the root of the sum of squares, which is infinite only if it is itself beyond f32.
#[inline]
pub(crate) fn length<const N: usize>(parts: [f32; N]) -> f32 {
    let squares = squares(&parts, 1.0);
    if squares > 1e-30 && squares < 1e37 { sqrt(squares) } else { far_length(&parts, squares) }
}

#[cold]
fn far_length<const N: usize>(parts: &[f32; N], rough: f32) -> f32 {
    // A power of two costs no digits.
    let small = rough < 1.0;
    let scale = if small { TWO_TO_100 } else { 1.0 / TWO_TO_100 };
    let back = if small { 1.0 / TWO_TO_100 } else { TWO_TO_100 };
    sqrt(squares(parts, scale)) * back
}

#[inline]
fn squares<const N: usize>(parts: &[f32; N], scale: f32) -> f32 {
    parts.iter().fold(0.0, |sum, part| sum + (part * scale) * (part * scale))
}
