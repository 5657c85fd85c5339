//! The 3x3 matrices of this module, which the compiler derives in f64 and which are applied in f32.

use crate::math::const_for;

/// A matrix, row by row, with which the compiler computes.
pub(crate) type Matrix64 = [[f64; 3]; 3];
/// A matrix, row by row, in the precision of run time.
pub(crate) type Matrix = [[f32; 3]; 3];

/// Returns the product a b.
pub(crate) const fn product64(a: &Matrix64, b: &Matrix64) -> Matrix64 {
    let mut out = [[0.0; 3]; 3];
    const_for!(0..3, |i| {
        const_for!(0..3, |j| out[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j]);
    });
    out
}

/// Returns the inverse by cofactors, which is not finite if there is none.
pub(crate) const fn inverse64(m: &Matrix64) -> Matrix64 {
    let [[a, b, c], [d, e, f], [g, h, i]] = *m;
    let det = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
    [
        [(e * i - f * h) / det, (c * h - b * i) / det, (b * f - c * e) / det],
        [(f * g - d * i) / det, (a * i - c * g) / det, (c * d - a * f) / det],
        [(d * h - e * g) / det, (b * g - a * h) / det, (a * e - b * d) / det],
    ]
}

/// Returns the product m v.
pub(crate) const fn apply64(m: &Matrix64, v: [f64; 3]) -> [f64; 3] {
    let [a, b, c] = m;
    let [x, y, z] = v;
    [a[0] * x + a[1] * y + a[2] * z, b[0] * x + b[1] * y + b[2] * z, c[0] * x + c[1] * y + c[2] * z]
}

/// Multiplies column `j` of `m` by `k[j]`, which gives m diag(k).
pub(crate) const fn scale_columns64(m: &Matrix64, k: [f64; 3]) -> Matrix64 {
    let [a, b, c] = *m;
    [
        [a[0] * k[0], a[1] * k[1], a[2] * k[2]],
        [b[0] * k[0], b[1] * k[1], b[2] * k[2]],
        [c[0] * k[0], c[1] * k[1], c[2] * k[2]],
    ]
}

/// Rounds each element to f32.
pub(crate) const fn rounded(m: &Matrix64) -> Matrix {
    let [a, b, c] = *m;
    [
        [a[0] as f32, a[1] as f32, a[2] as f32],
        [b[0] as f32, b[1] as f32, b[2] as f32],
        [c[0] as f32, c[1] as f32, c[2] as f32],
    ]
}

/// Returns the product m v.
pub(crate) const fn apply(m: &Matrix, v: [f32; 3]) -> [f32; 3] {
    let [a, b, c] = m;
    let [x, y, z] = v;
    [a[0] * x + a[1] * y + a[2] * z, b[0] * x + b[1] * y + b[2] * z, c[0] * x + c[1] * y + c[2] * z]
}
