//! RGB to spectrum at the ends of f32: the curve itself, steep, dark, far out, and read on any grid.
#![cfg(feature = "libm")]

use crate::{LIGHT, cube};
use model::allowed::{Singles, check};
use nanospectra::color::Rgb;
use nanospectra::observer::CIE_1931;
use nanospectra::upsample::{Shape, Sigmoid, SigmoidReflectance, Viewing};
use nanospectra::{Curve, Nodes};

type Points = Nodes<400, 700>;
static SIGMOID: Sigmoid<31, Points> = Sigmoid::new(&Viewing::new(&CIE_1931.under(&LIGHT).fold(Curve::Step)));

#[test]
fn the_sigmoid_keeps_its_digits_at_both_ends() {
    // HARD_CASES 25: 1/2 + p / 2 sqrt(1 + p^2) has none left at p = -1e4.
    let at = |p: f32| Shape { q: [0.0, 0.0, p] }.at(580.0);
    let mut tails = check("sigmoid, tails");
    // The last one is the worst of a million.
    let sizes = (0..=16_000).map(|k| 10f64.powf(f64::from(k) / 1000.0 - 4.0)).chain([0.107_056_975]);
    for p in sizes {
        let (p, p32) = (f64::from(p as f32), p as f32);
        let h = 1.0f64.hypot(p);
        tails.add(&format!("-{p}"), at(-p32), 0.5 / (h * (h + p)));
        tails.add(&format!("{p}"), at(p32), 1.0 - 0.5 / (h * (h + p)));
    }
    tails.tight_over_all();
    // 26: the square of 1e20 overflows.
    for p in [1e19, 1e20, f32::MAX, f32::INFINITY] {
        assert_eq!((at(p), at(-p)), (1.0, 0.0), "{p}");
    }
    assert!(at(f32::NAN).is_nan());
    assert_eq!(at(0.0), 0.5);
}

#[test]
fn a_polynomial_of_the_wavelength_keeps_its_digits() {
    // HARD_CASES 27: coefficients of 200 in x, read at any wavelength.
    let q = [211.7f32, -187.3, -33.9];
    let mut shares = check("sigmoid of a steep quadratic");
    for k in 0..=940 {
        let nm = 360.0 + 0.5 * k as f32;
        let x = (f64::from(nm) - 580.0) / 200.0;
        let p = (f64::from(q[0]) * x + f64::from(q[1])) * x + f64::from(q[2]);
        shares.add(&format!("{nm} nm"), Shape { q }.at(nm), 0.5 + 0.5 * p / 1.0f64.hypot(p));
    }
    shares.tight(941);
}

#[test]
fn a_texel_is_the_spectrum_and_any_grid_can_read_it() {
    cube(5, |[r, g, b]| {
        let spectrum = SIGMOID.reflectance(Rgb::new(r, g, b)).spectrum;
        assert_eq!(SigmoidReflectance::from_texel(spectrum.to_texel()), spectrum);
        // f16 would do: no coefficient of sRGB is large.
        assert!(spectrum.to_texel().iter().all(|c| c.abs() < 50.0));
        let fine = spectrum.on_grid::<301, Points>();
        for (k, share) in spectrum.on_grid::<31, Points>().values().iter().enumerate() {
            assert!((fine.values()[10 * k] - share).abs() < 3e-6);
            assert!((spectrum.at(400.0 + 10.0 * k as f32) - share).abs() < 3e-6);
        }
    });
}

#[test]
fn dark_spectra_keep_their_digits() {
    // The curve in f64, from the four numbers that are stored, down to a reflectance of 1e-7 and far below.
    let mut dark = check("dark spectra, as stored");
    let (mut count, mut least) = (0, 1.0f32);
    cube(6, |code| {
        for k in [0.4f32, 1e-2, 1e-4, 1e-6] {
            let [r, g, b] = code.map(|c| k * c * c);
            let spectrum = SIGMOID.reflectance(Rgb::new(r, g, b)).spectrum;
            for (n, share) in spectrum.on_grid::<31, Points>().values().iter().enumerate() {
                let x = (f64::from(400 + 10 * n as u16) - 580.0) / 200.0;
                let [q0, q1, q2] = spectrum.shape.q.map(f64::from);
                let p = (q0 * x + q1) * x + q2;
                let h = 1.0f64.hypot(p);
                let tail = 0.5 / (h * (h + p.abs()));
                let exact = f64::from(spectrum.scale) * if p < 0.0 { tail } else { 1.0 - tail };
                dark.add(&format!("{r} {g} {b}, {n}"), *share, exact);
                least = if exact > 0.0 { least.min(*share) } else { least };
                count += 1;
            }
        }
    });
    assert!(least < 1e-9, "{least}");
    dark.tight(count);
}

#[test]
fn dark_spectra_are_the_bright_one_times_exposure() {
    let mut dark = check("dark spectra over the bright one");
    for [r, g, b] in [[0.45, 0.1, 0.02], [0.05, 0.4, 0.3], [0.2, 0.1, 0.49], [0.0, 0.0, 0.4], [0.3, 0.3, 0.0]]
    {
        let of = |k: f32| SIGMOID.reflectance(Rgb::new(k * r, k * g, k * b)).spectrum.on_grid::<31, Points>();
        let bright = of(1.0);
        for power in 1..=9 {
            let k = 10f32.powi(-power);
            for (dark_share, share) in of(k).values().iter().zip(bright.values()) {
                dark.add(&format!("{r} {g} {b}, {k}"), *dark_share, f64::from(*share) * f64::from(k));
            }
        }
        // By a power of two: to the bit.
        assert_eq!(of(0.5f32.powi(20)), bright * 0.5f32.powi(20));
    }
    dark.tight_over_all();
}
