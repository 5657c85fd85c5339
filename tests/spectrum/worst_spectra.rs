//! That the documented bounds hold for the worst black bodies and the worst samples that a search finds.
#![cfg(feature = "libm")]

use model::planck;
use model::search::{Range, Range::*, units, worst};
use nanospectra::light::{blackbody, blackbody_relative};
use nanospectra::{Bins, Light};

const STEPS: usize = 2000;

/// The lengths and temperatures that are in use, and nearly all that f32 has.
const HEAT: [[Range; 2]; 2] =
    [[Sizes(10.0, 1e6), Sizes(50.0, 1e12)], [Sizes(1e-12, 1e20), Sizes(1e-6, 1e36)]];

/// Smaller numbers have fewer digits, and larger ones none.
fn in_range(exact: f64) -> bool {
    (1.2e-38..3.4e38).contains(&exact)
}

#[test]
fn black_bodies_are_as_exact_as_promised() {
    for (k, ranges) in HEAT.into_iter().enumerate() {
        worst(1 + k as u64, STEPS, ranges, |[nm, kelvin]| {
            let (nm64, kelvin64) = (f64::from(nm), f64::from(kelvin));
            let exact = 1e-9 * planck::radiance(nm64, kelvin64);
            if !in_range(exact) {
                return -1.0;
            }
            units(blackbody(nm, kelvin), exact) / (3.0 * planck::x(nm64, kelvin64) + 9.0)
        })
        .is_what_is_promised("black bodies, in (3 x + 9) units", 1.0);
        worst(3 + k as u64, STEPS, ranges, |[nm, kelvin]| {
            let [x, x560] = [nm, 560.0].map(|nm| planck::x(nm.into(), kelvin.into()));
            // By the difference of both x, since e^x has no number.
            let dx = planck::x(1.0, kelvin.into()) / 560.0 * (1.0 - 560.0 / f64::from(nm));
            let planck = (-x560).exp_m1() / (-x).exp_m1();
            let exact = (560.0 / f64::from(nm)).powi(5) * planck * dx.exp();
            if !in_range(exact) {
                return -1.0;
            }
            units(blackbody_relative(nm, kelvin), exact) / (4.0 * dx.abs() + 14.0)
        })
        .is_what_is_promised("black bodies relative to 560 nm, in (4 |dx| + 14) units", 1.0);
    }
}

#[test]
fn the_ratio_of_black_bodies_overflows_only_where_it_is_infinite() {
    for (nm, kelvin, exact) in [(5000.0, 255.0, 1.266e34), (50_000.0, 280.0, 7.0e29)] {
        let got = blackbody_relative(nm, kelvin);
        assert!((got / exact - 1.0).abs() < 1e-2, "{nm} nm, {kelvin} K: {got:e} for {exact:e}");
    }
    assert_eq!(blackbody_relative(5000.0, 200.0), f32::INFINITY, "the ratio is 1.3e44");
    // Waves of 100 m, and gamma rays of a billion kelvin.
    for (nm, kelvin) in [(1e11f32, 300.0f32), (1e-4, 1e9), (1e-4, 2e9), (1e13, 1e4)] {
        let exact = 1e-9 * planck::radiance(nm.into(), kelvin.into());
        let got = blackbody(nm, kelvin);
        assert!((f64::from(got) / exact - 1.0).abs() < 3e-5, "{nm} nm, {kelvin} K: {got:e} for {exact:e}");
    }
}

/// The worst average over a bin of a band between two wavelengths, whose flanks are this wide.
fn averages_in_bins<const N: usize>(what: &str, bound: f64) {
    let width = 350.0 / N as f64;
    let ranges = [Even(379.0, 730.0), Sizes(1e-3, 400.0), Sizes(1e-3, 1.0)];
    worst(1, STEPS / 4, ranges, |[from, length, flank]| {
        let nm = [from, from + flank, from + flank + length, from + 2.0 * flank + length];
        if !nm.is_sorted_by(|a, b| a < b) {
            return -1.0;
        }
        let samples = [(nm[0], 0.0), (nm[1], 1.0), (nm[2], 1.0), (nm[3], 0.0)];
        let light = Light::<N, Bins<380, 730>>::from_samples(&samples).expect("samples");
        // The area from the first sample up to a wavelength.
        let area = |to: f64| {
            let piece = |pair: &[(f32, f32)]| {
                let [(a, u), (b, v)] =
                    [pair[0], pair[1]].map(|(nm, value)| (f64::from(nm), f64::from(value)));
                let end = to.clamp(a, b);
                let height = u + (v - u) * (end - a) / (b - a);
                0.5 * (u + height) * (end - a)
            };
            samples.windows(2).map(piece).sum::<f64>()
        };
        let edge = |k: usize| 380.0 + width * k as f64;
        let error = |k: usize| (f64::from(light[k]) - (area(edge(k + 1)) - area(edge(k))) / width).abs();
        (0..N).map(error).fold(0.0, f64::max) / (2e-6 + 7e-5 / width)
    })
    .is_what_is_promised(what, bound);
}

#[test]
fn averages_of_samples_are_as_exact_as_promised() {
    averages_in_bins::<31>("averages in 31 bins, in 2e-6 + 7e-5 nm / width", 1.0);
    averages_in_bins::<97>("averages in 97 bins, in 2e-6 + 7e-5 nm / width", 1.0);
    averages_in_bins::<471>("averages in 471 bins, in 2e-6 + 7e-5 nm / width", 1.0);
}
