//! The sums for WebAssembly, in eight named scalars or, with simd128, in two vectors. One function serves
//! every N.
//!
//! If the compiler knows the number of bands, it unrolls the sum and loads all of the spectrum first, which
//! is more than there are registers. Without vectors that is slower than a plain loop, and this function is
//! as fast as a plain loop (`node examples/web/bench.mjs`). One function for every N is also less for a page
//! to load. With vectors the feature `simd`, which sums all rows in one pass, is faster and larger.
//!
//! The loop is that of `scalar`. The rest after whole eights is added in a loop here, where bytes count, and
//! by name in `scalar`, where a loop costs instructions.

/// All rows against one spectrum, one row after the other.
#[inline]
pub(crate) fn rows<const C: usize, const N: usize>(rows: &[[f32; N]; C], s: &[f32; N]) -> [f32; C] {
    let mut sums = [0.0; C];
    for (sum, row) in sums.iter_mut().zip(rows) {
        *sum = dot(row, s);
    }
    sums
}

#[cfg(target_feature = "simd128")]
#[inline(never)]
fn dot(a: &[f32], b: &[f32]) -> f32 {
    use core::arch::wasm32::{f32x4, f32x4_add, f32x4_extract_lane, f32x4_mul, f32x4_splat};
    let halves = |[s0, s1, s2, s3, s4, s5, s6, s7]: [f32; 8]| [f32x4(s0, s1, s2, s3), f32x4(s4, s5, s6, s7)];
    let [mut low, mut high] = [f32x4_splat(0.0); 2];
    let (a8, a_rest) = a.as_chunks();
    let (b8, b_rest) = b.as_chunks();
    for (a, b) in a8.iter().zip(b8) {
        let ([a_low, a_high], [b_low, b_high]) = (halves(*a), halves(*b));
        low = f32x4_add(low, f32x4_mul(a_low, b_low));
        high = f32x4_add(high, f32x4_mul(a_high, b_high));
    }
    // Adding zero does not change a sum.
    let mut rest = [0.0; 8];
    for (product, (a, b)) in rest.iter_mut().zip(a_rest.iter().zip(b_rest)) {
        *product = a * b;
    }
    let [rest_low, rest_high] = halves(rest);
    // This is the order of `reduce`.
    let sums = f32x4_add(f32x4_add(low, rest_low), f32x4_add(high, rest_high));
    (f32x4_extract_lane::<0>(sums) + f32x4_extract_lane::<2>(sums))
        + (f32x4_extract_lane::<1>(sums) + f32x4_extract_lane::<3>(sums))
}

#[cfg(not(target_feature = "simd128"))]
#[inline(never)]
fn dot(a: &[f32], b: &[f32]) -> f32 {
    let (mut s0, mut s1, mut s2, mut s3) = (0.0f32, 0.0f32, 0.0f32, 0.0f32);
    let (mut s4, mut s5, mut s6, mut s7) = (0.0f32, 0.0f32, 0.0f32, 0.0f32);
    // This keeps the compiler from unrolling the loop in a module that has one N only.
    let a = a.get(..core::hint::black_box(a.len())).unwrap_or(a);
    let (a8, a_rest) = a.as_chunks::<8>();
    let (b8, b_rest) = b.as_chunks::<8>();
    for (a, b) in a8.iter().zip(b8) {
        s0 += a[0] * b[0];
        s1 += a[1] * b[1];
        s2 += a[2] * b[2];
        s3 += a[3] * b[3];
        s4 += a[4] * b[4];
        s5 += a[5] * b[5];
        s6 += a[6] * b[6];
        s7 += a[7] * b[7];
    }
    let mut lanes = [s0, s1, s2, s3, s4, s5, s6, s7];
    for (lane, (a, b)) in lanes.iter_mut().zip(a_rest.iter().zip(b_rest)) {
        *lane += a * b;
    }
    crate::sum::reduce(&lanes)
}
