//! Films, and scenes of several parts.

use crate::steps::Meter;
use crate::vest::{LAMP, VEST};
use core::slice::from_ref;
use nanospectra::matter::{Donaldson, Layer, Medium, Mirror, Polarizer, Stack, ThinFilm, stack_bins};
use nanospectra::observer::CIE_1931;
use nanospectra::path::{IntoPart, Part, Scene};
use nanospectra::{Curve, Light, Observer, Power, Reflectance};

static EYE: Observer<3, 31, Power> = CIE_1931.fold(Curve::Step);
static GRAY: Reflectance<31> = Reflectance::flat(0.4);
static MATRIX: Donaldson<31, 496> = Donaldson::from_dye(&VEST);
static LAKE: Mirror<31> = Mirror::dielectric(&[1.33; 31], 0.5, 0.1);
static SHEET: Polarizer<31> = Polarizer::ideal(0.2);

/// Measures every call of this group.
pub fn all(meter: &mut impl Meter) {
    meter.step("film-reflectance-31", film, &[0.7]);
    meter.step("film-stack-31", stack, &[0.7]);
    meter.step("path-donaldson-31", donaldson, from_ref(&LAMP));
    meter.step("path-mirror-31", mirror, from_ref(&LAMP));
    meter.step("path-fold-donaldson-31", fold_donaldson, from_ref(&EYE));
    let scene = scene();
    meter.step("scene-leaving-31", leaving, from_ref(&scene));
    meter.step("scene-fold-3x31", fold_scene, from_ref(&scene));
    meter.step("scene-within-budget-31", budget, from_ref(&scene));
}

#[inline(never)]
fn film(cosine: &f32, out: &mut Reflectance<31>) {
    *out = ThinFilm::new([1.0, 1.33, 1.0], 550.0).reflectance(*cosine);
}

#[inline(never)]
fn stack(cosine: &f32, out: &mut [Reflectance<31>; 2]) {
    let stack = Stack {
        incident: 1.0,
        layers: [Layer { medium: Medium { n: 1.3, k: 0.0 }, thickness_nm: 550.0 }; 2],
        substrate: Medium { n: 1.5, k: 0.3 },
    };
    *out = stack_bins(|_| stack, *cosine, 2, |shares| shares.reflected);
}

#[inline(never)]
fn donaldson(lamp: &Light<31>, out: &mut [f32; 3]) {
    *out = EYE.sees(lamp.through(&GRAY).onto(&MATRIX));
}

#[inline(never)]
fn mirror(lamp: &Light<31>, out: &mut [f32; 3]) {
    *out = EYE.sees(lamp.polarized().onto(&LAKE).through(&SHEET).ignoring_polarization());
}

#[inline(never)]
fn fold_donaldson(eye: &Observer<3, 31, Power>, out: &mut Option<Observer<3, 31, Power>>) {
    *out = Some(eye.looking_at_donaldson(&MATRIX));
}

/// A filter, a dye, paper, a mirror and a polarizer.
fn scene() -> Scene<'static, 31, 5> {
    let mut scene = Scene::new();
    let parts = [Part::Filter(&GRAY), (&VEST).into_part(), Part::Surface(&GRAY)];
    for part in parts.into_iter().chain([(&LAKE).into_part(), (&SHEET).into_part()]) {
        let _ = scene.push(part);
    }
    scene
}

#[inline(never)]
fn leaving(scene: &Scene<31, 5>, out: &mut Light<31>) {
    *out = scene.leaving_polarized(&LAMP);
}

#[inline(never)]
fn fold_scene(scene: &Scene<31, 5>, out: &mut Option<Observer<3, 31, Power>>) {
    *out = Some(scene.fold_polarized(&EYE));
}

#[inline(never)]
fn budget(scene: &Scene<31, 5>, out: &mut f32) {
    *out = scene.within_budget(&EYE, &LAMP, 1.0).delta_e;
}
