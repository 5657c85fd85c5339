//! For WebAssembly without vectors: eight named scalars, in one function for every N.
//!
//! Where the compiler knows the number of bands it unrolls the sum and loads all of the spectrum first, more than there
//! are registers: 81 bands to XYZ took 1.55 times a plain loop, and now take as long as one (V8). One function for
//! every N is also less to load for a page.

use super::reduce;

/// All rows against one spectrum, one row after the other.
#[inline]
pub(crate) fn rows<const C: usize, const N: usize>(rows: &[[f32; N]; C], s: &[f32; N]) -> [f32; C] {
    let mut sums = [0.0; C];
    for (sum, row) in sums.iter_mut().zip(rows) {
        *sum = dot(row, s);
    }
    sums
}

#[inline(never)]
fn dot(a: &[f32], b: &[f32]) -> f32 {
    let (mut s0, mut s1, mut s2, mut s3) = (0.0f32, 0.0f32, 0.0f32, 0.0f32);
    let (mut s4, mut s5, mut s6, mut s7) = (0.0f32, 0.0f32, 0.0f32, 0.0f32);
    // Not to be unrolled for the only N of a module either.
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
    reduce(&lanes)
}
