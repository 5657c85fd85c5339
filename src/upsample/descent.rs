//! The method of Levenberg and Marquardt, which finds the curve of a color where Newton's method does not.
//!
//! It compares colors in Lab, turned and scaled so that differences in lightness, chroma and hue count as
//! much as in CIE94. The equations are solved without squaring them, since near the limit of what curves can
//! have their condition is as large as f32 allows.

use crate::color::Lab;
use crate::color::matrix::{Matrix, apply};
use crate::math::{cbrt, sqrt};
use crate::upsample::newton::sums;
use crate::upsample::seen::{Eye, lab};

/// The largest number of steps.
const STEPS: usize = 60;
/// A color that is nearer than this has been found.
const ENOUGH: f32 = 2e-5;
/// The three numbers of a curve stay below this, beyond which f32 would lose digits of the quadratic.
const LARGEST: f32 = 1e5;
/// The values of the quadratic at these x (450, 540 and 610 nm) measure how long a step is.
const AT: Matrix = [[0.4225, -0.65, 1.0], [0.04, -0.2, 1.0], [0.0225, 0.15, 1.0]];

/// Returns the curve that is found for X, Y and Z, which are 1 for white, from the curve `start`. It has the
/// color or comes near it. Both colors are multiplied by `exposure` before they are compared.
#[inline(never)]
pub(super) fn descend<const N: usize>(
    eye: &Eye<'_, N>,
    asked: [f32; 3],
    exposure: f32,
    start: [f32; 3],
) -> [f32; 3] {
    let goal = Goal::new(asked.map(|share| exposure * share));
    let missing = |q| goal.missing(eye.sees(q).map(|share| exposure * share));
    let mut q = start;
    let (mut left, mut slopes) = missing(q);
    let mut damping = 1.0;
    for _ in 0..STEPS {
        if square(left) < ENOUGH * ENOUGH {
            break;
        }
        // The sums are twice the derivatives of the responses.
        let by_q = sums(eye.rows, q).map(|[_, a, b, c]| [0.5 * a, 0.5 * b, 0.5 * c]);
        let by_q = product(&slopes, &product(&scaled(&eye.to_xyz, exposure), &by_q));
        let length = 1.0 + sqrt(square(apply(&AT, q)));
        // The slopes and `left` stay as they are while steps fail, so only the damping changes.
        loop {
            let step = solved(&by_q, left, &scaled(&AT, damping / length));
            let trial = [q[0] + step[0], q[1] + step[1], q[2] + step[2]];
            let (left_there, slopes_there) = missing(trial);
            let possible = square(trial) < LARGEST * LARGEST;
            if possible && square(left_there) < square(left) {
                (q, left, slopes) = (trial, left_there, slopes_there);
                damping = (0.4 * damping).max(1e-6);
                break;
            }
            damping *= 2.0;
            if damping > 1e3 {
                return q;
            }
        }
    }
    q
}

/// Lab of a color, with its direction from gray and the weights of CIE94.
struct Goal {
    lab: [f32; 3],
    /// The cosine and the sine of the hue, divided by the weight of chroma and by that of hue.
    along: [f32; 2],
    across: [f32; 2],
}

impl Goal {
    fn new(xyz: [f32; 3]) -> Self {
        let Lab { l, a, b } = lab(xyz);
        let chroma = sqrt(a * a + b * b);
        let (cos, sin) = if chroma > 0.0 { (a / chroma, b / chroma) } else { (1.0, 0.0) };
        let (c, h) = (1.0 / (1.0 + 0.045 * chroma), 1.0 / (1.0 + 0.015 * chroma));
        Goal { lab: [l, a, b], along: [cos * c, sin * c], across: [cos * h, sin * h] }
    }

    /// Returns the weighted differences of another color in lightness, along the direction from gray and
    /// across it, and their derivatives by X, Y and Z.
    fn missing(&self, xyz: [f32; 3]) -> ([f32; 3], Matrix) {
        let Lab { l, a, b } = lab(xyz);
        // The derivatives of the three compressed ratios.
        let [dx, dy, dz] = xyz.map(|share| {
            let root = cbrt(share.max(216.0 / 24389.0));
            1.0 / (3.0 * root * root)
        });
        let (a, b) = (a - self.lab[1], b - self.lab[2]);
        let ([cc, sc], [ch, sh]) = (self.along, self.across);
        let left = [l - self.lab[0], cc * a + sc * b, ch * b - sh * a];
        let row = |by_a: f32, by_b: f32| {
            [500.0 * by_a * dx, (200.0 * by_b - 500.0 * by_a) * dy, -200.0 * by_b * dz]
        };
        (left, [[0.0, 116.0 * dy, 0.0], row(cc, sc), row(-sh, ch)])
    }
}

fn square([a, b, c]: [f32; 3]) -> f32 {
    a * a + b * b + c * c
}

fn scaled(m: &Matrix, k: f32) -> Matrix {
    m.map(|row| row.map(|value| k * value))
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let columns = transposed(b);
    a.map(|[x, y, z]| columns.map(|[u, v, w]| x * u + y * v + z * w))
}

fn transposed([[a, b, c], [d, e, f], [g, h, i]]: &Matrix) -> Matrix {
    [[*a, *d, *g], [*b, *e, *h], [*c, *f, *i]]
}

/// Returns the step that makes the squares of `left + a step` and `damping step` least, by the method of Gram
/// and Schmidt.
fn solved(a: &Matrix, left: [f32; 3], damping: &Matrix) -> [f32; 3] {
    let ([a0, a1, a2], [d0, d1, d2]) = (transposed(a), transposed(damping));
    let column = |[a, b, c]: [f32; 3], [d, e, f]: [f32; 3]| [a, b, c, d, e, f];
    let (c0, mut c1, mut c2) = (column(a0, d0), column(a1, d1), column(a2, d2));
    let mut y = [-left[0], -left[1], -left[2], 0.0, 0.0, 0.0];
    let (u, r00) = direction(&c0);
    let (r01, r02, y0) = (reduce(&u, &mut c1), reduce(&u, &mut c2), reduce(&u, &mut y));
    let (u, r11) = direction(&c1);
    let (r12, y1) = (reduce(&u, &mut c2), reduce(&u, &mut y));
    let (u, r22) = direction(&c2);
    let y2 = reduce(&u, &mut y);
    let s2 = y2 / r22;
    let s1 = (y1 - r12 * s2) / r11;
    [(y0 - r01 * s1 - r02 * s2) / r00, s1, s2]
}

/// Returns a column with length 1, and its length before.
fn direction(column: &[f32; 6]) -> ([f32; 6], f32) {
    let length = sqrt(column.iter().map(|v| v * v).sum());
    (column.map(|v| v / length), length)
}

/// Takes from a column what lies along `u`, and returns how much that was.
fn reduce(u: &[f32; 6], column: &mut [f32; 6]) -> f32 {
    let along: f32 = u.iter().zip(column.iter()).map(|(u, c)| u * c).sum();
    for (c, u) in column.iter_mut().zip(u) {
        *c -= along * u;
    }
    along
}
