//! Rows 41 to 51: sums, scales, absorbers, films, sensors.

use super::claim::Naive::{Fails, Holds};
use super::claim::{Claim, Off, absolute, in_eps, relative, share};
use super::hard::sensor::{AS7341, COUNTED, Chip, SMOOTH, WIDE};
use model::delta_e::de2000;
use model::fine::Curve;
use model::interpolation::Outside;
use model::lab::lab;
use model::tables::{self, source};
use model::{film, sensor};
use nanospectra::light::D65;
use nanospectra::matter::CES;
use nanospectra::observer::CIE_1931;
use nanospectra::{Fine, Interpolation, Power};
use std::f64::consts::TAU;
use std::sync::Mutex;

pub const CLAIMS: &[Claim] = &[
    Claim {
        row: "41",
        what: "sum of 471 products, one after the other",
        inputs: "16 draws of numbers from 0 to 1",
        measured: "e",
        limit: 8.0,
        unit: "e",
        asked: "",
        naive: Fails,
        test: "spectrum/hard_cases::sums_of_471_81_and_31_terms_round_like_eight_short_ones",
        judge: products,
    },
    Claim {
        row: "42a",
        what: "sum of 31 products",
        inputs: "16 draws",
        measured: "e",
        limit: 8.0,
        unit: "e",
        asked: "",
        naive: Holds,
        test: "spectrum/hard_cases::sums_of_471_81_and_31_terms_round_like_eight_short_ones",
        judge: products,
    },
    Claim {
        row: "42b",
        what: "sum of 81 products",
        inputs: "16 draws",
        measured: "e",
        limit: 8.0,
        unit: "e",
        asked: "",
        naive: Fails,
        test: "spectrum/hard_cases::sums_of_471_81_and_31_terms_round_like_eight_short_ones",
        judge: products,
    },
    Claim {
        row: "43",
        what: "bright light: inf where XYZ itself is beyond f32",
        inputs: "1e30, 1e36, 1e37 per nm",
        measured: "relative",
        limit: 8.0,
        unit: "e",
        asked: "",
        naive: Fails,
        test: "spectrum/hard_cases::sums_keep_their_accuracy_from_1e_minus_30_to_1e30",
        judge: |at, got| {
            let exact = CIE_1931.weights().map(|row| at[0] * row.iter().map(|w| f64::from(*w)).sum::<f64>());
            relative(got, &exact.map(|v| if v > f32::MAX.into() { f64::INFINITY } else { v }))
        },
    },
    Claim {
        row: "44",
        what: "faint light at the scale it has; not below 1e-30",
        inputs: "1e-30, 1e-36, 1e-38 per nm",
        measured: "relative",
        limit: 1e-6,
        unit: "",
        asked: "",
        naive: Fails,
        test: "spectrum/hard_cases::sums_are_the_same_on_cores_that_flush_subnormals",
        judge: |_, got| {
            let mut share_of = 1.0f32;
            let light = [(); 471].map(|()| {
                share_of *= 0.99;
                f64::from(share_of)
            });
            let exact = CIE_1931
                .weights()
                .map(|row| row.iter().zip(&light).map(|(w, v)| f64::from(*w) * v).sum::<f64>());
            share(got, &exact)
        },
    },
    Claim {
        row: "45",
        what: "thin absorber, 1 − e^−τ",
        inputs: "τ = 1e-8 to 5",
        measured: "relative",
        limit: 4.0,
        unit: "e",
        asked: "",
        naive: Fails,
        test: "matter/hard_cases_films::thin_absorbers_keep_what_they_absorb",
        judge: |at, got| relative(got, &[-(-at[0]).exp_m1()]),
    },
    Claim {
        row: "46",
        what: "phase of a film, cos(4πnd/λ)",
        inputs: "nd = 10 µm, 1 mm, 10 cm",
        measured: "absolute",
        limit: 1e-6,
        unit: "",
        asked: "",
        naive: Fails,
        test: "matter/hard_cases_films::the_phase_of_a_film_is_right_up_to_ten_centimetres",
        judge: |at, got| absolute(got, &[(TAU * (2.0 * at[0] * at[1] / at[2]).fract()).cos()]),
    },
    Claim {
        row: "47",
        what: "Airy's formula with 1 − cos δ",
        inputs: "soap, 1e-3 to 100 nm",
        measured: "relative",
        limit: 12.0,
        unit: "e",
        asked: "8 e",
        naive: Fails,
        test: "matter/hard_cases_films::films_thinner_than_an_atom_still_reflect_what_they_should",
        judge: |at, got| relative(got, &film::airy([1.0, f64::from(1.33f32), 1.0], at[0], at[1], 1.0)[..1]),
    },
    Claim {
        row: "48",
        what: "colour of a thick film, one point per bin; its mean",
        inputs: "soap of 1 mm in 31 bins under D65",
        measured: "CIEDE2000",
        limit: 0.1,
        unit: "",
        asked: "",
        naive: Fails,
        test: "matter/hard_cases_films::the_colour_of_a_thick_film_needs_the_mean_over_bins",
        judge: |at, got| {
            let [truth, white] = soap(at[0]);
            absolute(&[de2000(lab(truth, white), lab([got[0], got[1], got[2]], white))], &[0.0])
        },
    },
    Claim {
        row: "49",
        what: "8 counts to 31 bins, normal equations and Cholesky; QR",
        inputs: "an AS7341, α = 1e-8 to 1e-2",
        measured: "of the largest",
        limit: 1e-3,
        unit: "",
        asked: "",
        naive: Fails,
        test: "sensor/reconstruction::the_matrices_are_those_of_f64_down_to_the_smallest_alpha",
        judge: |at, got| of_largest(got, &spectrum(&AS7341, 0.0, at[0])),
    },
    Claim {
        row: "50a",
        what: "Wiener by 8 × 8 and Cholesky; QR",
        inputs: "channels of 120 nm, α = 1e-7 to 1e-2",
        measured: "of the largest",
        limit: 1e-3,
        unit: "",
        asked: "",
        naive: Fails,
        test: "sensor/reconstruction::the_matrices_are_those_of_f64_down_to_the_smallest_alpha",
        judge: |at, got| of_largest(got, &spectrum(&WIDE, SMOOTH.into(), at[0])),
    },
    Claim {
        row: "50b",
        what: "two channels that are one, no noise",
        inputs: "α = 0",
        measured: "answers",
        limit: 0.0,
        unit: "",
        asked: "",
        naive: Fails,
        test: "sensor/reconstruction::what_cannot_be_told_is_refused",
        judge: |_, got| absolute(got, &[0.0]),
    },
    Claim {
        row: "51a",
        what: "8 counts to XYZ by way of 31 bins; 3 × 8 at once; the worst",
        inputs: "every second sample of CIE 224 under D65",
        measured: "CIEDE2000",
        limit: 0.65,
        unit: "",
        asked: "",
        naive: Fails,
        test: "sensor/as7341::eight_channels_to_xyz_are_a_tenth_of_a_difference_off",
        judge: |_, got| absolute(&samples(got), &[0.0; 49]),
    },
    Claim {
        row: "51b",
        what: "the same in the mean",
        inputs: "the same",
        measured: "CIEDE2000",
        limit: 0.12,
        unit: "",
        asked: "",
        naive: Fails,
        test: "sensor/as7341::eight_channels_to_xyz_are_a_tenth_of_a_difference_off",
        judge: |_, got| absolute(&[samples(got).iter().sum::<f64>() / 49.0], &[0.0]),
    },
];

fn products(at: &[f64], got: &[f64]) -> Off {
    let (weights, values) = at.split_at(at.len() / 2);
    in_eps(got[0], weights.iter().zip(values).map(|(w, v)| w * v).sum())
}

/// XYZ of a soap film at steps of 0.001 nm, and of the white, Y of the white 100.
fn soap(d: f64) -> [[f64; 3]; 2] {
    static KNOWN: Mutex<Vec<(f64, [[f64; 3]; 2])>> = Mutex::new(Vec::new());
    let mut known = KNOWN.lock().unwrap_or_else(|held| held.into_inner());
    if let Some((_, seen)) = known.iter().find(|(of, _)| *of == d) {
        return *seen;
    }
    let curve = |samples: model::interpolation::Samples| Curve::new(samples.points(), Outside::Zero);
    let (light, rows) = (curve(source("D65")), tables::Observer::Cie1931.published().map(curve));
    let (mut film, mut white) = ([0.0; 3], [0.0; 3]);
    for nm in 360..830 {
        // Straight lines between the nanometres of the tables: end values suffice.
        let ends = [0, 1].map(|end| {
            let nm = f64::from(nm + end);
            rows.each_ref().map(|row| row.at(nm) * light.at(nm))
        });
        for step in 0..1000 {
            let t = (f64::from(step) + 0.5) / 1000.0;
            let [r, _] = film::airy([1.0, f64::from(1.33f32), 1.0], d, f64::from(nm) + t, 1.0);
            for c in 0..3 {
                let weight = ends[0][c] * (1.0 - t) + ends[1][c] * t;
                white[c] += weight;
                film[c] += weight * r;
            }
        }
    }
    let scale = 100.0 / white[1];
    let seen = [film, white].map(|xyz| xyz.map(|v| v * scale));
    known.push((d, seen));
    seen
}

/// The spectrum of the counts, by normal equations and elimination in f64.
fn spectrum(chip: &Chip, correlation: f64, alpha: f64) -> Vec<f64> {
    let covariance = sensor::smooth_covariance(31, correlation);
    let matrix = sensor::wiener(&sensor::wide(chip.weights()), &covariance, alpha);
    matrix.iter().map(|row| row[COUNTED]).collect()
}

fn of_largest(got: &[f64], exact: &[f64]) -> Off {
    let size = exact.iter().fold(0.0f64, |size, v| size.max(v.abs()));
    absolute(
        &got.iter().map(|v| v / size).collect::<Vec<_>>(),
        &exact.iter().map(|v| v / size).collect::<Vec<_>>(),
    )
}

/// Differences of the samples that were not calibrated with.
fn samples(got: &[f64]) -> Vec<f64> {
    let lamp: Fine<Power> = D65.interpolate(Interpolation::Linear, nanospectra::Outside::Zero);
    let seen = |light: &Fine<Power>| CIE_1931.sees(light).map(f64::from);
    let white = seen(&lamp);
    let others = CES.iter().skip(1).step_by(2).zip(got.chunks(3));
    others
        .map(|(sample, got)| {
            let patch = lamp * sample.interpolate(Interpolation::Linear, nanospectra::Outside::Hold);
            de2000(lab([got[0], got[1], got[2]], white), lab(seen(&patch), white))
        })
        .collect()
}
