//! The black bodies that color rendering is judged against, as sums of a few spectra. They are Chebyshev
//! series in the reciprocal temperature, one for each of two parts of the range 200 to 1000 mired (5000 to
//! 1000 K).
//!
//! What an eye sees of such a sum is the same sum of what it sees of the few spectra, which the compiler
//! computes. With nine terms beyond the first the error is 3e-7 of the largest of X, Y and Z.

use crate::locus::bose;
use crate::table::Table;
use std::fmt::Write as _;

/// The number of terms of a series.
const TERMS: usize = 10;
/// The middle and the half width of both parts, in mired, with room for rounding at the red end.
const HALVES: [(f64, f64); 2] = [(350.0, 150.0), (750.5, 250.5)];
const C2: f64 = 1.4388e7;

/// The Rust source of `HALVES` and `BLACK_BODIES: [[[f64; 471]; TERMS]; 2]`, of lights that have Y = 100.
pub fn source(cmf: &Table) -> String {
    let mut text = format!(
        "const TERMS: usize = {TERMS};\n/// The middle and the half width of both parts, in mired.\n\
         const HALVES: [(f32, f32); 2] = {HALVES:?};\n\
         static BLACK_BODIES: [[[f64; {}]; TERMS]; 2] = [\n",
        cmf.wavelengths.len()
    );
    for (middle, half) in HALVES {
        // The series is exact at the zeros of the next Chebyshev polynomial.
        let places = core::array::from_fn::<f64, TERMS, _>(|k| cos((k as f64 + 0.5) / TERMS as f64));
        let lights = places.map(|place| black_body(middle + half * place, cmf));
        text += "    [\n";
        for n in 0..TERMS {
            let share = if n == 0 { 1.0 } else { 2.0 } / TERMS as f64;
            let term = |nm: usize| -> f64 {
                places
                    .iter()
                    .zip(&lights)
                    .map(|(place, light)| share * chebyshev(n, *place) * light[nm])
                    .sum()
            };
            let row: Vec<String> = (0..cmf.wavelengths.len()).map(|nm| format!("{:e}", term(nm))).collect();
            let _ = writeln!(text, "        [{}],", row.join(", "));
        }
        text += "    ],\n";
    }
    text + "];\n"
}

/// The spectrum at `mired`, with Y = 100.
fn black_body(mired: f64, cmf: &Table) -> Vec<f64> {
    let light: Vec<f64> = cmf
        .wavelengths
        .iter()
        .map(|nm| {
            let (ratio, a) = (560.0 / f64::from(*nm), C2 * 1e-6 / f64::from(*nm));
            ratio * ratio * ratio * ratio * ratio * bose(a * mired).0 / a
        })
        .collect();
    let y: f64 = light.iter().zip(&cmf.columns[1]).map(|(light, y)| light * y).sum();
    light.iter().map(|value| value * 100.0 / y).collect()
}

/// The Chebyshev polynomial cos(n arccos x).
fn chebyshev(n: usize, x: f64) -> f64 {
    let (mut this, mut next) = (1.0, x);
    for _ in 0..n {
        (this, next) = (next, 2.0 * x * next - this);
    }
    this
}

/// The cosine of `halves` half turns, 0 to 1, by its series.
fn cos(halves: f64) -> f64 {
    let angle = std::f64::consts::PI * halves;
    (1..=20).rev().map(f64::from).fold(1.0, |sum, n| 1.0 - angle * angle / (2.0 * n * (2.0 * n - 1.0)) * sum)
}
