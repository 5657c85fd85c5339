//! What the crate's sums are held against: explicit vectors of the `wide` crate, the plain loop, the pairwise
//! sum, and the most that one core multiplies and adds.

use std::hint::black_box;
use wide::{f32x4, f32x8};

/// One pass over three rows with explicit vectors.
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

/// One product after the other.
pub fn naive<const N: usize>(row: &[f32; N], s: &[f32; N]) -> f32 {
    row.iter().zip(s).map(|(w, s)| w * s).sum()
}

/// Halves of halves, down to eight products: the most exact of the three.
pub fn pairwise(row: &[f32], s: &[f32]) -> f32 {
    if row.len() <= 8 {
        return row.iter().zip(s).map(|(w, s)| w * s).sum();
    }
    let ((row, row_rest), (s, s_rest)) = (row.split_at(row.len() / 2), s.split_at(s.len() / 2));
    pairwise(row, s) + pairwise(row_rest, s_rest)
}

/// The sum of the same products, rounded nowhere (a product of two f32 is exact in f64).
pub fn exact(row: &[f32], s: &[f32]) -> f64 {
    row.iter().zip(s).map(|(w, s)| f64::from(*w) * f64::from(*s)).sum()
}

/// Multiplications and additions (at least `count`) of full vectors that wait for nothing but registers,
/// twelve chains of them. Not fused: the crate never fuses, because not every target can.
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
