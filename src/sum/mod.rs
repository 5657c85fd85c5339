//! The inner product of a spectrum and the rows of an observer.
//!
//! It has eight partial sums, which are added up in one fixed order. This is eight times more accurate than a
//! plain loop, and the result has the same bits on every target, because the order is written here and not
//! left to the compiler or to the width of its vectors. For the same reason multiplication and addition are
//! rounded separately (there is no fused multiply-add).
//!
//! There are five ways to do the same additions: `scalar` for processors without vectors and for programs of
//! x86-64 that must not use them, as those for UEFI; `x86` with the vectors of x86-64; `vector` on other
//! targets with the crate `wide`; and without that crate `wasm` for WebAssembly and `lanes` where the
//! compiler vectorizes.

#[cfg(not(any(feature = "simd", target_arch = "x86_64", target_arch = "wasm32", target_os = "none")))]
mod lanes;
#[cfg(any(target_os = "none", all(target_arch = "x86_64", not(target_feature = "sse2"))))]
mod scalar;
#[cfg(all(feature = "simd", not(target_arch = "x86_64"), not(target_os = "none")))]
mod vector;
#[cfg(all(not(feature = "simd"), target_arch = "wasm32", not(target_os = "none")))]
mod wasm;
#[cfg(all(target_arch = "x86_64", target_feature = "sse2", not(target_os = "none")))]
mod x86;

#[cfg(not(any(feature = "simd", target_arch = "x86_64", target_arch = "wasm32", target_os = "none")))]
pub(crate) use lanes::rows;
#[cfg(any(target_os = "none", all(target_arch = "x86_64", not(target_feature = "sse2"))))]
pub(crate) use scalar::rows;
#[cfg(all(feature = "simd", not(target_arch = "x86_64"), not(target_os = "none")))]
pub(crate) use vector::rows;
#[cfg(all(not(feature = "simd"), target_arch = "wasm32", not(target_os = "none")))]
pub(crate) use wasm::rows;
#[cfg(all(target_arch = "x86_64", target_feature = "avx", not(target_os = "none")))]
pub(crate) use x86::each;
#[cfg(all(target_arch = "x86_64", target_feature = "sse2", not(target_os = "none")))]
pub(crate) use x86::rows;

/// Sums for every spectrum of a batch, one by one. As many are read as the shorter of the two slices has.
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

/// The sum of 8 lanes, in the order in which a vector of 128 or 256 bits is added up by halves.
#[inline]
fn reduce(s: &[f32; 8]) -> f32 {
    ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]))
}

/// The sum of `a[k]`, in the same lanes and order as that of the products.
pub(crate) fn sum(a: &[f32]) -> f32 {
    let mut lanes = [0.0f32; 8];
    for chunk in a.chunks(8) {
        for (lane, value) in lanes.iter_mut().zip(chunk) {
            *lane += value;
        }
    }
    reduce(&lanes)
}
