//! The reciprocal square root, from which the sigmoid is computed, in f32 and integer arithmetic alone.

/// Returns 1 / sqrt(h) for 1 <= h < 1e37, within 5e-7, for the inside of the solver.
///
/// The bits and a magic number give an estimate, and two steps of Newton's method follow, with constants that
/// spread their error evenly.
///
/// # Reference
/// L. Moroz et al., "Fast calculation of inverse square root with the use of magic constant", 2018.
#[inline(always)]
pub(super) fn rsqrt_near(h: f32) -> f32 {
    let y = first_step(h);
    y * (1.500_000_4 - 0.5 * h * y * y)
}

/// Returns 1 / sqrt(h) within 7e-4.
#[inline(always)]
fn first_step(h: f32) -> f32 {
    let y = f32::from_bits(0x5f20_0000_u32.wrapping_sub(h.to_bits() >> 1));
    y * (1.681_913_9 - 0.703_952 * h * y * y)
}

/// Returns 1 / sqrt(h) for 1e-30 < h < 1e37, within 1.1e-7, and exactly 1 for 1. It takes one step as above
/// and one of the third order.
#[inline(always)]
pub(super) fn rsqrt(h: f32) -> f32 {
    let y = first_step(h);
    let e = 1.0 - h * y * y;
    y + y * e * (0.5 + 0.375 * e)
}

/// Returns sigma^-1 (a), which is the p whose sigmoid is a, for 0 < a < 1.
#[inline(always)]
pub(super) fn unsigmoid(a: f32) -> f32 {
    (a - 0.5) * rsqrt(a * (1.0 - a))
}
