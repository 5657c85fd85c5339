//! Times the way from an RGB color to a spectrum: each method for one color and for eight at a time, reading
//! spectra from stored coefficients, and the crate `rgb2spec`. An id reads `upsample/operation/N/method`,
//! where N is the number of bands.
//!
//! The colors are 4096 of the sRGB cube in a fixed order, so that branches are mixed as in an image. A time
//! is that of one color; with `reflectance-of-8` it is that of eight, and with `stored` that of a spectrum.
//! `coefficients` times what `rgb2spec` finds in its table of 16^3 cells, without making a spectrum of it.
//!
//! Every result is compared with the color that it should give before it is timed.

use criterion::{BenchmarkId, Criterion, Throughput};
use nanospectra::color::{EncodedRgb, Rgb, Srgb};
use nanospectra::light::D65;
use nanospectra::observer::CIE_1931;
use nanospectra::upsample::{
    Basis, CubicStart, LinearStart, QuinticStart, Sigmoid, SigmoidReflectance, Smits, StartMap, Viewing,
};
use nanospectra::{Bins, Curve, Fine, Grid, Nodes, Power, Reflectance};
use rgb2spec::optimize::{gamut::Gamut, optimize};
use std::hint::black_box;

static LIGHT: Fine<Power> = D65.fine();

fn codes() -> Vec<[u8; 3]> {
    let mut state = 12345u32;
    let mut next = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 24) as u8
    };
    (0..4096).map(|_| [next(), next(), next()]).collect()
}

fn linear(codes: &[[u8; 3]]) -> Vec<Rgb<Srgb>> {
    codes.iter().map(|c| EncodedRgb::<Srgb>::from_u8(*c).decode()).collect()
}

/// Times a function on the inputs in turn.
fn each<T: Copy, R>(c: &mut Criterion, op: &str, id: BenchmarkId, inputs: &[T], f: impl Fn(T) -> R) {
    let mut next = 0;
    c.benchmark_group(format!("upsample/{op}")).bench_function(id, |b| {
        b.iter(|| {
            next = (next + 1) % inputs.len();
            f(black_box(inputs[next]))
        });
    });
}

/// The method `Sigmoid`, with one of its maps of start values.
fn solver<const N: usize, G: Grid, M: StartMap>(c: &mut Criterion, name: &str) {
    let viewing: Viewing<N, G> = Viewing::new(&CIE_1931.under(&LIGHT).fold(Curve::Step));
    let sigmoid: Sigmoid<N, G, Srgb, M> = Sigmoid::new(&viewing);
    let codes = codes();
    let colors = linear(&codes);
    for (code, rgb) in codes.iter().zip(&colors) {
        let spectrum = sigmoid.reflectance(*rgb).spectrum.on_grid();
        assert_eq!(viewing.rgb(&spectrum).encode().to_u8(), *code);
    }
    let eights: Vec<[Rgb<Srgb>; 8]> = colors.as_chunks::<8>().0.to_vec();
    for eight in &eights {
        assert_eq!(sigmoid.reflectance_8(eight), eight.map(|rgb| sigmoid.reflectance(rgb)));
    }
    each(c, "reflectance", BenchmarkId::new(N.to_string(), name), &colors, |rgb| sigmoid.reflectance(rgb));
    let mut group = c.benchmark_group("upsample/reflectance-of-8");
    group.throughput(Throughput::Elements(8));
    let mut next = 0;
    group.bench_function(BenchmarkId::new(N.to_string(), name), |b| {
        b.iter(|| {
            next = (next + 1) % eights.len();
            sigmoid.reflectance_8(black_box(&eights[next]))
        });
    });
}

/// A spectrum from stored coefficients.
fn reading<const N: usize, G: Grid>(c: &mut Criterion) {
    let curve = SigmoidReflectance::from_texel([3.0, -4.0, 0.5, 0.75]);
    let on_grid: Reflectance<N, G> = curve.on_grid();
    for (nm, share) in on_grid.iter() {
        assert!((curve.at(nm) - share).abs() < 1e-6);
    }
    let mut group = c.benchmark_group("upsample/stored");
    group.throughput(Throughput::Elements(N as u64));
    group.bench_function(BenchmarkId::new(N.to_string(), "on_grid"), |b| {
        b.iter(|| black_box(curve).on_grid::<N, G>());
    });
}

/// The methods `Basis` and `Smits`.
fn linear_methods(c: &mut Criterion) {
    let viewing: Viewing<31, Nodes<400, 700>> = Viewing::new(&CIE_1931.under(&LIGHT).fold(Curve::Step));
    let (basis, smits) = (Basis::new(&viewing), Smits::<31, Nodes<400, 700>>::new());
    let codes = codes();
    let colors = linear(&codes);
    for (code, rgb) in codes.iter().zip(&colors) {
        assert_eq!(viewing.rgb(&basis.reflectance(*rgb)).encode().to_u8(), *code);
        assert!(viewing.delta_e(*rgb, &smits.reflectance(*rgb)) < 3.0);
    }
    each(c, "reflectance", BenchmarkId::new("31", "basis"), &colors, |rgb| basis.reflectance(rgb));
    each(c, "reflectance", BenchmarkId::new("31", "smits"), &colors, |rgb| smits.reflectance(rgb));
}

/// The crate `rgb2spec`.
fn peer(c: &mut Criterion) {
    let table = optimize(Gamut::SRGB, 16).expect("a table");
    let colors: Vec<[f32; 3]> = linear(&codes()).iter().map(|rgb| rgb.to_array()).collect();
    let read = |rgb: [f32; 3]| {
        let coefficients = table.fetch(rgb);
        let mut values = [0.0; 31];
        for (k, value) in values.iter_mut().enumerate() {
            *value = rgb2spec::eval_precise(coefficients, 400.0 + 10.0 * k as f32);
        }
        values
    };
    assert!((read([0.5; 3])[15] - 0.5).abs() < 1e-2);
    each(c, "coefficients", BenchmarkId::new("3", "rgb2spec-16"), &colors, |rgb| table.fetch(rgb));
    each(c, "reflectance", BenchmarkId::new("31", "rgb2spec-16"), &colors, read);
}

fn main() {
    let mut c = Criterion::default().configure_from_args();
    solver::<31, Nodes<400, 700>, CubicStart>(&mut c, "cubic");
    solver::<31, Nodes<400, 700>, LinearStart>(&mut c, "linear");
    solver::<31, Nodes<400, 700>, QuinticStart>(&mut c, "quintic");
    solver::<60, Bins<400, 700>, CubicStart>(&mut c, "cubic");
    solver::<81, Nodes<380, 780>, CubicStart>(&mut c, "cubic");
    reading::<31, Nodes<400, 700>>(&mut c);
    reading::<81, Nodes<380, 780>>(&mut c);
    linear_methods(&mut c);
    peer(&mut c);
    c.final_summary();
}
