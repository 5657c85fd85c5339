//! Sums over vectors in `const fn`. Squares are scaled by the largest, so that counts of 1e-30 are as good as
//! counts of 1.

use crate::math::const_for;

pub(super) use crate::math::sqrt_by_digits as sqrt;

/// Scales a vector to length 1, and returns the length it had.
pub(super) const fn unit<const C: usize>(mut x: [f32; C]) -> ([f32; C], f32) {
    let norm = norm(&x);
    const_for!(0..C, |k| x[k] /= norm);
    (x, norm)
}

/// Subtracts factor b from a.
pub(super) const fn subtract<const N: usize>(a: &mut [f32; N], factor: f32, b: &[f32; N]) {
    const_for!(0..N, |n| a[n] -= factor * b[n]);
}

pub(super) const fn dot<const N: usize>(a: &[f32; N], b: &[f32; N]) -> f32 {
    let mut sum = 0.0;
    const_for!(0..N, |n| sum += a[n] * b[n]);
    sum
}

/// Returns the largest size, or NaN if there is one.
pub(super) const fn largest<const N: usize>(a: &[f32; N]) -> f32 {
    let (mut largest, mut n) = (0.0, 0);
    while n < N {
        let size = a[n].abs();
        if size > largest || size.is_nan() {
            largest = size;
        }
        if largest.is_nan() {
            return largest;
        }
        n += 1;
    }
    largest
}

/// Computes the root of the sum of squares, without overflow or underflow.
pub(super) const fn norm<const N: usize>(a: &[f32; N]) -> f32 {
    let largest = largest(a);
    if largest == 0.0 {
        return 0.0;
    }
    let mut sum = 0.0;
    const_for!(0..N, |n| {
        let share = a[n] / largest;
        sum += share * share;
    });
    largest * sqrt(sum)
}

/// Computes the same of two numbers.
pub(super) const fn hypot(a: f32, b: f32) -> f32 {
    norm(&[a, b])
}
