//! The Planckian locus as a table of the knots of a cubic Hermite curve in the CIE 1960 plane.
//!
//! The parameter k counts knots. The reciprocal temperature is `FIRST + k (LINEAR + k^2 CUBIC)` mired, which
//! runs from 0.99 to 1000.01 (1 to 1000 with room for rounding). The knots lie closer at the hot end, where
//! the locus bends most: 25 of them are good for 0.009 mired over |Duv| <= 0.05, where 31 equally spaced ones
//! are good for 0.038 mired.
//!
//! Color rendering compares a light with a reference of its temperature, and multiplies an error of the
//! temperature. It has tables of many kilobytes anyway, and takes a locus with twice as many pieces, which is
//! good for 0.0015 mired.

use crate::table::Table;
use std::fmt::Write as _;

pub const KNOTS: u32 = 25;
/// The number of pieces of the finer locus in one piece of the other.
const FINER: u32 = 2;
/// The second radiation constant of the scale of color temperatures (ITS-90), in nm K.
const C2: f64 = 1.4388e7;

/// These numbers are f32, so that they are the same here and where the table is read.
const FIRST: f32 = 0.99;
const LINEAR: f32 = 17.0;
const CUBIC: f32 = 0.042_753_18;

/// The reciprocal temperature in mired at the place `k`, counted in knots, and its derivative by `k`.
fn mired(k: f64) -> (f64, f64) {
    let (first, linear, cubic) = (f64::from(FIRST), f64::from(LINEAR), f64::from(CUBIC));
    (first + k * (linear + cubic * k * k), linear + 3.0 * cubic * k * k)
}

/// The Rust source of `LOCUS` and `FINE_LOCUS`, whose rows are (u, v, du/dk, dv/du).
pub fn source(cmf: &Table) -> String {
    let fine_knots = (KNOTS - 1) * FINER + 1;
    format!(
        "/// The reciprocal temperature at knot k of `LOCUS` is FIRST + k (LINEAR + k^2 CUBIC) mired.\n\
         pub(super) const FIRST: f32 = {FIRST:?};\n\
         pub(super) const LINEAR: f32 = {LINEAR:?};\n\
         pub(super) const CUBIC: f32 = {CUBIC:?};\n\
         /// u, v, du/dk and dv/du at each knot.\n\
         pub(super) static LOCUS: [[f32; 4]; {KNOTS}] = [\n{}];\n\
         /// The same at more knots.\n\
         #[cfg(feature = \"libm\")]\n\
         static FINE_LOCUS: [[f32; 4]; {fine_knots}] = [\n{}];\n",
        rows(1, cmf),
        rows(FINER, cmf)
    )
}

/// The rows of a table that divides each step from knot to knot into `parts`.
fn rows(parts: u32, cmf: &Table) -> String {
    let mut text = String::new();
    for part in 0..=(KNOTS - 1) * parts {
        let (mired, per_knot) = mired(f64::from(part) / f64::from(parts));
        let [u, v, du, dv] = knot(mired, cmf);
        let row = [u, v, du * per_knot / f64::from(parts), dv / du].map(|v| format!("{:?}", v as f32));
        let _ = writeln!(text, "    [{}],", row.join(", "));
    }
    text
}

/// u, v, du/dm and dv/dm of the black body whose reciprocal temperature m is `mired`.
pub fn knot(mired: f64, cmf: &Table) -> [f64; 4] {
    let (mut xyz, mut slope) = ([0.0; 3], [0.0; 3]);
    for (row, nm) in cmf.wavelengths.iter().enumerate() {
        let nm = f64::from(*nm);
        // Planck's law times m has the same chromaticity and a limit at m = 0:
        // m / (lambda^5 (e^x - 1)) = g(x) / (lambda^5 a), with x = a m and g = x / (e^x - 1).
        let a = C2 * 1e-6 / nm;
        let (g, dg) = bose(a * mired);
        let scale = 1.0 / (nm / 560.0 * (nm / 560.0) * (nm / 560.0) * (nm / 560.0) * (nm / 560.0) * a);
        for channel in 0..3 {
            xyz[channel] += cmf.columns[channel][row] * g * scale;
            slope[channel] += cmf.columns[channel][row] * dg * a * scale;
        }
    }
    let sum = |v: [f64; 3]| v[0] + 15.0 * v[1] + 3.0 * v[2];
    let (d, dd) = (sum(xyz), sum(slope));
    [
        4.0 * xyz[0] / d,
        6.0 * xyz[1] / d,
        4.0 * (slope[0] * d - xyz[0] * dd) / (d * d),
        6.0 * (slope[1] * d - xyz[1] * dd) / (d * d),
    ]
}

/// x / (e^x - 1) and its derivative.
pub fn bose(x: f64) -> (f64, f64) {
    if x < 1e-3 {
        // The series is 1 - x/2 + x^2/12 - .., whose next terms are x^4/720 and x^3/180.
        return (1.0 - x / 2.0 + x * x / 12.0, -0.5 + x / 6.0);
    }
    let e = exp(x);
    (x / (e - 1.0), (1.0 - x * e / (e - 1.0)) / (e - 1.0))
}

/// e^x from the four basic operations alone: the series for 2^-10 of the argument, squared ten times. The
/// relative error is below 1e-12 for 0 <= x <= 50.
fn exp(x: f64) -> f64 {
    let small = x / 1024.0;
    let mut sum = 1.0;
    for n in (1..=14).rev() {
        sum = 1.0 + small / f64::from(n) * sum;
    }
    for _ in 0..10 {
        sum *= sum;
    }
    sum
}
