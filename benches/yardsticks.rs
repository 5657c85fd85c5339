//! What the sums of nanospectra are compared with: explicit vectors of the crate `wide`, a plain loop, a
//! pairwise sum, the exact sum, and the most that one core can multiply and add.

use std::hint::black_box;
use wide::{f32x4, f32x8};

/// Computes three sums of products in one pass, with explicit vectors.
pub fn wide_one_pass<const N: usize>(rows: &[[f32; N]; 3], s: &[f32; N]) -> [f32; 3] {
    let (mut x, mut y, mut z) = (f32x8::ZERO, f32x8::ZERO, f32x8::ZERO);
    let mut k = 0;
    while k + 8 <= N {
        let at = |row: &[f32; N]| f32x8::from(<[f32; 8]>::try_from(&row[k..k + 8]).expect("eight"));
        let power = at(s);
        x += at(&rows[0]) * power;
        y += at(&rows[1]) * power;
        z += at(&rows[2]) * power;
        k += 8;
    }
    let mut sums = [x.reduce_add(), y.reduce_add(), z.reduce_add()];
    while k < N {
        for (sum, row) in sums.iter_mut().zip(rows) {
            *sum += row[k] * s[k];
        }
        k += 1;
    }
    sums
}

/// Adds one product after the other.
pub fn naive<const N: usize>(row: &[f32; N], s: &[f32; N]) -> f32 {
    row.iter().zip(s).map(|(w, s)| w * s).sum()
}

/// Adds the sums of both halves, each computed in the same way, down to eight products. It is the most exact
/// of the three.
pub fn pairwise(row: &[f32], s: &[f32]) -> f32 {
    if row.len() <= 8 {
        return row.iter().zip(s).map(|(w, s)| w * s).sum();
    }
    let ((row, row_rest), (s, s_rest)) = (row.split_at(row.len() / 2), s.split_at(s.len() / 2));
    pairwise(row, s) + pairwise(row_rest, s_rest)
}

/// Computes the sum of the products in f64, in which a product of two f32 is exact.
pub fn exact(row: &[f32], s: &[f32]) -> f64 {
    row.iter().zip(s).map(|(w, s)| f64::from(*w) * f64::from(*s)).sum()
}

/// Does at least `count` multiplications and additions on full vectors, in twelve chains that stay in
/// registers, so that neither memory nor latency slows them down. They are not fused, because nanospectra
/// never fuses: not every target could do the same.
#[inline(never)]
pub fn multiply_and_add(count: usize) {
    macro_rules! chains {
        ($vector:ident of $lanes:literal) => {{
            let (m, c) = (black_box($vector::splat(0.9999)), black_box($vector::splat(1e-4)));
            let mut chains = [$vector::ONE; 12];
            for _ in 0..count.div_ceil(12 * $lanes) {
                chains = chains.map(|x| x * m + c);
            }
            black_box(chains);
        }};
    }
    if cfg!(target_feature = "avx") { chains!(f32x8 of 8) } else { chains!(f32x4 of 4) }
}
