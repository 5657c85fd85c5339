//! The way from a spectrum to XYZ, beside vectors written by hand, the peak of the core and the crate
//! `colorimetry`; and single sums in other orders of summation.

use crate::race::Races;
use colorimetry::observer::Observer as StdObserver;
use colorimetry::spectrum::Spectrum as StdSpectrum;
use nanospectra::observer::CIE_1931;
use nanospectra::{Curve, Grid, Interpolation, Light, Nodes, Observer, Power, light};
use std::hint::black_box;
use yardsticks::{exact, multiply_and_add, naive, pairwise, wide_one_pass};

type Usual = Nodes<380, 780>;

pub fn all(races: &mut Races) {
    single::<16, Usual>(races);
    single::<31, Usual>(races);
    single::<60, Usual>(races);
    single::<81, Usual>(races);
    single::<401, Usual>(races);
    single::<471, Nodes<360, 830>>(races);
    batch::<16, Usual>(races);
    batch::<31, Usual>(races);
    batch::<60, Usual>(races);
    batch::<81, Usual>(races);
    batch::<401, Usual>(races);
    batch::<471, Nodes<360, 830>>(races);
    beside_colorimetry::<81>(races, 10.0);
    beside_colorimetry::<401>(races, 4.0);
    sums::<31>(races);
    sums::<81>(races);
    sums::<471>(races);
}

fn eye<const N: usize, G: Grid>() -> Observer<3, N, Power, G> {
    CIE_1931.fold(Curve::Step)
}

fn lamp<const N: usize, G: Grid>() -> Light<N, G> {
    light::LED_B3_1NM.interpolate(Interpolation::Linear)
}

/// Compares three results with the exact sums.
fn check<const N: usize>(rows: &[[f32; N]; 3], s: &[f32; N], found: [f32; 3]) {
    for (row, found) in rows.iter().zip(found) {
        let truth = exact(row, s);
        assert!((f64::from(found) / truth - 1.0).abs() < 1e-6, "N = {N}: {found} for {truth}");
    }
}

/// One spectrum, beside vectors written by hand.
fn single<const N: usize, G: Grid>(races: &mut Races) {
    let (eye, lamp) = (eye::<N, G>(), lamp::<N, G>());
    check(eye.weights(), lamp.values(), eye.sees(&lamp));
    check(eye.weights(), lamp.values(), wide_one_pass(eye.weights(), lamp.values()));
    races.run(
        format!("{N} bands to XYZ"),
        1.0 / 1.3,
        1.0,
        || black_box(&eye).sees(black_box(&lamp)),
        ("wide, one pass by hand", || wide_one_pass(black_box(eye.weights()), black_box(lamp.values()))),
    );
}

/// A batch of 1000 spectra, beside as many multiplications and additions at the peak of the core.
fn batch<const N: usize, G: Grid>(races: &mut Races) {
    let eye = eye::<N, G>();
    let lamps: Vec<Light<N, G>> = (0..1000).map(|k| lamp::<N, G>() * (1.0 + k as f32)).collect();
    let mut reports = vec![[0.0; 3]; lamps.len()];
    eye.sees_each(&lamps, &mut reports);
    for (lamp, report) in lamps.iter().zip(&reports) {
        assert_eq!(eye.sees(lamp), *report);
        check(eye.weights(), lamp.values(), *report);
    }
    races.run(
        format!("{N} bands to XYZ, each of 1000"),
        (N == 81).then_some(0.8),
        1000.0,
        || black_box(&eye).sees_each(black_box(&lamps), black_box(&mut reports)),
        ("multiply + add, peak", || multiply_and_add(1000 * 3 * N)),
    );
}

/// One spectrum, beside the crate `colorimetry`. That crate has a single grid, 401 points of f64 from 380 to
/// 780 nm, and scales its results to lumens, so the ratios of X, Y and Z are compared.
fn beside_colorimetry<const N: usize>(races: &mut Races, bar: f64) {
    let (eye, lamp) = (eye::<N, Usual>(), lamp::<N, Usual>());
    let spectrum = StdSpectrum::from(light::LED_B3_1NM.values().map(f64::from));
    let [x, y, z] = StdObserver::Cie1931.xyz_from_spectrum(&spectrum).to_array();
    let own = lamp_at_every_nm();
    assert!(
        ((x / y) / (own[0] / own[1]) - 1.0).abs() < 1e-5 && ((z / y) / (own[2] / own[1]) - 1.0).abs() < 1e-5
    );
    races.run(
        format!("{N} bands to XYZ"),
        bar,
        1.0,
        || black_box(&eye).sees(black_box(&lamp)),
        ("colorimetry, 401 of f64", || StdObserver::Cie1931.xyz_from_spectrum(black_box(&spectrum))),
    );
}

/// XYZ of the lamp on the grid of `colorimetry`.
fn lamp_at_every_nm() -> [f64; 3] {
    eye::<401, Usual>().sees(&light::LED_B3_1NM).map(f64::from)
}

/// Sums of products of random numbers. Errors are in units of 2^-24 of the sum.
fn sums<const N: usize>(races: &mut Races) {
    let mut state = 1u64;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((state >> 40) as f32 + 1.0) / 16_777_216.0
    };
    let cases: Vec<[[f32; N]; 2]> =
        (0..500).map(|_| [[(); N].map(|()| random()), [(); N].map(|()| random())]).collect();
    let lanes = |row: &[f32; N], s: &[f32; N]| {
        let [sum] =
            Observer::<1, N, Power, Usual>::from_weights([*row]).sees(&Light::<N, Usual>::from_bins(*s));
        sum
    };
    let worst = |sum: &dyn Fn(&[f32; N], &[f32; N]) -> f32| {
        let error =
            |[row, s]: &[[f32; N]; 2]| (f64::from(sum(row, s)) / exact(row, s) - 1.0).abs() * 2f64.powi(24);
        cases.iter().map(error).fold(0.0, f64::max)
    };
    let errors = [worst(&lanes), worst(&|a, b| naive(a, b)), worst(&|a, b| pairwise(a, b))];
    assert!(errors[0] < 8.0, "{errors:?}");

    let [row, s] = cases[0];
    let (eye, light) = (Observer::<1, N, Power, Usual>::from_weights([row]), Light::<N, Usual>::from_bins(s));
    let what = || format!("sum of {N} products (errors in e)");
    let ours = || black_box(&eye).sees(black_box(&light));
    races.run(what(), None, 1.0, ours, ("plain loop", || naive(black_box(&row), black_box(&s))));
    races.errors(errors[0], errors[1]);
    races.run(what(), None, 1.0, ours, ("pairwise", || pairwise(black_box(&row), black_box(&s))));
    races.errors(errors[0], errors[2]);
}
