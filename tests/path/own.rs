//! An effect of a user's own: one function puts it into a path; what is linear folds, and agrees with the way
//! forward.

use nanospectra::color::{RgbBands, Srgb};
use nanospectra::matter::{Donaldson, Dye, Effect, Foldable, Mirror, Phosphor};
use nanospectra::observer::CIE_1931;
use nanospectra::path::{Effects, Own, Scene};
use nanospectra::{Bins, Curve, Light, Observer, Power, Reflectance};
use proptest::prelude::*;

static EYE: Observer<3, 31, Power> = CIE_1931.fold(Curve::Step);

/// A dye of which half glows at a light that makes it emit 1 per nm in all: concentration quenching.
struct Quenched {
    dye: Dye<31>,
}

impl Effect<31> for Quenched {
    fn leaving(&self, light: &Light<31>) -> Light<31> {
        let glow = self.dye.glow_under(light);
        let dark = self.dye.reflectance();
        let [dull, shining] = [*light * dark, self.dye.leaving(light)];
        dull + (shining + dull * -1.0) * (1.0 / (1.0 + glow))
    }
}

/// Two dyes in one binder: each takes its half of the light.
struct Mixed<const N: usize, G> {
    dyes: [Dye<N, G>; 2],
}

impl<const N: usize, G: nanospectra::Grid> Effect<N, G> for Mixed<N, G> {
    fn leaving(&self, light: &Light<N, G>) -> Light<N, G> {
        let [one, other] = self.dyes.each_ref().map(|dye| dye.leaving(light) * 0.5);
        one + other
    }
}

impl<const N: usize, G: nanospectra::Grid> Foldable<N, G> for Mixed<N, G> {}

fn dye<const N: usize>(blue: f32) -> Dye<N> {
    let absorbs = Reflectance::at_centers(|nm| if nm < blue { 0.8 } else { 0.1 });
    let emits = Light::at_centers(|nm| if nm > blue && nm < blue + 80.0 { 1.0 } else { 0.1 });
    Dye::new(&Reflectance::flat(0.1), &absorbs, &emits, 0.5).expect("possible")
}

#[test]
fn an_effect_of_ones_own_needs_one_function() {
    let (sun, gray) = (Light::<31>::flat(1.0), Reflectance::flat(0.5));
    let ink = Quenched { dye: dye(480.0) };
    let part = Own::new(&ink);
    let lit = sun.through(&gray).onto(part).through(&gray);
    assert_eq!(lit.collected(), ink.leaving(&(sun * gray)) * gray);
    assert_eq!(EYE.sees(lit), EYE.sees(&lit.collected()));
    // Polarized light falls on it as its intensity, and plain light goes through it.
    assert_eq!(sun.polarized().onto(part).collected(), ink.leaving(&sun));
    assert_eq!(sun.through(part).collected(), ink.leaving(&sun));
    // Twice the light gives less than twice the glow.
    let [once, twice] = [1.0, 2.0].map(|k| ink.leaving(&(sun * k)).values()[12]);
    assert!(once > 0.1 && twice < 1.95 * once, "{once} {twice}");
}

/// A scene holds matter by reference, of users too, and threads share both.
#[test]
fn threads_share_scenes_and_matter() {
    fn shared<T: Send + Sync>() {}
    shared::<Scene<31, 4>>();
    shared::<(Dye<31>, Donaldson<31, 496>, Phosphor<31>, Mirror<31>, Observer<3, 31>, Light<31>)>();
    shared::<(Scene<3, 4, RgbBands<Srgb>>, Light<3, RgbBands<Srgb>>)>();
}

#[test]
fn what_is_linear_folds_and_stands_in_a_scene() {
    let (sun, ink) = (Light::<31>::flat(1.0), Mixed { dyes: [dye(480.0), dye(550.0)] });
    let walked = EYE.sees(sun.onto(Own::new(&ink)));
    for (walked, folded) in walked.into_iter().zip(EYE.looking_at_matter(&ink).sees(&sun)) {
        assert!((walked - folded).abs() <= 4e-7 * walked, "{walked} {folded}");
    }
    let mut scene: Scene<31, 2> = Scene::new();
    scene.push(Own::new(&ink)).expect("room");
    scene.push(&ink.dyes[0]).expect("room");
    assert_eq!(scene.leaving(&sun), Ok(sun.onto(Own::new(&ink)).onto(&ink.dyes[0]).collected()));
    assert_eq!(scene.fold(&EYE), Ok(EYE.looking_at_matter(&ink.dyes[0]).looking_at_matter(&ink)));
    // Without a price of its own it counts as a full matrix; left out, the diagonal of that matrix remains.
    let line = scene.bill().next().expect("a line");
    assert_eq!(
        (line.name, line.price.multiply_adds, line.price.effects),
        ("effect", 31 * 31, Effects::FLUORESCENCE)
    );
    let mut one = Light::flat(0.0);
    one.values_mut()[20] = 1.0;
    assert_eq!(ink.without_effect().values()[20], ink.leaving(&one).values()[20]);
}

/// What the eye makes of what leaves is what the eye as it looks at the matter makes of what comes.
fn transposed<const N: usize, G: nanospectra::Grid>(
    matter: &impl Foldable<N, G>,
    weights: &[f32; N],
    light: &Light<N, G>,
) -> Result<(), TestCaseError> {
    let sum = |a: &[f32; N], b: &[f32; N]| -> f64 {
        a.iter().zip(b).map(|(a, b)| f64::from(*a) * f64::from(*b)).sum()
    };
    let forward = sum(weights, matter.leaving(light).values());
    let backward = sum(&matter.transposed(weights), light.values());
    prop_assert!((forward - backward).abs() <= 4e-7 * forward, "{forward} {backward}");
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn every_effect_agrees_with_its_transpose(
        light in prop::array::uniform16(0.0f32..1.0), weights in prop::array::uniform16(0.0f32..1.0), blue in 400.0f32..600.0,
    ) {
        let light = Light::<16, Bins<380, 730>>::from_bins(light);
        let mixed = Mixed { dyes: [dye(blue), dye(500.0)] };
        let matrix: Donaldson<16, 136> = Donaldson::from_dye(&mixed.dyes[0]);
        transposed(&mixed.dyes[0], &weights, &light)?;
        transposed(&matrix, &weights, &light)?;
        transposed(&mixed, &weights, &light)?;
    }
}
