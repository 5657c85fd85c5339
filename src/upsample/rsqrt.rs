//! The reciprocal square root in f32 and integer arithmetic alone: what the sigmoid is made of.

/// 1 / sqrt(h) for 1 <= h < 1e37, within 5e-7: from the bits by a magic number, then two steps of Newton's
/// method with constants that spread their error. For the inside of the solver.
///
/// # Reference
/// L. Moroz et al., "Fast calculation of inverse square root with the use of magic constant", 2018.
#[inline(always)]
pub(super) fn rsqrt_near(h: f32) -> f32 {
    let y = first_step(h);
    y * (1.500_000_4 - 0.5 * h * y * y)
}

/// Within 7e-4.
#[inline(always)]
fn first_step(h: f32) -> f32 {
    let y = f32::from_bits(0x5f20_0000_u32.wrapping_sub(h.to_bits() >> 1));
    y * (1.681_913_9 - 0.703_952 * h * y * y)
}

/// 1 / sqrt(h) for 1e-30 < h < 1e37, within 1.1e-7, and exactly 1 for 1: one step as above and one of the
/// third order.
#[inline(always)]
pub(super) fn rsqrt(h: f32) -> f32 {
    let y = first_step(h);
    let e = 1.0 - h * y * y;
    y + y * e * (0.5 + 0.375 * e)
}

/// sigma^-1: p of a share 0 < a < 1.
#[inline(always)]
pub(super) fn unsigmoid(a: f32) -> f32 {
    (a - 0.5) * rsqrt(a * (1.0 - a))
}
