//! From XYZ to what it means: this crate beside the std crate `colorimetry`.
//!
//! Both are given the same lamp, and their results are compared before anything is timed.

mod ratios;

use colorimetry::illuminant::Illuminant;
use colorimetry::spectrum::Spectrum as StdSpectrum;
use criterion::{BenchmarkId, Criterion};
use nanospectra::color::transfer::{Srgb, Transfer};
use nanospectra::color::{Lab, Uv1960, Xy, Xyz, ciede2000, cri, dominant_wavelength, tm30};
use nanospectra::observer::CIE_1931;
use nanospectra::{Fine, Interpolation, Outside, Power, light};
use ratios::Ratio;
use std::hint::black_box;

fn lamp() -> Fine<Power> {
    light::FL2_1NM.interpolate(Interpolation::Linear, Outside::Zero)
}

fn std_lamp() -> Illuminant {
    Illuminant::new(StdSpectrum::from(light::FL2_1NM.values().map(f64::from)))
}

fn near(what: &str, got: f64, expected: f64, tolerance: f64) {
    assert!((got - expected).abs() <= tolerance, "{what}: {got} for {expected}");
}

/// Steps from XYZ, none of which needs the 1 nm tables, but for the dominant wavelength.
fn point(c: &mut Criterion) {
    let xyz = Xyz::from(CIE_1931.sees(&lamp())).with_y(100.0).expect("visible");
    let (uv, xy) = (xyz.uv1960().expect("visible"), xyz.xy().expect("visible"));
    near("CCT", uv.cct().near().expect("white").0.into(), 4225.0, 10.0);
    c.bench_function("color_cct", |b| b.iter(|| Uv1960::cct(black_box(uv))));

    let (paint, white) = (Xyz::new(19.01, 20.0, 21.78), Xyz::new(95.047, 100.0, 108.883));
    near("L*", paint.lab(white).expect("white").l.into(), 51.837, 1e-3);
    c.bench_function("color_lab", |b| b.iter(|| black_box(paint).lab(black_box(white))));

    let pair = (Lab::new(50.0, 2.6772, -79.7751), Lab::new(50.0, 0.0, -82.7485));
    near("CIEDE2000", ciede2000(pair.0, pair.1).into(), 2.0425, 1e-4);
    c.bench_function("color_ciede2000", |b| b.iter(|| ciede2000(black_box(pair.0), black_box(pair.1))));

    near("sRGB", Srgb::encode(0.5).into(), 0.735_357, 1e-6);
    c.bench_function("color_srgb_encode", |b| b.iter(|| Srgb::encode(black_box(0.5))));

    let white = Xy::new(1.0 / 3.0, 1.0 / 3.0);
    let dominant = || dominant_wavelength(black_box(xy), white, &CIE_1931);
    near("dominant wavelength", dominant().expect("not white").nm.into(), 576.6, 1.0);
    c.bench_function("color_dominant_wavelength", |b| b.iter(dominant));
}

fn rendering(c: &mut Criterion) {
    let (lamp, std_lamp) = (lamp(), std_lamp());
    let ours = (cri(&lamp).expect("white"), tm30(&lamp).expect("white"));
    near("Ra", ours.0.ra.into(), std_lamp.cri().expect("white").ra(), 0.5);

    let mut group = c.benchmark_group("color_cri");
    group.bench_function(BenchmarkId::new("nanospectra", 15), |b| b.iter(|| cri(black_box(&lamp))));
    group.bench_function(BenchmarkId::new("colorimetry", 14), |b| b.iter(|| black_box(&std_lamp).cri()));
    group.finish();

    near("Rf", ours.1.rf.into(), 70.1, 0.3);
    let mut group = c.benchmark_group("color_tm30");
    group.bench_function(BenchmarkId::new("nanospectra", 99), |b| b.iter(|| tm30(black_box(&lamp))));
    group.bench_function(BenchmarkId::new("colorimetry", 99), |b| b.iter(|| black_box(&std_lamp).cfi()));
    group.finish();
}

fn main() {
    let mut c = Criterion::default().configure_from_args();
    point(&mut c);
    rendering(&mut c);
    c.final_summary();
    ratios::print(&[
        Ratio::at_most("color_cri/nanospectra/15", "color_cri/colorimetry/14", 1.0),
        Ratio::at_most("color_tm30/nanospectra/99", "color_tm30/colorimetry/99", 1.0),
    ]);
}
