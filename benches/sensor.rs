//! Times the way from the counts of a sensor chip to a color, on a host. The instructions that a
//! microcontroller needs for it are counted by `tests/devices.sh`. An id reads `sensor/operation/N/backend`,
//! where N is the number of channels, bands or patches.
//!
//! Every result is compared with what is expected before it is timed.

use criterion::{BatchSize, BenchmarkId, Criterion};
use nanospectra::color::Cct;
use nanospectra::math::Fast;
use nanospectra::observer::CIE_1931;
use nanospectra::sensor::fixed::{FixedCct, FixedMeter, FixedObserver};
use nanospectra::sensor::{
    BasicCounts, Calibration, DEFAULT_ALPHA, Exposure, Fit, Meter, Reconstruction, chip::as7341,
    nonnegative_spectrum,
};
use nanospectra::{Curve, Light, Nodes, Observer, Power, const_unwrap};
use std::hint::black_box;

type Grid = Nodes<400, 700>;
static CHIP: Observer<8, 31, Power, Grid> = as7341::NOMINAL.fold(Curve::Step);
static EYE: Observer<3, 31, Power, Grid> = CIE_1931.fold(Curve::Step);
static SPECTRUM: Reconstruction<8, 31, Grid> =
    const_unwrap!(Reconstruction::smooth(&CHIP, 0.95, DEFAULT_ALPHA));
static TO_XYZ: Calibration<8> = SPECTRUM.seen_by(&EYE);
const EXPOSURE: Exposure = as7341::exposure(16.0, 29, 599);
static METER: Meter<8> = Meter::new(&EXPOSURE, &TO_XYZ);
static FIXED: FixedMeter<8> = FixedMeter::new(&EXPOSURE, &TO_XYZ).unwrap();

/// One reading, from the counts on the bus to XYZ, CCT, Duv and Lab.
fn reading(c: &mut Criterion) {
    // A flat light: equal energy, x = y = 1/3.
    let flat = CHIP.sees(&Light::flat(1.0));
    let largest = flat.iter().copied().fold(0.0, f32::max);
    let counts: [u16; 8] = flat.map(|x| (x / largest * 12_000.0) as u16);
    let white = METER.xyz(&counts).expect("light");
    let xy = white.xy().expect("light");
    assert!((xy.x - 0.333).abs() < 0.01 && (xy.y - 0.333).abs() < 0.01, "{xy:?}");
    let Some(FixedCct::Near { cct_k, .. }) = FIXED.xyz(&counts).expect("light").cct() else {
        panic!("no white")
    };
    let (kelvin, _) = white.cct().and_then(Cct::near).expect("a white");
    assert!((cct_k as f32 - kelvin).abs() < 5.0, "{cct_k} {kelvin}");

    let mut group = c.benchmark_group("sensor/reading");
    group.bench_function(BenchmarkId::new("8", "f32"), |b| {
        b.iter(|| {
            let xyz = METER.xyz(black_box(&counts)).ok()?;
            Some((xyz, xyz.uv1960()?.cct(), xyz.lab_with::<Fast>(white)?))
        });
    });
    group.bench_function(BenchmarkId::new("8", "fixed"), |b| {
        b.iter(|| FIXED.xyz(black_box(&counts)).ok().map(|xyz| (xyz.lux(), xyz.cct())));
    });
    group.finish();
}

/// A spectrum from the counts: by a matrix, and by the method whose powers are never negative.
fn spectrum(c: &mut Criterion) {
    let basic = BasicCounts::new(CHIP.sees(&Light::flat(2.0)));
    assert!((SPECTRUM.spectrum(&basic).values()[15] - 2.0).abs() < 0.1);
    let mut group = c.benchmark_group("sensor/spectrum");
    group.bench_function(BenchmarkId::new("31", "smooth"), |b| {
        b.iter(|| SPECTRUM.spectrum(black_box(&basic)))
    });
    group.bench_function(BenchmarkId::new("31", "nonnegative"), |b| {
        b.iter(|| nonnegative_spectrum(&CHIP, black_box(&basic), DEFAULT_ALPHA, 50));
    });
    group.finish();
}

/// A calibration fitted to 24 patches, of which `EYE` gives the XYZ.
fn fit(c: &mut Criterion) {
    let patches: Vec<_> = (0..24)
        .map(|k| {
            let light = Light::from_bins(core::array::from_fn(|n| 1.0 + ((n * (k + 3)) as f32 * 0.37).sin()));
            (BasicCounts::new(CHIP.sees(&light)), EYE.sees(&light))
        })
        .collect();
    let solve = |patches: &[(BasicCounts<8>, [f32; 3])]| {
        let mut fit = Fit::<8>::new();
        patches.iter().for_each(|(basic, xyz)| fit.add_relative(basic, (*xyz).into()));
        fit.solve()
    };
    let [_, y, _] = solve(&patches).expect("patches that differ").apply(&patches[5].0);
    assert!((y / patches[5].1[1] - 1.0).abs() < 0.1, "{y}");
    c.bench_function("sensor/fit/24/f32", |b| b.iter(|| solve(black_box(&patches))));
}

/// XYZ from 81 bands of 16 bits, in integers.
fn bands(c: &mut Criterion) {
    static WIDE: Observer<3, 81, Power, Nodes<380, 780>> = CIE_1931.fold(Curve::Spline);
    static FIXED: FixedObserver<3, 81, Nodes<380, 780>> = FixedObserver::new(&WIDE).unwrap();
    let y = FIXED.sees(&[40_000; 81])[1] as f32 * FIXED.unit() / 40_000.0;
    assert!((y / 106.857 - 1.0).abs() < 1e-3, "{y}");
    c.bench_function("sensor/bands/81/fixed", |b| {
        b.iter_batched_ref(|| [40_000; 81], |samples| FIXED.sees(black_box(samples)), BatchSize::SmallInput);
    });
}

fn main() {
    let mut c = Criterion::default().configure_from_args();
    reading(&mut c);
    spectrum(&mut c);
    fit(&mut c);
    bands(&mut c);
    c.final_summary();
}
