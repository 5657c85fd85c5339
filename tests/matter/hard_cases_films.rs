//! What goes wrong with thin films and thin absorbers in f32 or in few bins, at the tolerance that the stable
//! forms hold: rows 45 to 48 of the hard cases.
#![cfg(feature = "libm")]

use model::allowed::check;
use model::check::EPS;
use model::delta_e::de2000;
use model::film;
use model::fine::Curve as Lines;
use model::interpolation::Outside as ModelOutside;
use model::lab::lab;
use model::tables::{Observer as Table, source};
use nanospectra::light::D65;
use nanospectra::matter::{Absorber, PowerShares, ThinFilm};
use nanospectra::observer::CIE_1931;
use nanospectra::{Curve, Observer, Reflectance};

#[test]
fn thin_absorbers_keep_what_they_absorb() {
    let mut check = check("what an absorber keeps, in eps");
    for step in 0..=1300 {
        // tau from 1e-12 to 10, equally spaced in the logarithm.
        let tau = (1e-12 * 10f64.powf(0.01 * f64::from(step))) as f32;
        let dye = Absorber::<1>::from_per_m([tau]).expect("a coefficient");
        let exact = -(-f64::from(tau)).exp_m1();
        let got = f64::from(dye.absorbed(1.0).values()[0]);
        check.value(&format!("tau {tau:e}"), (got - exact).abs() / (exact * EPS), 0.0);
    }
    check.tight_over_all();
}

#[test]
fn the_phase_of_a_film_is_right_up_to_ten_centimeters() {
    let mut check = check("cosine of a film's phase");
    for nd in [1e4f32, 1e6, 1e8] {
        for n in [1.0f32, 1.33, 1.517, 2.4] {
            for step in 0..700 {
                let (nm, d) = (380.123 + 0.499 * step as f32, nd / n);
                for cos in [1.0f32, 0.73, 0.11] {
                    let across = 1.0 - f64::from(cos) * f64::from(cos);
                    let tilted = (f64::from(n) * f64::from(n) - across).sqrt();
                    let turns = (2.0 * tilted * f64::from(d) / f64::from(nm)).fract();
                    let got = f64::from(ThinFilm::new([1.0, n, 1.0], d).phase_turns(nm, cos));
                    let place = format!("n {n}, {d} nm, cos {cos}, {nm} nm");
                    let cosine = |turns: f64| (std::f64::consts::TAU * turns).cos();
                    check.value(&place, cosine(got), cosine(turns));
                }
            }
        }
    }
    check.tight_over_all();
}

#[test]
fn films_thinner_than_an_atom_still_reflect_what_they_should() {
    let mut check = check("reflectance of the thinnest films, in eps");
    // The last one is the worst of a million, at the first wavelength.
    let thickness = (0..=120).map(|step| 1e-6 * 10f32.powf(0.05 * step as f32)).chain([0.534_689_7]);
    for d in thickness {
        for indices in [[1.0f32, 1.33, 1.0], [1.5, 2.4, 1.5], [1.0, 1.0001, 1.0]] {
            for cos in [1.0f32, 0.8, 0.3] {
                for nm in [646.5087f32, 380.3, 417.1, 550.0, 719.7] {
                    let [s, _] = ThinFilm::new(indices, d).at(nm, cos);
                    let [exact, _] = film::airy(indices.map(f64::from), d.into(), nm.into(), cos.into());
                    let error = (f64::from(s.reflected) - exact).abs() / (exact * EPS);
                    check.value(&format!("{indices:?}, {d} nm, cos {cos}, {nm} nm"), error, 0.0);
                }
            }
        }
    }
    check.tight_over_all();
}

/// Light times eye every 0.001 nm, for what no grid resolves.
struct FinestEye {
    rows: [Lines; 3],
    light: Lines,
}

impl FinestEye {
    fn new() -> FinestEye {
        let light = source("D65");
        let light = Lines::new(light.points(), ModelOutside::Zero);
        let rows = Table::Cie1931.published().map(|row| Lines::new(row.points(), ModelOutside::Zero));
        FinestEye { rows, light }
    }

    /// XYZ of a soap film and of the white, Y of the white 100.
    fn sees(&self, d: f64) -> [[f64; 3]; 2] {
        let (mut film, mut white) = ([0.0; 3], [0.0; 3]);
        for nm in 360..830 {
            // Straight lines between the nanometers of the tables: end values suffice.
            let weights = [0, 1].map(|end| {
                let nm = f64::from(nm + end);
                self.rows.each_ref().map(|row| row.at(nm) * self.light.at(nm))
            });
            for step in 0..1000 {
                let t = (f64::from(step) + 0.5) / 1000.0;
                let [r, _] = film::airy([1.0, 1.33, 1.0], d, f64::from(nm) + t, 1.0);
                for c in 0..3 {
                    let weight = weights[0][c] * (1.0 - t) + weights[1][c] * t;
                    white[c] += weight;
                    film[c] += weight * r;
                }
            }
        }
        let scale = 100.0 / white[1];
        [film, white].map(|xyz| xyz.map(|v| v * scale))
    }
}

/// CIEDE2000 of a soap film in N bins against 0.001 nm: averaged, and read at the centers.
fn differences<const N: usize>([truth, white]: [[f64; 3]; 2], d: f32) -> [f64; 2] {
    let d65 = D65.fine();
    let eye: Observer<3, N> = CIE_1931.under(&d65).fold(Curve::Spline).with_white_y(100.0);
    let film = ThinFilm::new([1.0f32, 1.33, 1.0], d);
    let averaged: Reflectance<N> = film.reflectance(1.0);
    let points = Reflectance::<N>::at_centers(|nm| PowerShares::mean(film.at(nm, 1.0)).reflected);
    [averaged, points].map(|reflectance| {
        let seen = eye.sees(&reflectance).map(f64::from);
        de2000(lab(truth, white), lab(seen, white))
    })
}

#[test]
fn the_color_of_a_thick_film_needs_the_mean_over_bins() {
    let eye = FinestEye::new();
    let mut check = check("color of a soap film of 1 mm, CIEDE2000");
    for d in [1e6f32, 1.0003e6, 2e4, 5e3] {
        let truth = eye.sees(d.into());
        let all = [differences::<16>(truth, d), differences::<31>(truth, d), differences::<60>(truth, d)];
        println!("{d} nm: averaged and points, 16, 31, 60 bins: {all:.3?}");
        for ([averaged, points], of_20_um) in all.into_iter().zip([0.6, 0.2, 0.14]) {
            if d > 1e5 {
                check.value(&format!("{d} nm"), averaged, 0.0);
                assert!((2.0..20.2).contains(&points), "{d} nm: points are {points} off");
            } else {
                assert!(averaged < 1.0 && points > averaged, "{d} nm: {averaged}, points {points}");
                assert!(d < 1e4 || (0.85 * of_20_um..of_20_um).contains(&averaged), "{d} nm: {averaged}");
            }
        }
    }
    check.tight(6);
}
