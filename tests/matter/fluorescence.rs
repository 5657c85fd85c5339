//! A fluorescent vest: one dye at 1 nm in f64, and what is left of it in a few bins.
#![cfg(feature = "libm")]

use model::allowed::{Singles, check};
use model::check::Check;
use model::delta_e::de2000;
use model::interpolation::{Interpolation as Between, Outside as Beyond};
use model::lab::lab;
use model::tables::{self, source};
use nanospectra::math::{Fast, Portable};
use nanospectra::matter::{Donaldson, Dye, FluorescenceError, Phosphor};
use nanospectra::observer::CIE_1931;
use nanospectra::path::{Effects, Priced};
use nanospectra::{
    Bins, Curve, Factor, Fine, FineObserver, Grid, Light, Nodes, Observer, Power, Reflectance, Spectrum,
};
use proptest::prelude::*;
use std::array::from_fn;

/// Rises from 0 to 1 around `at`, within some 4 times `width` to either side.
fn step(nm: f64, at: f64, width: f64) -> f64 {
    1.0 / (1.0 + ((at - nm) / width).exp())
}

/// The vest of these tests, in fluorescent yellow. What it reflects without its dye:
fn reflectance(nm: f64) -> f64 {
    0.06 + 0.74 * step(nm, 500.0, 8.0)
}

/// What the dye absorbs of the light of each wavelength: blue, and violet down to 395 nm.
fn absorption(nm: f64) -> f64 {
    0.9 * (1.0 - step(nm, 487.0, 7.0)) * step(nm, 395.0, 5.0)
}

/// What it emits, power per nm: green with a tail to red, the peak at 515 nm.
fn emission(nm: f64) -> f64 {
    if nm <= 470.0 { 0.0 } else { (-0.5 * (((nm - 470.0) / 45.0).ln() / 0.45).powi(2)).exp() }
}

/// Photons emitted for each one absorbed.
const QUANTUM_YIELD: f64 = 0.85;

fn nm(k: usize) -> f64 {
    360.0 + k as f64
}

/// What leaves the vest, at 1 nm: by the definition, photon by photon.
fn leaving(light: &[f64], fluorescent: bool) -> Vec<f64> {
    let absorbed_photons: f64 = (0..471).map(|k| absorption(nm(k)) * light[k] * nm(k)).sum();
    let photons_of_emission: f64 = (0..471).map(|k| emission(nm(k)) * nm(k)).sum();
    let glow = if fluorescent { QUANTUM_YIELD * absorbed_photons / photons_of_emission } else { 0.0 };
    (0..471).map(|k| reflectance(nm(k)) * light[k] + glow * emission(nm(k))).collect()
}

struct Model {
    rows: [Vec<f64>; 3],
}

impl Model {
    fn new() -> Self {
        Model { rows: tables::Observer::Cie1931.on_cie_grid() }
    }

    fn xyz(&self, light: &[f64]) -> [f64; 3] {
        self.rows.each_ref().map(|row| row.iter().zip(light).map(|(a, b)| a * b).sum())
    }

    fn lab(&self, light: &[f64], seen: &[f64]) -> [f64; 3] {
        lab(self.xyz(seen), self.xyz(light))
    }
}

fn fine_vest() -> Dye<471, Nodes<360, 830>> {
    Dye::new(
        &spectral(reflectance),
        &spectral::<Factor, 471, _>(absorption),
        &spectral(emission),
        QUANTUM_YIELD as f32,
    )
    .expect("the vest is possible")
}

const LIGHTS: [&str; 23] = [
    "FL1", "FL2", "FL3", "FL4", "FL5", "FL6", "FL7", "FL8", "FL9", "FL10", "FL11", "FL12", "LED-B1",
    "LED-B2", "LED-B3", "LED-B4", "LED-B5", "LED-BH1", "LED-RGB1", "LED-V1", "LED-V2", "D65", "A",
];

/// A light at 1 nm, in f64 and as the crate has it.
fn lamp(id: &str) -> (Vec<f64>, Fine<Power>) {
    let values = source(id).on_cie_grid(Between::Linear, Beyond::Zero);
    let mut fine = Fine::flat(0.0);
    fine.values_mut().iter_mut().zip(&values).for_each(|(out, value)| *out = *value as f32);
    (values, fine)
}

fn spectral<Q, const N: usize, G: Grid>(f: impl Fn(f64) -> f64) -> Spectrum<Q, N, G> {
    Spectrum::at_centers(|nm| f(nm.into()) as f32)
}

/// The largest CIEDE2000 between the vest in `N` bins and at 1 nm, each on its own white, under all lights.
fn vest_in_bins<const N: usize>(what: &'static str) {
    let model = Model::new();
    let mut check = check(what);
    let vest: Dye<N> = fine_vest().resample();
    let eye: Observer<3, N, Power> = CIE_1931.fold(Curve::Spline);
    let (mut least, mut most) = (f64::INFINITY, 0.0f64);
    for id in LIGHTS {
        let (values, fine) = lamp(id);
        let truth = model.lab(&values, &leaving(&values, true));
        let without = model.lab(&values, &leaving(&values, false));
        let cost = de2000(without, truth);
        (least, most) = (least.min(cost), most.max(cost));
        let light: Light<N> = fine.resample();
        let white = eye.sees(&light).map(f64::from);
        let got = lab(eye.sees(light.onto(&vest)).map(f64::from), white);
        check.value(id, de2000(got, truth), 0.0);
    }
    check.tight(LIGHTS.len());
    println!("without the glow: {least} to {most}");
    assert!(
        (6.5..7.5).contains(&least) && (17.5..18.5).contains(&most),
        "without the glow: {least} to {most}"
    );
}

#[test]
fn a_vest_in_60_bins_is_the_vest_at_1_nm() {
    vest_in_bins::<60>("vest in 60 bins, CIEDE2000");
}

#[test]
fn a_vest_in_31_bins_is_nearly_the_vest_at_1_nm() {
    vest_in_bins::<31>("vest in 31 bins, CIEDE2000");
}

#[test]
fn a_vest_in_16_bins_is_about_the_vest_at_1_nm() {
    vest_in_bins::<16>("vest in 16 bins, CIEDE2000");
}

/// Folded at 1 nm, lamp and all, a vest keeps its color at every number of bins.
#[test]
fn a_vest_folded_at_1_nm_is_exact_at_any_number_of_bins() {
    fn compare<const N: usize>(check: &mut Check, seen: &FineObserver<3, Factor>, truth: [f64; 3], id: &str) {
        let folded: Observer<3, N> = seen.fold(Curve::Spline);
        check.add_all(&format!("{id}, {N} bins"), folded.sees(&Reflectance::flat(1.0)), truth);
    }
    let model = Model::new();
    let vest = fine_vest();
    let mut check = check("vest folded at 1 nm");
    for id in LIGHTS {
        let (values, fine) = lamp(id);
        let truth = model.xyz(&leaving(&values, true));
        let seen = CIE_1931.looking_at_dye(&vest).under(&fine);
        compare::<1>(&mut check, &seen, truth, id);
        compare::<3>(&mut check, &seen, truth, id);
        compare::<16>(&mut check, &seen, truth, id);
        compare::<31>(&mut check, &seen, truth, id);
        compare::<81>(&mut check, &seen, truth, id);
        check.add_all(id, CIE_1931.sees(fine.onto(&vest)), truth);
    }
    check.tight(LIGHTS.len() * 18);
}

#[test]
fn a_grid_that_ends_within_the_absorption_loses_what_is_beyond() {
    // All of 360..=400 nm makes this one glow; FL lamps and LEDs have no light there, daylight has.
    let ultraviolet = Dye::new(
        &spectral(reflectance),
        &spectral::<Factor, 471, Nodes<360, 830>>(|nm| 0.9 * (1.0 - step(nm, 487.0, 7.0))),
        &spectral(emission),
        QUANTUM_YIELD as f32,
    )
    .expect("possible");
    let (_, daylight) = lamp("D65");
    let truth = CIE_1931.sees(daylight.onto(&ultraviolet))[1];
    let seen = |y: f32| (y / truth - 1.0).abs();
    let narrow: Observer<3, 60, Power> = CIE_1931.fold(Curve::Spline);
    let light: Light<60> = daylight.resample();
    let error = seen(narrow.sees(light.onto(&ultraviolet.resample()))[1]);
    assert!((0.02..0.05).contains(&error), "{error}");
    let wide: Observer<3, 60, Power, Bins<360, 730>> = CIE_1931.fold(Curve::Spline);
    let light: Light<60, Bins<360, 730>> = daylight.resample();
    let error = seen(wide.sees(light.onto(&ultraviolet.resample()))[1]);
    assert!(error < 1e-3, "{error}");
}

#[test]
fn a_matrix_of_the_dye_differs_by_what_the_dye_emits_at_shorter_waves() {
    let model = Model::new();
    let vest: Dye<31> = fine_vest().resample();
    let matrix: Donaldson<31, 496> = Donaldson::from_dye(&vest);
    let eye: Observer<3, 31, Power> = CIE_1931.fold(Curve::Spline);
    let mut worst = 0.0f64;
    for id in LIGHTS {
        let (values, fine) = lamp(id);
        let white = model.xyz(&values);
        let light: Light<31> = fine.resample();
        let one = lab(eye.sees(light.onto(&vest)).map(f64::from), white);
        let other = lab(eye.sees(light.onto(&matrix)).map(f64::from), white);
        worst = worst.max(de2000(one, other));
    }
    println!("matrix against dye: {worst:.3} CIEDE2000");
    assert!((0.075..0.085).contains(&worst), "{worst}");
}

#[test]
fn a_matrix_is_the_sum_over_all_pairs() {
    // Any numbers that keep energy: three columns of shares each below a third of what is left.
    let matrix: [[f32; 9]; 9] =
        from_fn(|k| from_fn(|i| if k < i { 0.0 } else { 0.1 * ((7 * k + 3 * i) % 11) as f32 / 11.0 }));
    let packed = Donaldson::<9, 45>::new(&matrix).expect("all possible");
    let light = Light::<9>::from_bins(from_fn(|i| 1.0 + ((5 * i) % 7) as f32));
    let leaving = light.onto(&packed).collected();
    let through = light.through(&packed).collected();
    assert_eq!(leaving, through);
    let mut check = check("light off a Donaldson matrix");
    for (k, got) in leaving.values().iter().enumerate() {
        let exact: f64 = (0..9).map(|i| f64::from(matrix[k][i]) * f64::from(light.values()[i])).sum();
        check.add(&format!("bin {k}"), *got, exact);
    }
    check.tight(9);
}

#[test]
fn a_matrix_without_fluorescence_is_its_diagonal_to_the_bit() {
    let (_, fine) = lamp("FL2");
    let light: Light<31> = fine.resample();
    let paper = spectral::<Factor, 31, Bins<380, 730>>(reflectance);
    let matrix: Donaldson<31, 496> = Donaldson::from_reflectance(&paper);
    assert_eq!(light.onto(&matrix).collected(), light.onto(&paper).collected());
    let eye: Observer<3, 31, Power> = CIE_1931.fold(Curve::Step);
    assert_eq!(eye.looking_at_donaldson(&matrix).weights(), eye.looking_at(&paper).weights());
}

#[test]
fn dyes_and_matrices_that_make_energy_or_photons_are_refused() {
    type G = Bins<350, 650>; // 400, 500, 600 nm
    let dye = |r: [f32; 3], a: [f32; 3], e: [f32; 3], q: f32| {
        Dye::<3, G>::new(&Spectrum::from_bins(r), &Spectrum::from_bins(a), &Spectrum::from_bins(e), q).err()
    };
    let (none, blue, green) = ([0.0; 3], [0.5, 0.0, 0.0], [0.0, 1.0, 0.0]);
    assert_eq!(dye(none, blue, green, 1.0), None);
    assert_eq!(dye(none, blue, none, 1.0), Some(FluorescenceError::NoEmission));
    for bad in [-0.1, 1.1, f32::NAN] {
        assert_eq!(dye(none, blue, green, bad), Some(FluorescenceError::QuantumYield));
    }
    for bad in [-0.1, f32::NAN, f32::INFINITY] {
        assert_eq!(dye([0.0, bad, 0.0], blue, green, 1.0), Some(FluorescenceError::OutOfRange { bin: 1 }));
        assert_eq!(dye(none, [0.0, 0.0, bad], green, 1.0), Some(FluorescenceError::OutOfRange { bin: 2 }));
        assert_eq!(dye(none, blue, [bad, 1.0, 0.0], 1.0), Some(FluorescenceError::OutOfRange { bin: 0 }));
    }
    assert_eq!(dye([0.6, 0.0, 0.0], blue, green, 1.0), Some(FluorescenceError::Energy { bin: 0 }));
    // At half the yield there is energy enough, as for the tails of real dyes.
    assert_eq!(dye(none, [0.0, 0.0, 1.0], green, 0.5), None);
    // A red photon that comes back as a green one brings 1.2 times its energy.
    assert_eq!(dye(none, [0.0, 0.0, 1.0], green, 1.0), Some(FluorescenceError::Energy { bin: 2 }));

    let matrix = |m: [[f32; 3]; 3]| Donaldson::<3, 6, G>::new(&m).err();
    assert_eq!(matrix([[0.2, 0.0, 0.0], [0.6, 0.0, 0.0], [0.0, 0.0, 1.0]]), None);
    assert_eq!(
        matrix([[0.2, 0.1, 0.0], [0.0; 3], [0.0; 3]]),
        Some(FluorescenceError::AntiStokes { from: 1, to: 0 })
    );
    assert_eq!(
        matrix([[0.3, 0.0, 0.0], [0.8, 0.0, 0.0], [0.0; 3]]),
        Some(FluorescenceError::Energy { bin: 0 })
    );
    assert_eq!(
        matrix([[0.3, 0.0, 0.0], [0.6, 0.0, 0.0], [0.0; 3]]),
        Some(FluorescenceError::Photons { bin: 0 })
    );
    assert_eq!(
        matrix([[0.0; 3], [0.0, -0.1, 0.0], [0.0; 3]]),
        Some(FluorescenceError::OutOfRange { bin: 1 })
    );
    let says = |error: FluorescenceError| error.to_string();
    assert!(says(FluorescenceError::AntiStokes { from: 1, to: 0 }).contains("bin 0"));
}

/// Each photon absorbed comes back as 0.85 photons, whatever the number of bins.
#[test]
fn the_dye_gives_back_its_quantum_yield_in_photons() {
    fn photons<const N: usize, G: Grid>(light: &Spectrum<Power, N, G>) -> f64 {
        light.iter().map(|(nm, power)| f64::from(power) * f64::from(nm)).sum::<f64>()
            * f64::from(Spectrum::<Power, N, G>::WIDTH_NM)
    }
    fn yields<const N: usize, G: Grid>(vest: &Dye<N, G>, bin: usize) -> f64 {
        let mut line = Spectrum::<Power, N, G>::flat(0.0);
        line.values_mut()[bin] = 1.0;
        let glow = line.onto(vest).collected() - line.onto(&vest.reflectance()).collected();
        photons(&glow) / photons(&line)
    }
    let mut check = check("photons of a dye");
    let fine = fine_vest();
    for bin in [40, 60, 90, 120] {
        let exact = QUANTUM_YIELD * f64::from(absorption(nm(bin)) as f32);
        check.value(&format!("{} nm", nm(bin)), yields(&fine, bin), exact);
    }
    check.tight(4);
    // In few bins the mean of wavelength times power is not the product of their means: 0.1 %.
    let coarse: Dye<31> = fine.resample();
    let bin = 5;
    let center = f64::from(Light::<31>::center_nm(bin));
    let ratio = yields(&coarse, bin) / (absorption(center) * QUANTUM_YIELD);
    assert!((ratio - 1.0).abs() < 2e-3, "{ratio}");
}

#[test]
fn afterglow_is_the_exact_exponential() {
    let vest: Dye<31> = fine_vest().resample();
    let lamp = Light::<31>::flat(1.0);
    let mut steady = Phosphor::new(vest, 1.0);
    steady.step(&lamp, 1e4);
    let saturated = f64::from(steady.glow());
    let (mut rise, mut fall) =
        (check("rise of a phosphor"), check("fall of a phosphor, in (lifetimes + 2) eps"));
    let (mut compared, mut dark) = (0, 0);
    for quarter in -240..=80 {
        let time = (f64::from(quarter) / 4.0).exp2() as f32 * 1.3;
        let share = -(-f64::from(time) / f64::from(0.7f32)).exp_m1();
        let mut rising = Phosphor::new(vest, 0.7);
        rising.step(&lamp, time);
        rise.value("", f64::from(rising.glow()) / (saturated * share), 1.0);
        let mut falling = Phosphor::new(vest, 0.7);
        falling.step(&lamp, 1e4);
        falling.step(&Light::flat(0.0), time);
        compared += 1;
        // Relative, as long as anything is left in f32.
        let lifetimes = f64::from(time) / f64::from(0.7f32);
        let left = saturated * (-lifetimes).exp();
        if left < 1e-30 {
            assert!(f64::from(falling.glow()) < 2e-30);
            dark += 1;
            continue;
        }
        let error = f64::from(falling.glow()) / left - 1.0;
        fall.value(&format!("{lifetimes} lifetimes"), error * 16_777_216.0 / (lifetimes + 2.0), 0.0);
    }
    rise.tight(compared);
    fall.tight(compared - dark);
}

#[test]
fn what_is_left_of_a_bright_glow_does_not_hide_a_dim_one() {
    let vest: Dye<31> = fine_vest().resample();
    let mut phosphor = Phosphor::new(vest, 1.0);
    phosphor.step(&Light::flat(1e8), 1e3);
    let dim = Light::<31>::flat(1e-3);
    phosphor.step(&dim, 50.0);
    assert_eq!(phosphor.glow(), vest.glow_under(&dim));
}

/// Steps of 2^-26 lifetimes are less than half the last digit of a glow.
#[test]
fn a_million_short_steps_are_one_long_one() {
    type One = Bins<500, 600>;
    let (half, lamp) = (Reflectance::<1, One>::flat(0.5), Light::<1, One>::flat(1.0));
    let dye = Dye::new(&half, &half, &lamp, 0.9).expect("possible");
    let full = f64::from(dye.glow_under(&lamp));
    let share = 2f64.powi(-26);
    let lifetimes = 1e6 * share;
    let mut check = check("a million short steps of a phosphor");
    for (first, then) in [(1.0f32, 0.0f32), (0.0, 1.0), (1.0, 0.5), (0.1, 1.0)] {
        let mut phosphor = Phosphor::new(dye, 64.0);
        phosphor.step(&Light::flat(first), 1e5);
        for _ in 0..1_000_000 {
            phosphor.step(&Light::flat(then), (64.0 * share) as f32);
        }
        let exact = full * (f64::from(first) * (-lifetimes).exp() - f64::from(then) * (-lifetimes).exp_m1());
        check.add(&format!("{first} to {then}"), phosphor.glow(), exact);
    }
    check.tight(4);
}

#[test]
fn a_glow_is_a_number_whatever_the_light_and_a_bad_time_is_none() {
    let vest: Dye<31> = fine_vest().resample();
    for lifetime in [0.0, 1e-30, 1.0, 1e30] {
        for bad in [-1.0, f32::NAN, f32::NEG_INFINITY] {
            let mut phosphor = Phosphor::new(vest, lifetime);
            phosphor.step(&Light::flat(1.0), bad);
            assert!(phosphor.glow().is_nan(), "{lifetime} {bad}");
        }
        let mut phosphor = Phosphor::new(vest, lifetime);
        for light in [3e36, 0.0, -3e36, 3e36, 1.0] {
            for time in [1e-30, 0.1, 1.0, 100.0, 1e30] {
                phosphor.step(&Light::flat(light), time);
                assert!(phosphor.glow().is_finite(), "{lifetime} {light} {time}");
            }
        }
    }
    let mut same = Phosphor::new(vest, 2.0);
    let mut fast = same;
    same.step_with::<Portable, _>(&Light::flat(1.0), 1.5);
    fast.step(&Light::flat(1.0), 1.5);
    assert_eq!(same, fast);
    fast.step_with::<Fast, _>(&Light::flat(0.0), 3.0);
    same.step(&Light::flat(0.0), 3.0);
    assert!((fast.glow() / same.glow() - 1.0).abs() < 3e-7);
}

#[test]
fn a_phosphor_at_rest_is_the_dye_and_a_lifetime_of_zero_too() {
    let (_, fine) = lamp("FL2");
    let light: Light<31> = fine.resample();
    let vest: Dye<31> = fine_vest().resample();
    let eye: Observer<3, 31, Power> = CIE_1931.fold(Curve::Step);
    for (lifetime, time) in [(1e-3, 1.0), (0.0, 1.0), (0.0, 0.0), (1e30, f32::INFINITY)] {
        let mut phosphor = Phosphor::new(vest, lifetime);
        phosphor.step(&light, time);
        assert_eq!(eye.sees(light.onto(&phosphor)), eye.sees(light.onto(&vest)), "{lifetime} {time}");
    }
    let mut phosphor = Phosphor::new(vest, 1.0);
    phosphor.step(&light, 0.0);
    assert_eq!(phosphor.glow(), 0.0);
    phosphor.step(&light, -1.0);
    assert!(phosphor.glow().is_nan(), "time does not run backwards");
}

#[test]
fn what_glows_has_its_price() {
    type Vest = Dye<31>;
    assert_eq!((Vest::PRICE.multiply_adds, Vest::PRICE.bytes), (93, 372));
    let (light, vest) = (Light::<31>::flat(1.0), fine_vest().resample::<31, _>());
    let (paper, matrix) = (Reflectance::flat(0.5), Donaldson::<31, 496>::from_dye(&vest));
    // Light that comes by way of the paper is worked out twice: for what the dye absorbs, and for what it
    // reflects.
    let price = light.onto(&paper).onto(&vest).price();
    assert_eq!((price.multiply_adds, price.bytes), (31 + 93 + 31, 124 + 124 + 372));
    let price = light.onto(&paper).onto(&matrix).onto(&vest).price();
    assert_eq!(price.multiply_adds, 31 + 496 + 93, "what left the matrix is not worked out again");
    assert_eq!(price.effects, Effects::FLUORESCENCE);
    let price = light.onto(&Phosphor::new(vest, 1.0)).onto(&vest).price();
    assert!(price.effects.names().eq(["fluorescence", "phosphorescence"]));
}

fn factors<const N: usize>() -> impl Strategy<Value = Reflectance<N>> {
    prop::collection::vec(0.0f32..1.0, N).prop_map(|values| {
        let mut factors = Reflectance::flat(0.0);
        factors.values_mut().copy_from_slice(&values);
        factors
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn folding_a_dye_is_walking_to_it(
        light in factors::<31>(), r in factors::<31>(), a in factors::<31>(), e in factors::<31>(),
        glass in factors::<31>(), paper in factors::<31>(),
    ) {
        let light = Light::<31>::from_bins(*light.values());
        let dye = Dye::new(&(r * 0.5), &(a * 0.3), &Light::from_bins(*e.values()), 0.9).expect("possible");
        let matrix: Donaldson<31, 496> = Donaldson::from_dye(&dye);
        let eye: Observer<3, 31, Power> = CIE_1931.fold(Curve::Step);
        let walked = eye.sees(light.onto(&paper).onto(&dye).through(&glass));
        let folded = eye.through(&glass).looking_at_dye(&dye).looking_at(&paper);
        let under = folded.under(&light).sees(&Reflectance::flat(1.0));
        for ((walked, folded), under) in walked.into_iter().zip(folded.sees(&light)).zip(under) {
            prop_assert!((walked - folded).abs() <= 4e-7 * walked, "{walked} {folded}");
            prop_assert!((walked - under).abs() <= 4e-7 * walked, "{walked} {under}");
        }
        let walked = eye.sees(light.onto(&paper).onto(&matrix).through(&glass));
        let folded = eye.through(&glass).looking_at_donaldson(&matrix).looking_at(&paper).sees(&light);
        for (walked, folded) in walked.into_iter().zip(folded) {
            prop_assert!((walked - folded).abs() <= 4e-7 * walked, "{walked} {folded}");
        }
    }

    #[test]
    fn two_steps_of_afterglow_are_one(
        first in 0.0f32..10.0, second in 0.0f32..10.0, lifetime in 0.01f32..100.0, start in 0.0f32..10.0,
    ) {
        let vest: Dye<31> = fine_vest().resample();
        let (bright, dim) = (Light::<31>::flat(5.0), Light::<31>::flat(0.3));
        let mut twice = Phosphor::new(vest, lifetime);
        twice.step(&bright, start);
        let mut once = twice;
        twice.step(&dim, first);
        twice.step(&dim, second);
        once.step(&dim, first + second);
        // The sum of the times is rounded too: half a unit, of up to 20 s.
        let excuse = 4e-7 + 2e-7 * (first + second) / lifetime;
        prop_assert!((twice.glow() - once.glow()).abs() <= excuse * once.glow(), "{} {}", twice.glow(), once.glow());
    }
}
