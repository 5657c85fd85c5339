//! The steps of the price list: what they are called, what they do, and the inputs of which the dearest
//! counts.
//!
//! A step is one function (not inlined, from memory to memory) and one line in [`all`]; `tests/devices.sh`
//! puts every name that it has not seen before on record.

use crate::pipeline::{Color, FIXED_METER, METER, TO_XYZ, WHITE, measure};
use crate::readings::{BLACK_BODY, DAYLIGHT, EXPOSURE, FLUORESCENT, INCANDESCENT, LED};
use nanospectra::color::{Cct, Lab, Xyz};
use nanospectra::math::Fast;
use nanospectra::observer::CIE_1931;
use nanospectra::sensor::fixed::{FixedCct, FixedObserver, FixedXyz};
use nanospectra::sensor::{BasicCounts, ReadingError};
use nanospectra::{Curve, Nodes, Observer, Power};

/// Measures a step, in whatever it is that it measures.
pub trait Meter {
    fn step<A, R: Default>(&mut self, name: &str, f: fn(&A, &mut R), inputs: &[A]);
}

/// Readings of five lights.
const COUNTS: [[u16; 8]; 5] = [INCANDESCENT, DAYLIGHT, FLUORESCENT, LED, BLACK_BODY];

/// All of it, as the one thing that a program does.
pub fn whole(meter: &mut impl Meter) {
    meter.step("counts-f32", counts_f32, &COUNTS);
}

/// Step by step, in floats and in integers.
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

    meter.step("fixed-counts-xyz-lux", fixed_counts_xyz_lux, &counts);
    meter.step("fixed-counts-cct-duv", fixed_counts_cct_duv, &counts);
    meter.step("fixed-xyz-81", fixed_xyz_81, &[[0xffff; 81]]);
}

/// What a step says, and something to say before it.
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

/// The same in one pass, for an exposure that stays.
#[inline(never)]
fn counts_xyz_meter(counts: &[u16; 8], out: &mut Outcome<Xyz>) {
    out.0 = METER.xyz(counts);
}

/// All of it: saturation checked, XYZ, CCT, Duv and Lab.
#[inline(never)]
fn counts_f32(counts: &[u16; 8], out: &mut Outcome<Color>) {
    out.0 = measure(counts);
}

/// 81 bands of 16 bits, as a mini-spectrometer has them.
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
