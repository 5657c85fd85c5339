//! The inner product that everything ends in.
//!
//! Eight partial sums and one fixed order of adding them up: eight times more accurate than a
//! plain loop, and the same bits on every target, because the order is written here and not
//! left to the compiler or to the width of its vectors. Multiplication and addition are rounded
//! apart (no fused multiply-add), for the same reason.
//!
//! Three ways to do the same additions: `scalar` for cores without vectors, `lanes` for what the
//! compiler vectorises, `vector` with the `wide` crate.

#[cfg(all(not(feature = "simd"), not(target_os = "none")))]
mod lanes;
#[cfg(target_os = "none")]
mod scalar;
#[cfg(all(feature = "simd", not(target_os = "none")))]
mod vector;

#[cfg(all(not(feature = "simd"), not(target_os = "none")))]
pub(crate) use lanes::rows;
#[cfg(target_os = "none")]
pub(crate) use scalar::rows;
#[cfg(all(feature = "simd", not(target_os = "none")))]
pub(crate) use vector::rows;

/// What 8 lanes come to; the order in which a 128- or 256-bit vector folds in half.
#[inline]
fn reduce(s: &[f32; 8]) -> f32 {
    ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]))
}

/// The sum of `a[k]`, in the same lanes and order as the products.
pub(crate) fn sum(a: &[f32]) -> f32 {
    let mut lanes = [0.0f32; 8];
    for chunk in a.chunks(8) {
        for (lane, value) in lanes.iter_mut().zip(chunk) {
            *lane += value;
        }
    }
    reduce(&lanes)
}
