//! Narrow responses: of all mixtures of the color-matching functions that are nowhere negative, the ones with
//! the least spread about 610, 540 and 450 nm.
//!
//! Scaled to 1 for a white surface under D65, two numbers of a mixture are free, the spread is linear in
//! them, and each wavelength allows a half plane: the least is at a corner, and all corners are tried.

use super::{d65, functions};
use model::linear::Matrix3;

pub fn fit() -> Matrix3 {
    let (functions, light) = (functions(), d65());
    let white = functions.each_ref().map(|row| row.iter().zip(&light).map(|(f, s)| f * s).sum::<f64>());
    // What each wavelength allows: its row times the mixture is not below zero.
    let allowed: Vec<[f64; 3]> =
        (0..471).map(|k| [0, 1, 2].map(|c| functions[c][k] / white[c])).filter(|row| row[1] > 0.0).collect();
    let corners = corners(&allowed);
    let mixtures = [610.0, 540.0, 450.0].map(|center| {
        let spread = [0, 1, 2].map(|c| {
            let terms = functions[c].iter().zip(&light).enumerate();
            terms
                .map(|(k, (f, s))| f * s / white[c] * ((360.0 + k as f64 - center) / 100.0).powi(2))
                .sum::<f64>()
        });
        let of = |t: &[f64; 3]| t[0] * spread[0] + t[1] * spread[1] + t[2] * spread[2];
        *corners.iter().min_by(|a, b| of(a).total_cmp(&of(b))).expect("a corner")
    });
    // To mixtures of x-bar, y-bar, z-bar themselves, white having Y = 1.
    mixtures.map(|t| [0, 1, 2].map(|c| t[c] * white[1] / white[c]))
}

fn corners(allowed: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let mut corners = Vec::new();
    for (i, one) in allowed.iter().enumerate() {
        for other in &allowed[..i] {
            // At a right angle to both, scaled to a sum of 1.
            let [[a, b, c], [d, e, f]] = [*one, *other];
            let across = [b * f - c * e, c * d - a * f, a * e - b * d];
            let corner = across.map(|t| t / across.iter().sum::<f64>());
            let inside = |row: &[f64; 3]| {
                let size: f64 = row.iter().sum();
                row[0] * corner[0] + row[1] * corner[1] + row[2] * corner[2] >= -1e-9 * size
            };
            if corner.iter().all(|c| c.abs() < 10.0) && allowed.iter().all(inside) {
                corners.push(corner);
            }
        }
    }
    corners
}
