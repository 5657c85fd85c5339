//! Least squares without squaring the condition: the triangular factor R of A = Q R, by Householder
//! reflections.

use crate::math::const_for;
use crate::sensor::calibrate::vector::{dot, hypot, norm, subtract, unit};

/// A least squares problem of `C` unknowns and `D` right-hand sides that is fed row by row. It takes memory
/// of C (C + D) whatever the number of rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Triangle<const C: usize, const D: usize> {
    /// Row k of R; zero left of the diagonal, the diagonal not negative.
    r: [[f32; C]; C],
    /// The rows of Q' B that belong to them.
    b: [[f32; D]; C],
    /// What is left of each right-hand side, whatever the unknowns, as the root of its sum of squares.
    rest: [f32; D],
}

impl<const C: usize, const D: usize> Triangle<C, D> {
    /// Starts without rows.
    pub(super) const fn new() -> Self {
        Triangle { r: [[0.0; C]; C], b: [[0.0; D]; C], rest: [0.0; D] }
    }

    /// Starts with the rows `diagonal` times the unit matrix, and the right-hand side `b`.
    pub(super) const fn ridge(diagonal: f32, b: [[f32; D]; C]) -> Self {
        let mut start = Triangle { r: [[0.0; C]; C], b, rest: [0.0; D] };
        const_for!(0..C, |k| start.r[k][k] = diagonal);
        start
    }

    /// Adds one more equation, `row` times the unknowns = `b`. For each unknown a reflection of two rows
    /// makes the new one zero there.
    pub(super) const fn absorb(&mut self, mut row: [f32; C], mut b: [f32; D]) {
        const_for!(0..C, |k| {
            let norm = hypot(self.r[k][k], row[k]);
            // (NaN is not 0 and spreads.)
            if row[k] != 0.0 {
                let (c, s) = (self.r[k][k] / norm, row[k] / norm);
                self.r[k][k] = norm;
                const_for!(k + 1..C, |j| {
                    let (upper, lower) = (self.r[k][j], row[j]);
                    self.r[k][j] = c * upper + s * lower;
                    row[j] = s * upper - c * lower;
                });
                const_for!(0..D, |d| {
                    let (upper, lower) = (self.b[k][d], b[d]);
                    self.b[k][d] = c * upper + s * lower;
                    b[d] = s * upper - c * lower;
                });
            }
        });
        const_for!(0..D, |d| self.rest[d] = hypot(self.rest[d], b[d]));
    }

    pub(super) const fn factor(&self) -> &[[f32; C]; C] {
        &self.r
    }

    pub(super) const fn rest(&self) -> &[f32; D] {
        &self.rest
    }

    /// Computes the unknowns for each right-hand side, which are not finite where R has a zero on its
    /// diagonal.
    pub(super) const fn solve(&self) -> [[f32; C]; D] {
        let mut x = [[0.0; C]; D];
        const_for!(0..D, |d| {
            const_for!(0..C, |k| x[d][k] = self.b[k][d]);
            x[d] = back(&self.r, x[d]);
        });
        x
    }
}

/// Solves R x = b.
pub(super) const fn back<const C: usize>(r: &[[f32; C]; C], mut x: [f32; C]) -> [f32; C] {
    let mut left = C;
    while left > 0 {
        left -= 1;
        const_for!(left + 1..C, |j| x[left] -= r[left][j] * x[j]);
        x[left] /= r[left][left];
    }
    x
}

/// Solves R' x = b.
pub(super) const fn forward<const C: usize>(r: &[[f32; C]; C], mut x: [f32; C]) -> [f32; C] {
    const_for!(0..C, |k| {
        x[k] /= r[k][k];
        const_for!(k + 1..C, |j| x[j] -= r[k][j] * x[k]);
    });
    x
}

/// Computes A (I d^2 + A' A)^-1 of `N` x `C` numbers in the place of A, whose columns are given, and returns
/// the factor R of [d I; A].
///
/// With [d I; A] = [Q2; Q1] R this is Q1 R'^-1, which has the condition of A and not its square.
pub(super) const fn damped_inverse<const C: usize, const N: usize>(
    a: &mut [[f32; N]; C],
    d: f32,
) -> [[f32; C]; C] {
    let (mut r, mut tau) = ([[0.0; C]; C], [0.0; C]);
    const_for!(0..C, |k| {
        // The reflection is 1 - tau v v' with v = 1 in row k of the upper block, and a[k] / (d + norm) in the
        // lower.
        let norm = hypot(d, norm(&a[k]));
        r[k][k] = -norm;
        if norm != 0.0 {
            tau[k] = (d + norm) / norm;
            const_for!(0..N, |n| a[k][n] /= d + norm);
        }
        const_for!(k + 1..C, |j| {
            let step = tau[k] * dot(&a[k], &a[j]);
            r[k][j] = -step;
            const_for!(0..N, |n| a[j][n] -= step * a[k][n]);
        });
    });
    // Q1 comes from the reflections, the last one first, of the first C columns of the unit matrix. Column j
    // meets those up to j, so that it can take the place of the last of them.
    let mut j = C;
    while j > 0 {
        j -= 1;
        const_for!(0..N, |n| a[j][n] = 0.0 - tau[j] * a[j][n]);
        let mut left = j;
        while left > 0 {
            left -= 1;
            let step = tau[left] * dot(&a[left], &a[j]);
            const_for!(0..N, |n| a[j][n] -= step * a[left][n]);
        }
    }
    // X R' = Q1 is solved from the last column to the first.
    let mut left = C;
    while left > 0 {
        left -= 1;
        const_for!(left + 1..C, |j| {
            const_for!(0..N, |n| a[left][n] -= r[left][j] * a[j][n]);
        });
        const_for!(0..N, |n| a[left][n] /= r[left][left]);
    }
    r
}

/// Computes the largest over the smallest singular value of R, whose columns are scaled to equal size first.
/// It is infinite for a column of zeros. Power iterations make it rarely more than a few per cent too small.
pub(super) const fn condition<const C: usize>(r: &[[f32; C]; C]) -> f32 {
    let mut scaled = *r;
    let mut j = 0;
    while j < C {
        let mut column = [0.0; C];
        const_for!(0..C, |k| column[k] = r[k][j]);
        let norm = norm(&column);
        const_for!(0..C, |k| scaled[k][j] /= norm);
        if norm == 0.0 || scaled[j][j] == 0.0 {
            return f32::INFINITY;
        }
        j += 1;
    }
    // Start vectors, one smooth and one alternating, neither of them symmetric.
    let (mut wide, mut narrow) = ([1.0; C], [1.0; C]);
    const_for!(0..C, |j| {
        wide[j] += 0.1 * j as f32;
        narrow[j] = if j % 2 == 0 { wide[j] } else { -1.0 };
    });
    let (mut largest, mut inverse_of_smallest) = (1.0, 1.0);
    const_for!(0..12, |turn| {
        // Multiplies by R' R, and by its inverse, each in two halves that stay in range.
        wide = unit(times(&scaled, wide)).0;
        (wide, largest) = unit(times_transposed(&scaled, wide));
        narrow = unit(forward(&scaled, narrow)).0;
        (narrow, inverse_of_smallest) = unit(back(&scaled, narrow));
    });
    largest * inverse_of_smallest
}

const fn times<const C: usize>(r: &[[f32; C]; C], x: [f32; C]) -> [f32; C] {
    let mut y = [0.0; C];
    const_for!(0..C, |k| y[k] = dot(&r[k], &x));
    y
}

const fn times_transposed<const C: usize>(r: &[[f32; C]; C], x: [f32; C]) -> [f32; C] {
    let mut y = [0.0; C];
    const_for!(0..C, |k| subtract(&mut y, -x[k], &r[k]));
    y
}
