//! Spectrum to XYZ: this crate, the `wide` crate's f32x8 by hand, and the std crate `colorimetry`.
//!
//! Every bench checks its result against f64 first. `--features simd` selects the vector kernel; its
//! results have the same bits. At the end the ratios are printed beside what the project asks for.

mod ratios;

use colorimetry::observer::Observer as StdObserver;
use colorimetry::spectrum::Spectrum as StdSpectrum;
use criterion::{BenchmarkId, Criterion};
use nanospectra::observer::CIE_1931;
use nanospectra::{Curve, Interpolation, Light, Nodes, Observer, Outside, Power, light};
use ratios::Ratio;
use std::hint::black_box;

/// The hand-written yardstick: one pass over three rows with explicit vectors.
fn wide_one_pass<const N: usize>(rows: &[[f32; N]; 3], s: &[f32; N]) -> [f32; 3] {
    use wide::f32x8;
    let (mut x, mut y, mut z) = (f32x8::ZERO, f32x8::ZERO, f32x8::ZERO);
    let mut k = 0;
    while k + 8 <= N {
        let at = |row: &[f32; N]| f32x8::from(<[f32; 8]>::try_from(&row[k..k + 8]).expect("eight"));
        let power = at(s);
        x += at(&rows[0]) * power;
        y += at(&rows[1]) * power;
        z += at(&rows[2]) * power;
        k += 8;
    }
    let mut sums = [x.reduce_add(), y.reduce_add(), z.reduce_add()];
    while k < N {
        for (sum, row) in sums.iter_mut().zip(rows) {
            *sum += row[k] * s[k];
        }
        k += 1;
    }
    sums
}

fn near(name: &str, got: [f64; 3], truth: [f64; 3]) {
    for (got, truth) in got.iter().zip(truth) {
        assert!((got / truth - 1.0).abs() < 1e-6, "{name}: {got} for {truth}");
    }
}

/// One lamp on `N` nodes over 380..=780 nm.
fn bands<const N: usize>(c: &mut Criterion) {
    let eye: Observer<3, N, Power, Nodes<380, 780>> = CIE_1931.fold(Curve::Step);
    let lamp: Light<N, Nodes<380, 780>> = light::LED_B3_1NM.interpolate(Interpolation::Linear, Outside::Zero);
    let terms = |row: &[f32; N]| row.iter().zip(lamp.values()).map(|(w, s)| f64::from(w * s)).sum::<f64>();
    let truth = eye.weights().each_ref().map(terms);
    near("sees", eye.sees(&lamp).map(f64::from), truth);
    near("wide", wide_one_pass(eye.weights(), lamp.values()).map(f64::from), truth);

    let mut group = c.benchmark_group("observer_xyz");
    group.bench_function(BenchmarkId::new("nanospectra", N), |b| {
        b.iter(|| black_box(&eye).sees(black_box(&lamp)));
    });
    group.bench_function(BenchmarkId::new("wide_by_hand", N), |b| {
        b.iter(|| wide_one_pass(black_box(eye.weights()), black_box(lamp.values())));
    });
    group.finish();
}

/// A thousand spectra of 81 bands in one call; divide by 1000.
fn batch(c: &mut Criterion) {
    let eye: Observer<3, 81, Power, Nodes<380, 780>> = CIE_1931.fold(Curve::Step);
    let lamps: Vec<Light<81, Nodes<380, 780>>> = (0..1000).map(|k| light::FL11 * (1.0 + k as f32)).collect();
    let mut reports = vec![[0.0; 3]; lamps.len()];
    eye.sees_each(&lamps, &mut reports);
    assert!(lamps.iter().zip(&reports).all(|(lamp, report)| eye.sees(lamp) == *report));
    c.bench_function("observer_xyz/batch_of_1000/81", |b| {
        b.iter(|| black_box(&eye).sees_each(black_box(&lamps), black_box(&mut reports)));
    });
}

/// The std crate has one grid: 401 points, in f64.
fn std_reference(c: &mut Criterion) {
    let lamp: [f64; 401] = light::LED_B3_1NM.values().map(f64::from);
    let ours: Observer<3, 401, Power, Nodes<380, 780>> = CIE_1931.fold(Curve::Step);
    let spectrum = StdSpectrum::from(lamp);
    let xyz = || StdObserver::Cie1931.xyz_from_spectrum(black_box(&spectrum));
    let ([x, y, z], own) = (xyz().to_array(), ours.sees(&light::LED_B3_1NM).map(f64::from));
    // It scales to lumens, and has nothing below 380 and above 780 nm.
    assert!(
        ((x / y) / (own[0] / own[1]) - 1.0).abs() < 1e-5 && ((z / y) / (own[2] / own[1]) - 1.0).abs() < 1e-5
    );
    let mut group = c.benchmark_group("observer_xyz");
    group.bench_function(BenchmarkId::new("colorimetry", 401), |b| b.iter(xyz));
    group.finish();
}

fn main() {
    let mut c = Criterion::default().configure_from_args();
    bands::<16>(&mut c);
    bands::<31>(&mut c);
    bands::<81>(&mut c);
    bands::<401>(&mut c);
    batch(&mut c);
    std_reference(&mut c);
    c.final_summary();

    let (wide, std) = (if cfg!(feature = "simd") { 1.3 } else { 2.0 }, "observer_xyz/colorimetry/401");
    ratios::print(&[
        Ratio::at_most("observer_xyz/nanospectra/81", "observer_xyz/wide_by_hand/81", wide),
        Ratio::at_most("observer_xyz/nanospectra/81", std, 1.0 / 10.0),
        Ratio::at_most("observer_xyz/nanospectra/401", std, 1.0 / 4.0),
    ]);
}
