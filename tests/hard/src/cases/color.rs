//! Rows 25 to 33: sigmoids, cube roots, Lab and its knee, black, red lasers, and sRGB.

use super::textbook::powf;
use super::{Cases, answered};
use nanospectra::color::Xyz;
use nanospectra::color::transfer::{SrgbTransfer, Transfer};
use nanospectra::math::{Micromath, Portable, cbrt, sqrt};
use nanospectra::upsample::Shape;

pub fn rows(cases: &mut impl Cases) {
    cases.row("25", &TAILS, naive_sigmoid, sigmoid);
    cases.row("26", &[[1e20], [-1e20], [-1e19], [3e38]], naive_sigmoid, sigmoid);
    cases.row("27", &WAVELENGTHS, quadratic_in_nm, |&[nm]| [Shape { q: STEEP }.at(nm)]);
    cases.row("28", &ROOTS, |&[x]| [powf(x, 1.0 / 3.0)], |&[x]| [cbrt(x)]);
    cases.row("29", &KNEES, naive_knee, |&[_, below]| [below, below.next_up()].map(lightness));
    cases.row("30", &DARK, |&[y]| [116.0 * powf(y, 1.0 / 3.0) - 16.0], |&[y]| [lightness(y)]);
    cases.row("31a", &BLACK, |&[x, y, z]| answered(Some(x / (x + y + z))), xy_of_black);
    cases.row("31b", &BLACK, naive_luv, luv);
    cases.row("31c", &RED_LASER, naive_lab, lab);
    cases.row("32a", &[[0.003_130_8]], |at| step(at, naive_encode), |at| step(at, encode));
    cases.row("32b", &SIGNALS, naive_round_trip, round_trip);
    cases.row("33", &SIGNALS, |&[x]| [SrgbTransfer::encode_with::<Micromath>(x)], |&[x]| [encode(x)]);
}

const TAILS: [[f32; 1]; 9] =
    [[-0.107_056_975], [-1e4], [-1e3], [-100.0], [-10.0], [-1.0], [0.3], [10.0], [1e4]];

fn naive_sigmoid(&[x]: &[f32; 1]) -> [f32; 1] {
    [0.5 + x / (2.0 * sqrt(1.0 + x * x))]
}

fn sigmoid(&[x]: &[f32; 1]) -> [f32; 1] {
    [Shape { q: [0.0, 0.0, x] }.at(580.0)]
}

/// The coefficients of a steep quadratic in x = (nm - 580) / 200.
pub const STEEP: [f32; 3] = [211.7, -187.3, -33.9];
const WAVELENGTHS: [[f32; 1]; 25] = {
    // The last wavelength is the worst of a million that were tried.
    let (mut nm, mut k) = ([[787.905_76]; 25], 0);
    while k < 24 {
        nm[k] = [360.0 + 20.3 * k as f32];
        k += 1;
    }
    nm
};

/// Computes the same quadratic from its coefficients for nm.
fn quadratic_in_nm(&[nm]: &[f32; 1]) -> [f32; 1] {
    const ABC: [f32; 3] = {
        let [a, b, c] = [STEEP[0] as f64 / 4e4, STEEP[1] as f64 / 200.0, STEEP[2] as f64];
        [a as f32, (b - 2.0 * 580.0 * a) as f32, (c - 580.0 * b + 580.0 * 580.0 * a) as f32]
    };
    let [a, b, c] = ABC;
    naive_sigmoid(&[(a * nm + b) * nm + c])
}

const ROOTS: [[f32; 1]; 10] =
    [[0.021_109_749], [0.008], [0.008_856], [0.05], [0.184], [0.3], [0.7], [0.999], [-0.05], [1e-30]];

/// Returns L* of Y, which is relative to white.
fn lightness(y: f32) -> f32 {
    Xyz::new(1.0, y, 1.0).lab(Xyz::new(1.0, 1.0, 1.0)).map_or(f32::NAN, |lab| lab.l)
}

/// The last Y before the knee, by the rounded constants and exactly.
const KNEES: [[f32; 2]; 1] = [[0.008_856, 216.0 / 24389.0]];

fn naive_knee(&[below, _]: &[f32; 2]) -> [f32; 2] {
    let f = |y: f32| if y > 0.008_856 { powf(y, 1.0 / 3.0) } else { 7.787 * y + 16.0 / 116.0 };
    [below, below.next_up()].map(|y| 116.0 * f(y) - 16.0)
}

const DARK: [[f32; 1]; 6] = [[0.0], [-1e-3], [-0.5], [1e-6], [0.005], [0.5]];

const BLACK: [[f32; 3]; 1] = [[0.0; 3]];
/// A color that is seen relative to a white without Z.
const RED_LASER: [[f32; 3]; 1] = [[0.7, 0.3, 0.0]];
const COLOR: Xyz = Xyz::new(0.2, 0.2, 0.1);

fn xy_of_black(black: &[f32; 3]) -> [f32; 1] {
    answered(Xyz::from(*black).xy().map(|xy| xy.x))
}

const WHITE: [f32; 3] = [95.047, 100.0, 108.883];

fn naive_luv(&[x, y, z]: &[f32; 3]) -> [f32; 3] {
    let l = lightness(y / WHITE[1]);
    let uv = |[x, y, z]: [f32; 3]| {
        let sum = x + 15.0 * y + 3.0 * z;
        [4.0 * x / sum, 9.0 * y / sum]
    };
    let ([u, v], [un, vn]) = (uv([x, y, z]), uv(WHITE));
    [l, 13.0 * l * (u - un), 13.0 * l * (v - vn)]
}

fn luv(black: &[f32; 3]) -> [f32; 3] {
    Xyz::from(*black).luv(Xyz::from(WHITE)).map_or([f32::NAN; 3], |luv| [luv.l, luv.u, luv.v])
}

/// Returns b* by the formula as it is printed.
fn naive_lab(&[_, y, z]: &[f32; 3]) -> [f32; 1] {
    let f = |t: f32| powf(t, 1.0 / 3.0);
    let b = 200.0 * (f(COLOR.y / y) - f(COLOR.z / z));
    answered(Some(if b.is_finite() { b } else { f32::NAN }))
}

fn lab(white: &[f32; 3]) -> [f32; 1] {
    answered(COLOR.lab(Xyz::from(*white)).map(|lab| lab.b))
}

/// Signals on both sides of the knee, and colors outside the gamut.
const SIGNALS: [[f32; 1]; 12] =
    [[0.0], [1e-4], [0.003], [0.003_2], [0.02], [0.18], [0.5], [0.9], [1.0], [-0.001], [-0.18], [-1.0]];

fn encode(x: f32) -> f32 {
    SrgbTransfer::encode_with::<Portable>(x)
}

fn naive_encode(x: f32) -> f32 {
    if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * powf(x, 1.0 / 2.4) - 0.055 }
}

/// Returns how much the code value grows from the knee to the next number.
fn step(&[knee]: &[f32; 1], encode: fn(f32) -> f32) -> [f32; 1] {
    [encode(knee.next_up()) - encode(knee)]
}

/// Encodes a number and decodes it; the power is applied to negative light, too.
fn naive_round_trip(&[x]: &[f32; 1]) -> [f32; 1] {
    let code = naive_encode(x);
    let size = if code < 0.0 { -code } else { code };
    [if size <= 0.040_45 { code / 12.92 } else { powf((code + 0.055) / 1.055, 2.4) }]
}

fn round_trip(&[x]: &[f32; 1]) -> [f32; 1] {
    [SrgbTransfer::decode_with::<Portable>(encode(x))]
}
