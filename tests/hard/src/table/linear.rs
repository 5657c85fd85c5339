//! Rows 41 to 51: sums, scales, absorbers, films, sensors.

use super::judge::{Judge, Off, absolute, in_eps, relative, share, zero};
use model::delta_e::de2000;
use model::fine::Curve;
use model::interpolation::Outside;
use model::lab::lab;
use model::tables::{self, source};
use model::{film, sensor};
use nanospectra::light::D65;
use nanospectra::matter::CES;
use nanospectra::observer::CIE_1931;
use nanospectra::{Fine, Power};
use nanospectra_hard::cases::sensor::{AS7341, COUNTED, Chip, SMOOTH, WIDE};
use std::f64::consts::TAU;
use std::sync::{Mutex, PoisonError};

pub const JUDGES: &[(&str, Judge)] = &[
    ("41", products),
    ("42a", products),
    ("42b", products),
    ("43", |at, got| {
        let exact = CIE_1931.weights().map(|row| at[0] * row.iter().map(|w| f64::from(*w)).sum::<f64>());
        relative(got, &exact.map(|v| if v > f32::MAX.into() { f64::INFINITY } else { v }))
    }),
    ("44", |_, got| {
        let mut share_of = 1.0f32;
        let light = [(); 471].map(|()| {
            share_of *= 0.99;
            f64::from(share_of)
        });
        let exact =
            CIE_1931.weights().map(|row| row.iter().zip(&light).map(|(w, v)| f64::from(*w) * v).sum::<f64>());
        share(got, &exact)
    }),
    ("45", |at, got| relative(got, &[-(-at[0]).exp_m1()])),
    ("46", |at, got| absolute(got, &[(TAU * (2.0 * at[0] * at[1] / at[2]).fract()).cos()])),
    ("47", |at, got| relative(got, &film::airy([1.0, f64::from(1.33f32), 1.0], at[0], at[1], 1.0)[..1])),
    ("48", |at, got| {
        let [truth, white] = soap(at[0]);
        absolute(&[de2000(lab(truth, white), lab([got[0], got[1], got[2]], white))], &[0.0])
    }),
    ("49", |at, got| of_largest(got, &spectrum(&AS7341, 0.0, at[0]))),
    ("50a", |at, got| of_largest(got, &spectrum(&WIDE, SMOOTH.into(), at[0]))),
    ("50b", zero),
    ("51a", |_, got| absolute(&samples(got), &[0.0; 49])),
    ("51b", |_, got| absolute(&[samples(got).iter().sum::<f64>() / 49.0], &[0.0])),
];

fn products(at: &[f64], got: &[f64]) -> Off {
    let (weights, values) = at.split_at(at.len() / 2);
    in_eps(got[0], weights.iter().zip(values).map(|(w, v)| w * v).sum())
}

/// Returns XYZ of a soap film and of the white, from steps of 0.001 nm, with Y of the white at 100.
fn soap(d: f64) -> [[f64; 3]; 2] {
    static KNOWN: Mutex<Vec<(f64, [[f64; 3]; 2])>> = Mutex::new(Vec::new());
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((_, seen)) = known.iter().find(|(of, _)| *of == d) {
        return *seen;
    }
    let curve = |samples: model::interpolation::Samples| Curve::new(samples.points(), Outside::Zero);
    let (light, rows) = (curve(source("D65")), tables::Observer::Cie1931.published().map(curve));
    let (mut film, mut white) = ([0.0; 3], [0.0; 3]);
    for nm in 360..830 {
        // Between whole nanometers the tables are straight lines, so the values at both ends suffice.
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

/// Returns the spectrum behind the counts, by normal equations and elimination in f64.
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

/// Returns the color differences of the samples that the calibration did not use.
fn samples(got: &[f64]) -> Vec<f64> {
    let lamp: Fine<Power> = D65.fine();
    let seen = |light: &Fine<Power>| CIE_1931.sees(light).map(f64::from);
    let white = seen(&lamp);
    let others = CES.iter().skip(1).step_by(2).zip(got.chunks(3));
    others
        .map(|(sample, got)| {
            let patch = lamp * sample.fine();
            de2000(lab([got[0], got[1], got[2]], white), lab(seen(&patch), white))
        })
        .collect()
}
