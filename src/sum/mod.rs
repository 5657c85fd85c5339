//! The inner product that everything ends in.
//!
//! Eight partial sums and one fixed order of adding them up: eight times more accurate than a
//! plain loop, and the same bits on every target, because the order is written here and not
//! left to the compiler or to the width of its vectors. Multiplication and addition are rounded
//! apart (no fused multiply-add), for the same reason.
//!
//! Five ways to do the same additions: `scalar` for cores without vectors, `x86` with the vectors of x86-64,
//! elsewhere `vector` with the `wide` crate, and without it `wasm` for WebAssembly or `lanes` for what the
//! compiler vectorizes.

#[cfg(not(any(feature = "simd", target_arch = "x86_64", target_arch = "wasm32", target_os = "none")))]
mod lanes;
#[cfg(target_os = "none")]
mod scalar;
#[cfg(all(feature = "simd", not(target_arch = "x86_64"), not(target_os = "none")))]
mod vector;
#[cfg(all(not(feature = "simd"), target_arch = "wasm32", not(target_os = "none")))]
mod wasm;
#[cfg(all(target_arch = "x86_64", not(target_os = "none")))]
mod x86;

#[cfg(not(any(feature = "simd", target_arch = "x86_64", target_arch = "wasm32", target_os = "none")))]
pub(crate) use lanes::rows;
#[cfg(target_os = "none")]
pub(crate) use scalar::rows;
#[cfg(all(feature = "simd", not(target_arch = "x86_64"), not(target_os = "none")))]
pub(crate) use vector::rows;
#[cfg(all(not(feature = "simd"), target_arch = "wasm32", not(target_os = "none")))]
pub(crate) use wasm::rows;
#[cfg(all(target_arch = "x86_64", target_feature = "avx", not(target_os = "none")))]
pub(crate) use x86::each;
#[cfg(all(target_arch = "x86_64", not(target_os = "none")))]
pub(crate) use x86::rows;

/// Every spectrum of a batch, one by one; the shorter of the two slices says how many.
#[cfg(any(not(all(target_arch = "x86_64", target_feature = "avx")), target_os = "none"))]
#[inline]
pub(crate) fn each<T, const C: usize, const N: usize>(
    rows: &[[f32; N]; C],
    spectra: &[T],
    values: impl Fn(&T) -> &[f32; N],
    reports: &mut [[f32; C]],
) {
    for (spectrum, report) in spectra.iter().zip(reports) {
        *report = self::rows(rows, values(spectrum));
    }
}

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
