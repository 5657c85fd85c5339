//! Calibrations and reconstructions of a sensor.

use crate::steps::Meter;
use core::slice::from_ref;
use nanospectra::light::{A, D65, LED_B3};
use nanospectra::observer::CIE_1931;
use nanospectra::sensor::{
    BasicCounts, Calibration, FirstPixel, Fit, PixelWavelengths, Rebinned, Reconstruction, chip::as7341,
    covariance_of, nonnegative_spectrum, stroboscopic_visibility,
};
use nanospectra::{Curve, Interpolation, Light, Nodes, Observer, Power, const_unwrap};

type TenNm = Nodes<400, 700>;
type FiveNm = Nodes<380, 780>;

static CHIP_31: Observer<8, 31, Power, TenNm> = as7341::NOMINAL.fold(Curve::Step);
static CHIP_81: Observer<8, 81, Power, FiveNm> = as7341::NOMINAL.fold(Curve::Step);
static EYE: Observer<3, 31, Power, TenNm> = CIE_1931.fold(Curve::Step);
static LAMPS: [Light<31, TenNm>; 3] = [
    A.interpolate(Interpolation::Linear),
    D65.interpolate(Interpolation::Linear),
    LED_B3.interpolate(Interpolation::Linear),
];
static PIXELS: PixelWavelengths<288> =
    const_unwrap!(PixelWavelengths::new([310.0, 2.7, 1e-4, 0.0, 0.0, 0.0], FirstPixel::One));

/// A lamp of 100 Hz that is read 4000 times a second, for a tenth of a second.
static WAVE: [f32; 400] = {
    let (mut wave, mut k) = ([1.0; 400], 0);
    while k < 400 {
        if k % 40 >= 30 {
            wave[k] = 0.2;
        }
        k += 1;
    }
    wave
};

/// Measures every call of this group.
pub fn all(meter: &mut impl Meter) {
    meter.step("smooth-8x31", smooth_31, &[0.95]);
    meter.step("smooth-8x81", smooth_81, &[0.975]);
    if !cfg!(small_flash) {
        // A matrix of 31 x 31 beside its root is too much for the smallest board.
        by_covariance(meter);
    }
    // A lamp, and a line, whose search is long.
    let mut laser = Light::flat(0.0);
    let _ = laser.add_line(532.0, 1.0);
    let seen = [LAMPS[0], LAMPS[2], laser].map(|light| BasicCounts::new(CHIP_31.sees(&light)));
    meter.step("nonnegative-8x31", nonnegative_31, &seen);
    meter.step("nonnegative-8x81", nonnegative_81, &seen);

    fitting::<8>(meter, ["fit-8-add", "fit-8-solve", "fit-8-leave-one-out"]);
    fitting::<18>(meter, ["fit-18-add", "fit-18-solve", "fit-18-leave-one-out"]);
    meter.step("crosstalk-8", crosstalk::<8>, &[leak()]);
    meter.step("crosstalk-18", crosstalk::<18>, &[leak()]);
    meter.step("seen-by-8x31", seen_by, &[Reconstruction::smooth(&CHIP_31, 0.95, 0.01).ok()]);
    meter.step("rebinned-288-41", rebinned, &[[100.0; 288]]);
    meter.step("stroboscopic-400", stroboscopic, from_ref(&WAVE));
}

#[inline(never)]
fn by_covariance(meter: &mut impl Meter) {
    meter.step("covariance-31", covariance_31, from_ref(&LAMPS));
    meter.step("wiener-8x31", wiener_31, &[covariance_of(&LAMPS)]);
}

fn leak<const C: usize>() -> [[f32; C]; C] {
    let mut leak = [[0.01; C]; C];
    for (k, row) in leak.iter_mut().enumerate() {
        row[k] = 1.0;
    }
    leak
}

#[inline(never)]
fn smooth_31(correlation: &f32, out: &mut Option<Reconstruction<8, 31, TenNm>>) {
    *out = Reconstruction::smooth(&CHIP_31, *correlation, 0.01).ok();
}

#[inline(never)]
fn smooth_81(correlation: &f32, out: &mut Option<Reconstruction<8, 81, FiveNm>>) {
    *out = Reconstruction::smooth(&CHIP_81, *correlation, 0.01).ok();
}

#[inline(never)]
fn covariance_31(lamps: &[Light<31, TenNm>; 3], out: &mut Option<[[f32; 31]; 31]>) {
    *out = Some(covariance_of(lamps));
}

#[inline(never)]
fn wiener_31(covariance: &[[f32; 31]; 31], out: &mut Option<Reconstruction<8, 31, TenNm>>) {
    *out = Reconstruction::wiener(&CHIP_31, covariance, 0.01).ok();
}

#[inline(never)]
fn nonnegative_31(basic: &BasicCounts<8>, out: &mut Option<Light<31, TenNm>>) {
    *out = nonnegative_spectrum(&CHIP_31, basic, 0.01, 50).ok();
}

#[inline(never)]
fn nonnegative_81(basic: &BasicCounts<8>, out: &mut Option<Light<81, FiveNm>>) {
    *out = nonnegative_spectrum(&CHIP_81, basic, 0.01, 50).ok();
}

#[inline(never)]
fn fitting<const C: usize>(meter: &mut impl Meter, [add_one, solve, leave_one_out]: [&str; 3]) {
    let mut fit = Fit::<C>::new();
    for k in 0..2 * C {
        let mut counts = [0.1; C];
        counts[k % C] = 1.0 + k as f32;
        fit.add(&BasicCounts::new(counts), [0.5, 1.0, 0.1], 1.0);
    }
    meter.step(add_one, add, &[BasicCounts::new([1.0; C])]);
    meter.step(solve, solved, &[fit]);
    meter.step(leave_one_out, without_one, &[fit]);
}

#[inline(never)]
fn add<const C: usize>(basic: &BasicCounts<C>, fit: &mut Fit<C>) {
    fit.add(basic, [0.5, 1.0, 0.1], 1.0);
}

#[inline(never)]
fn solved<const C: usize>(fit: &Fit<C>, out: &mut Option<Calibration<C>>) {
    *out = fit.solve().ok();
}

#[inline(never)]
fn without_one<const C: usize>(fit: &Fit<C>, out: &mut Option<[f32; 3]>) {
    *out = fit.leave_one_out(&BasicCounts::new([0.1; C]), [0.5, 1.0, 0.1], 1.0).ok();
}

#[inline(never)]
fn crosstalk<const C: usize>(leak: &[[f32; C]; C], out: &mut Option<Calibration<C>>) {
    *out = Calibration::from_rows([[1.0; C]; 3]).without_crosstalk(leak).ok();
}

#[inline(never)]
fn seen_by(made: &Option<Reconstruction<8, 31, TenNm>>, out: &mut Option<Calibration<8>>) {
    *out = made.as_ref().map(|made| made.seen_by(&EYE));
}

#[inline(never)]
fn rebinned(pixels: &[f32; 288], out: &mut Option<Rebinned<41, FiveNm>>) {
    *out = Some(PIXELS.rebinned(pixels));
}

#[inline(never)]
fn stroboscopic(readings: &[f32; 400], out: &mut Option<f32>) {
    *out = stroboscopic_visibility(readings, 4000.0, 100.0);
}
