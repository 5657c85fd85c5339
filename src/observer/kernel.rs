//! The inner product that everything ends in.
//!
//! Eight partial sums and one fixed order of adding them up: eight times more accurate than a
//! plain loop, and the same bits on every target, because the order is written here and not
//! left to the compiler or to the width of its vectors. Multiplication and addition are rounded
//! apart (no fused multiply-add), for the same reason.

/// What 8 lanes come to; the order in which a 128- or 256-bit vector folds in half.
#[inline]
fn reduce(s: [f32; 8]) -> f32 {
    ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]))
}

/// The sum of `a[k] * b[k]`.
///
/// Eight named scalars rather than an array: LLVM shuffles lane arrays of several rows into each
/// other (54 ns where these take 27, at N = 81). Out of line on hosts, where one row at a time
/// vectorises best; inlined on bare metal, where the call costs more.
#[cfg_attr(target_os = "none", inline)]
#[cfg_attr(not(target_os = "none"), inline(never))]
pub(crate) fn dot(a: &[f32], b: &[f32]) -> f32 {
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
    let mut lanes = [s0, s1, s2, s3, s4, s5, s6, s7];
    for (lane, (a, b)) in lanes.iter_mut().zip(a_rest.iter().zip(b_rest)) {
        *lane += a * b;
    }
    reduce(lanes)
}

/// The sum of `a[k]`, in the same lanes and order as [`dot`].
pub(crate) fn sum(a: &[f32]) -> f32 {
    let mut lanes = [0.0f32; 8];
    for chunk in a.chunks(8) {
        for (lane, value) in lanes.iter_mut().zip(chunk) {
            *lane += value;
        }
    }
    reduce(lanes)
}

/// All rows against one spectrum: one row after the other.
#[cfg(not(feature = "simd"))]
#[inline]
pub(crate) fn rows<const C: usize, const N: usize>(rows: &[[f32; N]; C], s: &[f32; N]) -> [f32; C] {
    let mut sums = [0.0; C];
    for (sum, row) in sums.iter_mut().zip(rows) {
        *sum = dot(row, s);
    }
    sums
}

/// All rows against one spectrum, in one pass with explicit vectors: each lane does what a named
/// scalar of [`dot`] does, so the bits are the same.
#[cfg(feature = "simd")]
#[inline]
pub(crate) fn rows<const C: usize, const N: usize>(rows: &[[f32; N]; C], s: &[f32; N]) -> [f32; C] {
    use wide::f32x8;
    let mut lanes = [f32x8::ZERO; C];
    let (s8, s_rest) = s.as_chunks::<8>();
    for (k, s) in s8.iter().enumerate() {
        let s = f32x8::new(*s);
        for (lane, row) in lanes.iter_mut().zip(rows) {
            let (row8, _) = row.as_chunks::<8>();
            if let Some(row) = row8.get(k) {
                *lane += f32x8::new(*row) * s;
            }
        }
    }
    let mut sums = [0.0; C];
    for (sum, (lane, row)) in sums.iter_mut().zip(lanes.iter().zip(rows)) {
        let mut lanes = lane.to_array();
        let (_, row_rest) = row.as_chunks::<8>();
        for (lane, (a, b)) in lanes.iter_mut().zip(row_rest.iter().zip(s_rest)) {
            *lane += a * b;
        }
        *sum = reduce(lanes);
    }
    sums
}
