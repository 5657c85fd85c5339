//! Tables at every nanometer, observers that are made at run time, and spectra of colors.

use crate::steps::Meter;
use core::slice::from_ref;
use nanospectra::color::{Rgb, Srgb, Xy, dominant_wavelength, ssi};
use nanospectra::light::{D65, Daylight, FL11, daylight, named};
use nanospectra::observer::CIE_1931;
use nanospectra::radiometry::{AlphaOpic, luminous_efficacy};
use nanospectra::upsample::{CohenR, CubicStart, Sigmoid, SigmoidReflectance, Solved, Viewing};
use nanospectra::{Bins, Curve, Fine, Interpolation, Light, Observer, Power, Reflectance};

type Grid = Bins<380, 730>;

static FL11_FINE: Fine<Power> = FL11.fine();
static DAYLIGHT: Fine<Power> = D65.fine();
static IN_DAYLIGHT: Observer<3, 31> = CIE_1931.under(&D65.fine()).fold(Curve::Step);
static VIEWING: Viewing<31> = Viewing::new(&IN_DAYLIGHT);
static SIGMOID: Sigmoid<31, Grid, Srgb, CubicStart> = Sigmoid::new(&VIEWING);
static COHEN: CohenR<31> = CohenR::new(&IN_DAYLIGHT);
static GRAY: Reflectance<31> = Reflectance::flat(0.4);

/// Measures every call of this group.
pub fn all(meter: &mut impl Meter) {
    meter.step("light-named", by_name, &["FL11", "D65"]);
    meter.step("interpolate-sprague", sprague, &[()]);
    meter.step("daylight", of_temperature, &[6500.0]);
    meter.step("resample-471-31", resampled, from_ref(&FL11_FINE));
    meter.step("under-fold-3x16", under_fold_16, from_ref(&FL11_FINE));
    meter.step("under-fold-3x31", under_fold_31, from_ref(&FL11_FINE));
    meter.step("fold-3x16", fold_16, &[()]);
    meter.step("melanopic-der", der, from_ref(&FL11_FINE));
    meter.step("luminous-efficacy", efficacy, from_ref(&FL11_FINE));
    meter.step("ssi", similarity, from_ref(&FL11_FINE));
    meter.step("dominant-wavelength", dominant, &[Xy::new(0.5, 0.4)]);

    // Inside sRGB, and outside.
    let colors = [Rgb::new(0.8, 0.2, 0.1), Rgb::new(0.02, 0.01, 0.3), Rgb::new(1.0, -0.1, 0.2)];
    meter.step("upsample-viewing", viewing, from_ref(&IN_DAYLIGHT));
    meter.step("upsample-sigmoid", sigmoid, from_ref(&VIEWING));
    meter.step("upsample-reflectance", reflectance, &colors);
    meter.step("upsample-desaturated", desaturated, &colors);
    meter.step("upsample-reflectance-8", reflectance_8, &[[colors[0]; 8]]);
    meter.step("upsample-from-rgb", from_rgb, &colors);
    meter.step("metamer-new", metamer_new, from_ref(&IN_DAYLIGHT));
    meter.step("metamer-black", metamer_black, from_ref(&GRAY));
}

#[inline(never)]
fn by_name(name: &&str, out: &mut Option<Fine<Power>>) {
    *out = named(name);
}

#[inline(never)]
fn sprague(_: &(), out: &mut Option<Fine<Power>>) {
    *out = Some(FL11.interpolate(Interpolation::Sprague));
}

#[inline(never)]
fn of_temperature(cct_k: &f32, out: &mut Option<Daylight>) {
    *out = daylight(*cct_k);
}

#[inline(never)]
fn resampled(light: &Fine<Power>, out: &mut Light<31>) {
    *out = light.resample();
}

#[inline(never)]
fn under_fold_16(light: &Fine<Power>, out: &mut Option<Observer<3, 16>>) {
    *out = Some(CIE_1931.under(light).fold(Curve::Spline));
}

#[inline(never)]
fn under_fold_31(light: &Fine<Power>, out: &mut Option<Observer<3, 31>>) {
    *out = Some(CIE_1931.under(light).fold(Curve::Spline));
}

#[inline(never)]
fn fold_16(_: &(), out: &mut Option<Observer<3, 16, Power>>) {
    *out = Some(CIE_1931.fold(Curve::Spline));
}

#[inline(never)]
fn der(light: &Fine<Power>, out: &mut Option<AlphaOpic>) {
    *out = AlphaOpic::der(light);
}

#[inline(never)]
fn efficacy(light: &Fine<Power>, out: &mut Option<f32>) {
    *out = luminous_efficacy(light);
}

#[inline(never)]
fn similarity(light: &Fine<Power>, out: &mut Option<f32>) {
    *out = ssi(light, &DAYLIGHT);
}

#[inline(never)]
fn dominant(xy: &Xy, out: &mut Option<f32>) {
    *out = dominant_wavelength(*xy, Xy::new(1.0 / 3.0, 1.0 / 3.0), &CIE_1931).map(|found| found.nm);
}

#[inline(never)]
fn viewing(eye: &Observer<3, 31>, out: &mut Option<Viewing<31>>) {
    *out = Some(Viewing::new(eye));
}

#[inline(never)]
fn sigmoid(viewing: &Viewing<31>, out: &mut Option<Sigmoid<31, Grid, Srgb, CubicStart>>) {
    *out = Some(Sigmoid::new(viewing));
}

#[inline(never)]
fn reflectance(rgb: &Rgb<Srgb>, out: &mut Option<Solved<SigmoidReflectance>>) {
    *out = Some(SIGMOID.reflectance(*rgb));
}

#[inline(never)]
fn desaturated(rgb: &Rgb<Srgb>, out: &mut Option<Solved<SigmoidReflectance>>) {
    *out = Some(SIGMOID.desaturated(*rgb));
}

#[inline(never)]
fn reflectance_8(rgb: &[Rgb<Srgb>; 8], out: &mut Option<[Solved<SigmoidReflectance>; 8]>) {
    *out = Some(SIGMOID.reflectance_8(rgb));
}

#[inline(never)]
fn from_rgb(rgb: &Rgb<Srgb>, out: &mut Reflectance<31>) {
    *out = Reflectance::from_rgb(*rgb);
}

#[inline(never)]
fn metamer_new(eye: &Observer<3, 31>, out: &mut Option<CohenR<31>>) {
    *out = Some(CohenR::new(eye));
}

#[inline(never)]
fn metamer_black(surface: &Reflectance<31>, out: &mut Reflectance<31>) {
    *out = COHEN.black(surface);
}
