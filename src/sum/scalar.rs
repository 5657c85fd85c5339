//! The sums for processors without vectors, in eight named scalars.
//!
//! The scalars stay in registers, where an array of lanes would go through memory: 16 bands to XYZ take 253
//! instructions in this way and 742 with an array, on a Cortex-M4F at opt-level "s".

use crate::sum::reduce;

/// All rows against one spectrum, one row after the other.
#[inline]
pub(crate) fn rows<const C: usize, const N: usize>(rows: &[[f32; N]; C], s: &[f32; N]) -> [f32; C] {
    let mut sums = [0.0; C];
    for (sum, row) in sums.iter_mut().zip(rows) {
        *sum = dot(row, s);
    }
    sums
}

#[inline]
fn dot<const N: usize>(a: &[f32; N], b: &[f32; N]) -> f32 {
    let (mut s0, mut s1, mut s2, mut s3) = (0.0f32, 0.0f32, 0.0f32, 0.0f32);
    let (mut s4, mut s5, mut s6, mut s7) = (0.0f32, 0.0f32, 0.0f32, 0.0f32);
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
    // The rest is added to the first lanes, again by name: a loop over them would put all eight into memory
    // (for 31 bands at "s" it takes 626 instructions, and this takes 398).
    macro_rules! rest {
        ($($lane:ident $k:literal),*) => {
            $(if let (Some(a), Some(b)) = (a_rest.get($k), b_rest.get($k)) {
                $lane += a * b;
            })*
        };
    }
    rest!(s0 0, s1 1, s2 2, s3 3, s4 4, s5 5, s6 6);
    reduce(&[s0, s1, s2, s3, s4, s5, s6, s7])
}
