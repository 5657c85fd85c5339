//! Prints the instructions that public calls take, one `name count` per line; exact and repeatable in QEMU.
//!
//! Inputs come from memory and results go to memory, so the numbers include loads and stores, and exclude the
//! call (see [`Clock::count`]). Where the path depends on the data, the longest of several inputs counts.
#![no_std]
#![no_main]

use nanospectra::color::{Cct, Lab, Uv1976, Xy, Xyz};
use nanospectra::light::{D65, FL11};
use nanospectra::observer::{CIE_1931, Curve, Observer};
use nanospectra::{Fine, Interpolation, Outside, Power, Reflectance, math};
use nanospectra_firmware::clock::Clock;
use semihosting::{println, process};

static FL11_FINE: Fine<Power> = FL11.interpolate(Interpolation::Linear, Outside::Zero);
static EYE_16: Observer<3, 16> = CIE_1931.under(&FL11_FINE).fold(Curve::Spline).with_white_y(100.0);
static EYE_31: Observer<3, 31> = CIE_1931.under(&FL11_FINE).fold(Curve::Spline).with_white_y(100.0);
static EYE_81: Observer<3, 81> = CIE_1931.under(&FL11_FINE).fold(Curve::Spline).with_white_y(100.0);
static WHITE: Xyz = Xyz { x: 95.047, y: 100.0, z: 108.883 };

#[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
#[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
fn main() -> ! {
    let clock = Clock::start();

    count(&clock, "xyz-16", xyz_16, &[Reflectance::flat(0.5)]);
    count(&clock, "xyz-31", xyz_31, &[Reflectance::flat(0.5)]);
    count(&clock, "xyz-81", xyz_81, &[Reflectance::flat(0.5)]);
    count(&clock, "xyz-471", xyz_471, &[D65.interpolate(Interpolation::Linear, Outside::Zero)]);

    // A pale, a dark, a strong blue and a strong red: both sides of Lab's knee.
    let colors = [[40.0, 50.0, 45.0], [0.3, 0.4, 0.2], [20.0, 10.0, 90.0], [40.0, 20.0, 0.5]].map(Xyz::from);
    count(&clock, "xy", xy, &colors);
    count(&clock, "uv1976", uv1976, &colors);
    count(&clock, "lab", lab, &colors);

    // Candle, incandescent, fluorescent, daylight, overcast sky, clear sky; green and pink of the locus.
    let lights = [
        [0.5268, 0.4133],
        [0.4476, 0.4074],
        [0.3805, 0.3769],
        [0.3127, 0.3290],
        [0.2807, 0.2884],
        [0.2525, 0.2522],
        [0.3600, 0.4000],
        [0.3800, 0.3300],
    ]
    .map(|[x, y]| Xy { x, y });
    count(&clock, "cct-duv", cct_duv, &lights);

    count(&clock, "sqrt", sqrt, &[2.0, 1e-40, 1e30]);
    count(&clock, "cbrt", cbrt, &[2.0, 1e-40, -1e30]);
    process::exit(0)
}

/// Prints the longest of the calls. (`inputs` go through a `black_box`, so the compiler knows nothing of them.)
fn count<A, R: Default>(clock: &Clock, name: &str, f: fn(&A, &mut R), inputs: &[A]) {
    let longest = inputs.iter().map(|input| clock.count(f, input, &mut R::default())).max();
    println!("{name} {}", longest.unwrap_or(0));
}

#[inline(never)]
fn xyz_16(paper: &Reflectance<16>, xyz: &mut [f32; 3]) {
    *xyz = EYE_16.sees(paper);
}

#[inline(never)]
fn xyz_31(paper: &Reflectance<31>, xyz: &mut [f32; 3]) {
    *xyz = EYE_31.sees(paper);
}

#[inline(never)]
fn xyz_81(paper: &Reflectance<81>, xyz: &mut [f32; 3]) {
    *xyz = EYE_81.sees(paper);
}

#[inline(never)]
fn xyz_471(light: &Fine<Power>, xyz: &mut [f32; 3]) {
    *xyz = CIE_1931.sees(light);
}

#[inline(never)]
fn xy(xyz: &Xyz, out: &mut Option<Xy>) {
    *out = xyz.xy();
}

#[inline(never)]
fn uv1976(xyz: &Xyz, out: &mut Option<Uv1976>) {
    *out = xyz.uv1976();
}

#[inline(never)]
fn lab(xyz: &Xyz, out: &mut Option<Lab>) {
    *out = xyz.lab(WHITE);
}

#[inline(never)]
fn cct_duv(xy: &Xy, out: &mut Option<Cct>) {
    *out = Some(xy.uv1960().cct());
}

#[inline(never)]
fn sqrt(x: &f32, root: &mut f32) {
    *root = math::sqrt(*x);
}

#[inline(never)]
fn cbrt(x: &f32, root: &mut f32) {
    *root = math::cbrt(*x);
}
