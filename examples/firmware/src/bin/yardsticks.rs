//! Prints the instructions of published methods of others (`nanospectra_hard::yardstick`) as lines `name
//! count`. They are counted as in `count`.
#![no_std]
#![no_main]

use nanospectra::color::Xy;
use nanospectra::light::D65;
use nanospectra::math::{Fast, Math, Portable};
use nanospectra::observer::CIE_1931;
use nanospectra::{Fine, FineObserver, Power};
use nanospectra_firmware::clock::Clock;
use nanospectra_hard::yardstick::{cct, lobes, product, sums};
use semihosting::{println, process};

static DAYLIGHT: Fine<Power> = D65.fine();
static Y: FineObserver<1> = CIE_1931.mixed(&[[0.0, 1.0, 0.0]]);

#[nanospectra_firmware::entry]
fn main() -> ! {
    let clock = Clock::start();
    count(&clock, "rgb-product", rgb_product, &[[[0.9, 0.8, 0.7], [0.5, 0.2, 0.1]]]);
    // Wavelengths on either side of the lobes and beyond them.
    let wavelengths = [380.0, 450.0, 500.0, 555.0, 600.0, 780.0];
    count(&clock, "lobes-point", lobes_point::<Portable>, &wavelengths);
    count(&clock, "lobes-point-fast", lobes_point::<Fast>, &wavelengths);
    count(&clock, "sum-471-naive", sum_naive, &[DAYLIGHT]);
    count(&clock, "sum-471-lanes", sum_lanes, &[DAYLIGHT]);
    count(&clock, "sum-471-pairwise", sum_pairwise, &[DAYLIGHT]);

    // The lights of `cct-duv` in `count`. For the first, a candle, Robertson's method passes most isotherms.
    let lights = [
        [0.5268, 0.4133],
        [0.4476, 0.4074],
        [0.3805, 0.3769],
        [0.3127, 0.3290],
        [0.2807, 0.2884],
        [0.2525, 0.2522],
        [0.3600, 0.4000],
        [0.3800, 0.3300],
    ];
    count(&clock, "cct-mccamy", cct_mccamy, &lights);
    count(&clock, "cct-robertson", cct_robertson, &lights);
    count(&clock, "cct-ohno", cct_ohno, &lights);
    process::exit(0)
}

/// Prints the instructions of the longest call.
fn count<A, R: Default>(clock: &Clock, name: &str, f: fn(&A, &mut R), inputs: &[A]) {
    let longest = inputs.iter().map(|input| clock.count(f, input, &mut R::default())).max();
    println!("{name} {}", longest.unwrap_or(0));
}

#[inline(never)]
fn rgb_product([light, surface]: &[[f32; 3]; 2], xyz: &mut [f32; 3]) {
    *xyz = product::rgb_product(*light, *surface);
}

#[inline(never)]
fn lobes_point<M: Math>(nm: &f32, xyz_bar: &mut [f32; 3]) {
    *xyz_bar = lobes::color_matching::<M>(*nm);
}

#[inline(never)]
fn sum_naive(light: &Fine<Power>, y: &mut f32) {
    let [row] = Y.weights();
    *y = sums::naive(row, light.values());
}

#[inline(never)]
fn sum_lanes(light: &Fine<Power>, y: &mut f32) {
    [*y] = Y.sees(light);
}

#[inline(never)]
fn sum_pairwise(light: &Fine<Power>, y: &mut f32) {
    let [row] = Y.weights();
    *y = sums::pairwise(row, light.values());
}

#[inline(never)]
fn cct_mccamy(xy: &[f32; 2], out: &mut f32) {
    *out = cct::mccamy(*xy);
}

#[inline(never)]
fn cct_robertson([x, y]: &[f32; 2], out: &mut Option<[f32; 2]>) {
    let uv = Xy { x: *x, y: *y }.uv1960();
    *out = cct::robertson([uv.u, uv.v]);
}

#[inline(never)]
fn cct_ohno([x, y]: &[f32; 2], out: &mut Option<[f32; 2]>) {
    let uv = Xy { x: *x, y: *y }.uv1960();
    *out = cct::ohno([uv.u, uv.v]);
}
