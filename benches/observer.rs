//! Times the way from a spectrum to XYZ, for one spectrum and for a batch of 1000, beside vectors written by
//! hand, three orders of summation, and the most that the core can do. An id reads
//! `observer/operation/N/backend`, where N is the number of bands. The bench `peers` prints the ratios.
//!
//! Every result is compared with the exact sum of the same products before it is timed. Wider vectors
//! (`RUSTFLAGS="-C target-cpu=x86-64-v3"`, or `--features simd` on hosts other than x86-64) give the same
//! bits.

use criterion::{Criterion, Throughput};
use nanospectra::observer::CIE_1931;
use nanospectra::{Curve, Grid, Interpolation, Light, Nodes, Observer, Power, light};
use std::hint::black_box;
use yardsticks::{exact, multiply_and_add, naive, pairwise, wide_one_pass};

const BACKEND: &str = if cfg!(feature = "simd") { "simd" } else { "default" };

fn near(found: f32, truth: f64) {
    assert!((f64::from(found) / truth - 1.0).abs() < 2e-6, "{found} for {truth}");
}

/// One lamp, and a thousand lamps, on `N` nodes.
fn bands<const N: usize, G: Grid>(c: &mut Criterion) {
    let eye: Observer<3, N, Power, G> = CIE_1931.fold(Curve::Step);
    let lamp: Light<N, G> = light::LED_B3_1NM.interpolate(Interpolation::Linear);
    let by_hand = wide_one_pass(eye.weights(), lamp.values());
    for ((row, ours), by_hand) in eye.weights().iter().zip(eye.sees(&lamp)).zip(by_hand) {
        near(ours, exact(row, lamp.values()));
        near(by_hand, exact(row, lamp.values()));
    }
    let mut group = c.benchmark_group(format!("observer/xyz/{N}"));
    group.bench_function(BACKEND, |b| b.iter(|| black_box(&eye).sees(black_box(&lamp))));
    group.bench_function("wide-by-hand", |b| {
        b.iter(|| wide_one_pass(black_box(eye.weights()), black_box(lamp.values())));
    });
    group.finish();

    let lamps: Vec<Light<N, G>> = (0..1000).map(|k| lamp * (1.0 + k as f32)).collect();
    let mut reports = vec![[0.0; 3]; lamps.len()];
    eye.sees_each(&lamps, &mut reports);
    assert!(lamps.iter().zip(&reports).all(|(lamp, report)| eye.sees(lamp) == *report));
    let mut group = c.benchmark_group(format!("observer/xyz-of-1000/{N}"));
    group.throughput(Throughput::Elements(1000));
    group.bench_function(BACKEND, |b| {
        b.iter(|| black_box(&eye).sees_each(black_box(&lamps), black_box(&mut reports)));
    });
    // The same number of multiplications and additions, as fast as the core can do them.
    group.bench_function("peak", |b| b.iter(|| multiply_and_add(1000 * 3 * N)));
    group.finish();
}

/// One sum of `N` products by three orders of summation.
fn sums<const N: usize>(c: &mut Criterion) {
    let row = core::array::from_fn::<f32, N, _>(|k| 1.0 / (1.0 + k as f32));
    let s = core::array::from_fn::<f32, N, _>(|k| 1.0 + (k % 7) as f32);
    let (eye, light) = (
        Observer::<1, N, Power, Nodes<360, 830>>::from_weights([row]),
        Light::<N, Nodes<360, 830>>::from_bins(s),
    );
    let truth = exact(&row, &s);
    near(eye.sees(&light)[0], truth);
    near(naive(&row, &s), truth);
    near(pairwise(&row, &s), truth);
    let mut group = c.benchmark_group(format!("observer/sum/{N}"));
    group.bench_function("lanes", |b| b.iter(|| black_box(&eye).sees(black_box(&light))));
    group.bench_function("naive", |b| b.iter(|| naive(black_box(&row), black_box(&s))));
    group.bench_function("pairwise", |b| b.iter(|| pairwise(black_box(&row), black_box(&s))));
    group.finish();
}

fn main() {
    let mut c = Criterion::default().configure_from_args();
    bands::<16, Nodes<380, 780>>(&mut c);
    bands::<31, Nodes<400, 700>>(&mut c);
    bands::<60, Nodes<380, 780>>(&mut c);
    bands::<81, Nodes<380, 780>>(&mut c);
    bands::<401, Nodes<380, 780>>(&mut c);
    bands::<471, Nodes<360, 830>>(&mut c);
    sums::<31>(&mut c);
    sums::<81>(&mut c);
    sums::<471>(&mut c);
    c.final_summary();
}
