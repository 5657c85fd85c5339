//! Where Newton's method starts: an odd polynomial from what is asked to the curve that has it.
//!
//! Turning a spectrum over (s to 1 - s) turns the sign of both sides, so even terms are zero and are not
//! stored. The polynomial is in v = u / m with m = sqrt(1 + mean u^2), and its value is taken times m:
//! towards black and white the curve grows in proportion.

use crate::upsample::rsqrt::rsqrt;
use crate::upsample::tables::{START_CUBIC, START_LINEAR, START_QUINTIC};

/// Which start map: [`LinearStart`], [`CubicStart`] (the default) or [`QuinticStart`]. More bytes, fewer
/// steps; the result is the same to within rounding.
pub trait StartMap: Copy + core::fmt::Debug + Default + 'static + Start {
    /// Bytes of its constants.
    const BYTES: usize;
}

/// 36 bytes; at N = 31 5700 instructions a color on a Cortex-M4F in the mean, 9300 at most.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LinearStart;
/// 156 bytes; 4500 instructions in the mean, 7900 at most.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CubicStart;
/// 408 bytes; 4600 instructions in the mean, 7200 at most; the fastest where sums are slow: on hosts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct QuinticStart;

impl StartMap for LinearStart {
    const BYTES: usize = size_of_val(&START_LINEAR);
}
impl StartMap for CubicStart {
    const BYTES: usize = size_of_val(&START_CUBIC);
}
impl StartMap for QuinticStart {
    const BYTES: usize = size_of_val(&START_QUINTIC);
}

/// The work behind [`StartMap`].
pub trait Start {
    #[doc(hidden)]
    fn start(u: [f32; 3]) -> [f32; 3];
}

impl Start for LinearStart {
    #[inline(always)]
    fn start(u: [f32; 3]) -> [f32; 3] {
        // Of degree 1: no need to divide by m and to multiply by it again.
        sum(&START_LINEAR, &coordinates(u), 1.0)
    }
}

impl Start for CubicStart {
    #[inline(always)]
    fn start(u: [f32; 3]) -> [f32; 3] {
        static MAP: [[f32; 3]; 13] = START_CUBIC;
        let ([a, b, c], m) = normal(u);
        let [k0, k1, k2, k3, k4, k5, k6, k7, k8, k9] = cubes([a, b, c]);
        sum(&MAP, &[a, b, c, k0, k1, k2, k3, k4, k5, k6, k7, k8, k9], m)
    }
}

impl Start for QuinticStart {
    #[inline(always)]
    fn start(u: [f32; 3]) -> [f32; 3] {
        static MAP: [[f32; 3]; 34] = START_QUINTIC;
        let ([a, b, c], m) = normal(u);
        let mut monomials = [0.0; 34];
        let parts = [a, b, c].into_iter().chain(cubes([a, b, c])).chain(fifths([a, b, c]));
        for (slot, monomial) in monomials.iter_mut().zip(parts) {
            *slot = monomial;
        }
        sum(&MAP, &monomials, m)
    }
}

/// The mean, and how the outer two differ from the middle one.
#[inline(always)]
fn coordinates([u0, u1, u2]: [f32; 3]) -> [f32; 3] {
    [(u0 + u1 + u2) * (1.0 / 3.0), u0 - u1, u2 - u1]
}

/// The coordinates of u / m, and m.
#[inline(always)]
fn normal(u: [f32; 3]) -> ([f32; 3], f32) {
    let [u0, u1, u2] = u;
    let square = (u0 * u0 + u1 * u1 + u2 * u2) * (1.0 / 3.0) + 1.0;
    let per_m = rsqrt(square);
    (coordinates(u).map(|v| v * per_m), square * per_m)
}

/// The ten products of three.
#[inline(always)]
fn cubes([a, b, c]: [f32; 3]) -> [f32; 10] {
    let (aa, ab, ac, bb, bc, cc) = (a * a, a * b, a * c, b * b, b * c, c * c);
    [a * aa, a * ab, a * ac, a * bb, a * bc, a * cc, b * bb, b * bc, b * cc, c * cc]
}

/// The 21 products of five.
#[inline(always)]
fn fifths([a, b, c]: [f32; 3]) -> [f32; 21] {
    let (aa, bb, bc, cc) = (a * a, b * b, b * c, c * c);
    let [k0, k1, k2, k3, k4, k5, k6, k7, k8, k9] = cubes([a, b, c]).map(|cube| aa * cube);
    let fourths = [bb * bb, bb * bc, bb * cc, bc * cc, cc * cc];
    let [m0, m1, m2, m3, m4] = fourths.map(|fourth| a * fourth);
    let [n0, n1, n2, n3, n4] = fourths.map(|fourth| b * fourth);
    let last = c * (cc * cc);
    [k0, k1, k2, k3, k4, k5, k6, k7, k8, k9, m0, m1, m2, m3, m4, n0, n1, n2, n3, n4, last]
}

/// The polynomial, times m.
#[inline(always)]
fn sum<const K: usize>(map: &[[f32; 3]; K], monomials: &[f32; K], m: f32) -> [f32; 3] {
    let [mut q0, mut q1, mut q2] = [0.0; 3];
    for ([w0, w1, w2], monomial) in map.iter().zip(monomials) {
        q0 += monomial * w0;
        q1 += monomial * w1;
        q2 += monomial * w2;
    }
    [q0 * m, q1 * m, q2 * m]
}
