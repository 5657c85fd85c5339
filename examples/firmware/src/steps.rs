//! The steps of the price list: their names, the functions that are measured, and the inputs. For each step
//! the input with the highest cost counts.
//!
//! A step is one function, which is not inlined and goes from memory to memory, and one line in [`all`].
//! `tests/devices.sh --bless` records every name, also new ones.

use crate::pipeline::{Color, FIXED_METER, METER, TO_XYZ, WHITE, measure};
use crate::readings::{BLACK_BODY, DAYLIGHT, EXPOSURE, FLUORESCENT, INCANDESCENT, LED};
use nanospectra::color::{Cct, Lab, Xyz};
use nanospectra::math::Fast;
use nanospectra::observer::CIE_1931;
use nanospectra::sensor::fixed::{FixedCct, FixedObserver, FixedXyz};
use nanospectra::sensor::{BasicCounts, LightFlickermeter, ReadingError};
use nanospectra::{Curve, Nodes, Observer, Power};

/// A program that measures steps, for example in instructions.
pub trait Meter {
    fn step<A, R: Default>(&mut self, name: &str, f: fn(&A, &mut R), inputs: &[A]);
}

/// The readings of five lights.
const COUNTS: [[u16; 8]; 5] = [INCANDESCENT, DAYLIGHT, FLUORESCENT, LED, BLACK_BODY];

/// Measures a whole reading, in a program that does nothing else.
pub fn whole(meter: &mut impl Meter) {
    meter.step("counts-f32", counts_f32, &COUNTS);
}

/// Measures every step by itself, in floating point and in integers.
pub fn all(meter: &mut impl Meter) {
    let counts = COUNTS;
    let basic = counts.map(|counts| EXPOSURE.basic_counts(&counts).unwrap_or(BasicCounts::new([0.0; 8])));
    let colors = basic.map(|basic| Xyz::from(TO_XYZ.apply(&basic)));

    meter.step("counts-basic", counts_basic, &counts);
    meter.step("basic-xyz", basic_xyz, &basic);
    meter.step("xyz-cct-duv", xyz_cct_duv, &colors);
    meter.step("xyz-lab", xyz_lab, &colors);
    meter.step("xyz-lab-fast", xyz_lab_fast, &colors);
    meter.step("counts-xyz", counts_xyz, &counts);
    meter.step("counts-xyz-meter", counts_xyz_meter, &counts);
    let pulses = core::array::from_fn(|k| if k % 20 < 10 { 0.6 } else { 0.8 });
    meter.step("flickermeter-100-readings", flickermeter_100_readings, &[pulses]);

    meter.step("fixed-counts-xyz-lux", fixed_counts_xyz_lux, &counts);
    meter.step("fixed-counts-cct-duv", fixed_counts_cct_duv, &counts);
    meter.step("fixed-xyz-81", fixed_xyz_81, &[[0xffff; 81]]);
}

/// The result of a step, with a default for the time before it.
struct Outcome<T>(Result<T, ReadingError>);

impl<T> Default for Outcome<T> {
    fn default() -> Self {
        Outcome(Err(ReadingError::TooDark))
    }
}

#[inline(never)]
fn counts_basic(counts: &[u16; 8], out: &mut Outcome<BasicCounts<8>>) {
    out.0 = EXPOSURE.basic_counts(counts);
}

#[inline(never)]
fn basic_xyz(basic: &BasicCounts<8>, out: &mut Outcome<Xyz>) {
    out.0 = TO_XYZ.xyz(basic);
}

/// The start of a meter, and 5 ms of a waveform, of which every 10th reading is weighted.
#[inline(never)]
fn flickermeter_100_readings(readings: &[f32; 100], severity: &mut f32) {
    let Some(mut meter) = LightFlickermeter::new(20_000.0) else { return };
    readings.iter().for_each(|reading| meter.push(*reading));
    *severity = meter.pst_lm().unwrap_or_default();
}

#[inline(never)]
fn xyz_cct_duv(xyz: &Xyz, out: &mut Option<Cct>) {
    *out = xyz.cct();
}

#[inline(never)]
fn xyz_lab(xyz: &Xyz, out: &mut Option<Lab>) {
    *out = xyz.lab(WHITE);
}

#[inline(never)]
fn xyz_lab_fast(xyz: &Xyz, out: &mut Option<Lab>) {
    *out = xyz.lab_with::<Fast>(WHITE);
}

#[inline(never)]
fn counts_xyz(counts: &[u16; 8], out: &mut Outcome<Xyz>) {
    out.0 = EXPOSURE.basic_counts(counts).and_then(|basic| TO_XYZ.xyz(&basic));
}

/// Does the same as `counts_xyz` in one pass, for an exposure that does not change.
#[inline(never)]
fn counts_xyz_meter(counts: &[u16; 8], out: &mut Outcome<Xyz>) {
    out.0 = METER.xyz(counts);
}

/// Does a whole reading: checks for saturation, then computes XYZ, CCT, Duv and Lab.
#[inline(never)]
fn counts_f32(counts: &[u16; 8], out: &mut Outcome<Color>) {
    out.0 = measure(counts);
}

/// An observer for 81 bands of 16 bits, such as a mini-spectrometer gives.
static FIXED_EYE: FixedObserver<3, 81, Nodes<380, 780>> = {
    let eye: Observer<3, 81, Power, Nodes<380, 780>> = CIE_1931.fold(Curve::Spline);
    FixedObserver::new(&eye).unwrap()
};

#[inline(never)]
fn fixed_counts_xyz_lux(counts: &[u16; 8], out: &mut Outcome<(FixedXyz, u32)>) {
    out.0 = FIXED_METER.xyz(counts).map(|xyz| (xyz, xyz.lux()));
}

#[inline(never)]
fn fixed_counts_cct_duv(counts: &[u16; 8], out: &mut Outcome<(FixedXyz, u32, Option<FixedCct>)>) {
    out.0 = FIXED_METER.xyz(counts).map(|xyz| (xyz, xyz.lux(), xyz.cct()));
}

#[inline(never)]
fn fixed_xyz_81(bands: &[u16; 81], out: &mut [i32; 3]) {
    *out = FIXED_EYE.sees(bands);
}
