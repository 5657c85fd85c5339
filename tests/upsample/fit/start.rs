//! Start maps: the odd polynomials that lead from u, what is asked, to q, the curve that has it, with the
//! least that is then still missing in u, over the 17^3 cube of encoded sRGB under D65.

use super::{eye, white};
use model::linear::{self, Matrix3, apply, inverse, product};
use model::rgb::{RgbSpace, named};

/// A solved color: what was asked, its curve, and how u moves with q there.
pub struct Solved {
    pub u: [f64; 3],
    q: [f64; 3],
    slope: Matrix3,
}

/// Every color of the cube that has a curve of its own, brought to scale 1.
pub fn solved(responses: Matrix3) -> Vec<Solved> {
    let eye = eye();
    let white = white(&eye);
    let [x, y, z] = white;
    let space = RgbSpace { white: [x / (x + y + z), y / (x + y + z)], ..*named("sRGB") };
    // Rows of the mixtures, each 1 for white.
    let mixtures = responses.map(|row| {
        let sum: f64 = row.iter().zip(white).map(|(r, w)| r * w).sum();
        row.map(|r| r / sum)
    });
    let weights: Vec<[f64; 3]> =
        (0..81).map(|k| apply(mixtures, [eye[0][k], eye[1][k], eye[2][k]])).collect();
    let of_rgb = product(mixtures, space.rgb_to_xyz());
    let level = |k: usize| {
        let code = k as f64 / 16.0;
        if code <= 0.04045 { code / 12.92 } else { ((code + 0.055) / 1.055).powf(2.4) }
    };
    let mut all = Vec::new();
    for index in 0..17usize.pow(3) {
        let rgb = [index / 289, index / 17 % 17, index % 17].map(level);
        if rgb[0] == rgb[1] && rgb[1] == rgb[2] {
            continue;
        }
        let a = apply(of_rgb, full_scale(rgb));
        let u = a.map(unsigmoid);
        let (q, slope) = solve(&weights, u);
        all.push(Solved { u, q, slope });
    }
    all
}

/// Dark colors enlarged to a largest component of 1/2, bright ones turned over and enlarged.
fn full_scale(rgb: [f64; 3]) -> [f64; 3] {
    let largest = rgb.into_iter().fold(0.0, f64::max);
    let smallest = rgb.into_iter().fold(1.0, f64::min);
    if largest < 0.5 {
        rgb.map(|c| c / (2.0 * largest))
    } else if smallest > 0.5 {
        rgb.map(|c| (1.0 - c) / (2.0 * (1.0 - smallest)))
    } else {
        rgb
    }
}

fn unsigmoid(a: f64) -> f64 {
    (a - 0.5) / (a * (1.0 - a)).sqrt()
}

/// u of a curve, and its derivatives by q.
fn responses(weights: &[[f64; 3]], q: [f64; 3]) -> ([f64; 3], Matrix3) {
    let (mut a, mut slope) = ([0.0; 3], [[0.0; 3]; 3]);
    for (k, weights) in weights.iter().enumerate() {
        let x = (380.0 + 5.0 * k as f64 - 580.0) / 200.0;
        let p = (q[0] * x + q[1]) * x + q[2];
        let h = 1.0f64.hypot(p);
        let tail = 0.5 / (h * (h + p.abs()));
        let s = if p < 0.0 { tail } else { 1.0 - tail };
        for (k, weight) in weights.iter().enumerate() {
            a[k] += weight * s;
            for (c, power) in [x * x, x, 1.0].into_iter().enumerate() {
                slope[k][c] += weight * 0.5 / (h * h * h) * power;
            }
        }
    }
    for (a, slope) in a.iter().zip(&mut slope) {
        let per_a = 0.25 * (a * (1.0 - a)).powf(-1.5);
        *slope = slope.map(|s| s * per_a);
    }
    (a.map(unsigmoid), slope)
}

/// Newton's method, halving a step until it helps.
fn solve(weights: &[[f64; 3]], u: [f64; 3]) -> ([f64; 3], Matrix3) {
    let mut q = [0.0, 0.0, (u[0] + u[1] + u[2]) / 3.0];
    let miss = |q: [f64; 3]| {
        let (now, slope) = responses(weights, q);
        let off = [u[0] - now[0], u[1] - now[1], u[2] - now[2]];
        (off, off.iter().map(|o| o * o).sum::<f64>(), slope)
    };
    let (mut off, mut size, mut slope) = miss(q);
    for _ in 0..200 {
        if size < 1e-20 {
            break;
        }
        let step = apply(inverse(slope), off);
        let mut part = 1.0;
        loop {
            let next = [0, 1, 2].map(|c| q[c] + part * step[c]);
            let (next_off, next_size, next_slope) = miss(next);
            if next_size < size || part < 1e-9 {
                (q, off, size, slope) = (next, next_off, next_size, next_slope);
                break;
            }
            part *= 0.5;
        }
    }
    assert!(size < 1e-14, "{u:?} is not solved: {size}");
    (q, slope)
}

/// x^2, x and 1 for each monomial, in the order of `monomials`; weighted least squares, twelve times, each
/// time with more weight on what was missed by more.
pub fn fit(solved: &[Solved], degree: u32) -> Vec<[f64; 3]> {
    let monomials = monomials(degree);
    let count = monomials.len();
    let rows: Vec<(Vec<f64>, f64)> = solved.iter().map(|s| features(s.u, &monomials)).collect();
    let mut weights = vec![1.0; solved.len()];
    let mut map = vec![[0.0; 3]; count];
    for _ in 0..12 {
        let (mut normal, mut right) = (vec![vec![0.0; 3 * count]; 3 * count], vec![vec![0.0]; 3 * count]);
        for ((s, (features, m)), weight) in solved.iter().zip(&rows).zip(&weights) {
            let metric = [0, 1, 2].map(|i| {
                [0, 1, 2].map(|j| weight * (0..3).map(|k| s.slope[k][i] * s.slope[k][j]).sum::<f64>())
            });
            let goal = apply(metric, s.q.map(|q| q / m));
            for (f, one) in features.iter().enumerate() {
                for i in 0..3 {
                    right[3 * f + i][0] += one * goal[i];
                    for (g, other) in features.iter().enumerate() {
                        for j in 0..3 {
                            normal[3 * f + i][3 * g + j] += one * other * metric[i][j];
                        }
                    }
                }
            }
        }
        let flat = linear::solve(normal, right);
        map = (0..count).map(|f| [0, 1, 2].map(|i| flat[3 * f + i][0])).collect();
        let missed: Vec<f64> =
            solved.iter().zip(&rows).map(|(s, (features, m))| missed(s, features, *m, &map)).collect();
        let mean = missed.iter().sum::<f64>() / missed.len() as f64;
        for (weight, missed) in weights.iter_mut().zip(&missed) {
            *weight *= (missed / mean).sqrt();
        }
        let mean = weights.iter().sum::<f64>() / weights.len() as f64;
        weights.iter_mut().for_each(|weight| *weight /= mean);
    }
    map
}

/// Where a map starts for u.
pub fn start(u: [f64; 3], degree: u32, map: &[[f64; 3]]) -> [f64; 3] {
    let (features, m) = features(u, &monomials(degree));
    [0, 1, 2].map(|c| m * features.iter().zip(map).map(|(f, row)| f * row[c]).sum::<f64>())
}

/// How much of u / m is missing where a map starts.
fn missed(s: &Solved, features: &[f64], m: f64, map: &[[f64; 3]]) -> f64 {
    let off =
        [0, 1, 2].map(|c| features.iter().zip(map).map(|(f, row)| f * row[c]).sum::<f64>() - s.q[c] / m);
    apply(s.slope, off).iter().map(|o| o * o).sum::<f64>().sqrt()
}

/// Powers of the three coordinates, odd in all, by falling power of the first and then of the second.
fn monomials(degree: u32) -> Vec<[i32; 3]> {
    let mut all = Vec::new();
    for d in (1..=degree as i32).step_by(2) {
        for i in (0..=d).rev() {
            for j in (0..=d - i).rev() {
                all.push([i, j, d - i - j]);
            }
        }
    }
    all
}

fn features(u: [f64; 3], monomials: &[[i32; 3]]) -> (Vec<f64>, f64) {
    let m = (1.0 + u.iter().map(|u| u * u).sum::<f64>() / 3.0).sqrt();
    let v = u.map(|u| u / m);
    let (a, b, c) = ((v[0] + v[1] + v[2]) / 3.0, v[0] - v[1], v[2] - v[1]);
    (monomials.iter().map(|[i, j, k]| a.powi(*i) * b.powi(*j) * c.powi(*k)).collect(), m)
}
