//! The starting point of Newton's method: a polynomial that estimates the curve from the responses asked for.
//!
//! Replacing a spectrum s by 1 - s changes the sign of both its responses u and its numbers q, so the
//! polynomial is odd: even terms are zero and are not stored. It is a polynomial in v = u / m, where
//! m = sqrt(1 + mean u^2), and its value is multiplied by m, since towards black and white q grows in
//! proportion to u.

use crate::upsample::rsqrt::rsqrt;
use crate::upsample::tables::{START_CUBIC, START_LINEAR, START_QUINTIC};

/// Polynomials that give the solver of [`Sigmoid`](crate::upsample::Sigmoid) its starting point.
///
/// There are [`LinearStart`], [`CubicStart`] (the default) and [`QuinticStart`]. One of higher degree takes
/// more bytes and saves steps. The spectrum is the same to within rounding. Choose one by the last type
/// parameter of [`Sigmoid`](crate::upsample::Sigmoid); see its [example](crate::upsample::Sigmoid::new).
pub trait StartMap: Copy + core::fmt::Debug + Default + 'static + Start {
    /// How many bytes the constants of the polynomial take.
    ///
    /// ```
    /// use nanospectra::upsample::{CubicStart, LinearStart, QuinticStart, StartMap};
    /// assert_eq!([LinearStart::BYTES, CubicStart::BYTES, QuinticStart::BYTES], [36, 156, 408]);
    /// ```
    const BYTES: usize;
}

/// The starting point that a linear map computes, for programs that have to be small.
///
/// # Cost
/// It takes 36 bytes. At N = 31 a color takes 5700 instructions on a Cortex-M4F in the mean, and 9300 at
/// most.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LinearStart;

/// The starting point that a cubic polynomial computes, which is the default.
///
/// # Cost
/// It takes 156 bytes. At N = 31 a color takes 4500 instructions on a Cortex-M4F in the mean, and 7900 at
/// most.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CubicStart;

/// The starting point that a polynomial of the fifth degree computes, which saves steps and so is the fastest
/// on x86-64 for one color at a time.
///
/// # Cost
/// It takes 408 bytes. At N = 31 a color takes 4600 instructions on a Cortex-M4F in the mean, and 7200 at
/// most.
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

/// Computes the polynomial of a [`StartMap`].
pub trait Start {
    #[doc(hidden)]
    fn start(u: [f32; 3]) -> [f32; 3];
}

impl Start for LinearStart {
    #[inline(always)]
    fn start(u: [f32; 3]) -> [f32; 3] {
        // For degree 1 dividing by m and multiplying by m cancel.
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

/// Returns the mean, and the differences of the outer two from the middle one.
#[inline(always)]
fn coordinates([u0, u1, u2]: [f32; 3]) -> [f32; 3] {
    [(u0 + u1 + u2) * (1.0 / 3.0), u0 - u1, u2 - u1]
}

/// Returns the coordinates of u / m, and m.
#[inline(always)]
fn normal(u: [f32; 3]) -> ([f32; 3], f32) {
    let [u0, u1, u2] = u;
    let square = (u0 * u0 + u1 * u1 + u2 * u2) * (1.0 / 3.0) + 1.0;
    let per_m = rsqrt(square);
    (coordinates(u).map(|v| v * per_m), square * per_m)
}

/// Returns the ten products of three of the coordinates.
#[inline(always)]
fn cubes([a, b, c]: [f32; 3]) -> [f32; 10] {
    let (aa, ab, ac, bb, bc, cc) = (a * a, a * b, a * c, b * b, b * c, c * c);
    [a * aa, a * ab, a * ac, a * bb, a * bc, a * cc, b * bb, b * bc, b * cc, c * cc]
}

/// Returns the 21 products of five of the coordinates.
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

/// Returns the value of the polynomial, times m.
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
