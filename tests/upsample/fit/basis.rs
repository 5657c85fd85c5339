//! The basis: of all triples of spectra on 380, 385, .. 780 nm that sum to 1, stay above 0.012, and have the
//! colors of the sRGB primaries under D65, the one whose neighboring values differ least (in squares, over
//! the three).
//!
//! An interior point method: the barrier keeps off the bounds and is lowered until it does not matter.

use super::{eye, white};
use model::linear;
use model::rgb::{RgbSpace, named};

const N: usize = 81;
const LEAST: f64 = 0.012;

/// Red and green; blue is what they leave of 1.
pub fn fit() -> Vec<[f64; 2]> {
    let eye = eye();
    let [x, y, z] = white(&eye);
    let space = RgbSpace { white: [x / (x + y + z), y / (x + y + z)], ..*named("sRGB") };
    let primaries = space.rgb_to_xyz();
    let (mut v, mut barrier) = (vec![1.0 / 3.0; 2 * N], 1.0);
    for _ in 0..200 {
        let step = newton(&v, barrier, &eye, primaries);
        // As far as nineteen twentieths of the way to the next bound.
        let mut part = 1.0f64;
        for n in 0..N {
            let (r, g) = (step[n], step[N + n]);
            for (room, change) in
                [(v[n] - LEAST, r), (v[N + n] - LEAST, g), (1.0 - v[n] - v[N + n] - LEAST, -r - g)]
            {
                if change < 0.0 {
                    part = part.min(0.95 * room / -change);
                }
            }
        }
        v.iter_mut().zip(&step).for_each(|(v, s)| *v += part * s);
        let size = step.iter().fold(0.0, |most: f64, s| most.max(s.abs()));
        if part > 0.5 && size < 1e-3 {
            barrier *= 0.2;
        }
        if barrier < 1e-12 {
            break;
        }
    }
    (0..N).map(|n| [v[n], v[N + n]]).collect()
}

/// The step of Newton's method under the six conditions on XYZ.
fn newton(v: &[f64], barrier: f64, eye: &[Vec<f64>; 3], primaries: [[f64; 3]; 3]) -> Vec<f64> {
    let size = 2 * N + 6;
    let (mut a, mut right) = (vec![vec![0.0; size]; size], vec![vec![0.0]; size]);
    // Squares of differences of red, of green, and of red + green, which are those of blue.
    for n in 1..N {
        for (one, other, weight) in [(0, 0, 2.0), (N, N, 2.0), (0, N, 1.0), (N, 0, 1.0)] {
            for (i, j, sign) in [(n, n, 1.0), (n - 1, n - 1, 1.0), (n, n - 1, -1.0), (n - 1, n, -1.0)] {
                a[one + i][other + j] += weight * sign;
                right[one + i][0] -= weight * sign * v[other + j];
            }
        }
    }
    for n in 0..N {
        let room = [v[n] - LEAST, v[N + n] - LEAST, 1.0 - v[n] - v[N + n] - LEAST];
        let [r, g, b] = room.map(|room| barrier / (room * room));
        a[n][n] += r + b;
        a[N + n][N + n] += g + b;
        a[n][N + n] += b;
        a[N + n][n] += b;
        right[n][0] += barrier / room[0] - barrier / room[2];
        right[N + n][0] += barrier / room[1] - barrier / room[2];
    }
    for (k, offset) in [(0, 0), (1, N)] {
        for c in 0..3 {
            let row = 2 * N + 3 * k + c;
            right[row][0] = primaries[c][k];
            for n in 0..N {
                a[row][offset + n] = eye[c][n];
                a[offset + n][row] = eye[c][n];
                right[row][0] -= eye[c][n] * v[offset + n];
            }
        }
    }
    linear::solve(a, right).into_iter().take(2 * N).map(|row| row[0]).collect()
}
