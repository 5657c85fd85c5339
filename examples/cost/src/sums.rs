//! Compares sums of products by the order in which their terms are added.

use crate::cells::{priced, with_price};
use crate::clock::nanoseconds;
use crate::report::{Cell, Column, Table};
use model::noise::Noise;
use nanospectra::light::D65;
use nanospectra::observer::CIE_1931;
use nanospectra::{Bins, Curve, Factor, Grid, Nodes, Observer, Spectrum};
use nanospectra_hard::yardstick::sums::{naive, pairwise};
use std::hint::black_box;

/// Half a unit in the last place of 1, which is the largest rounding error of one operation.
const E: f64 = 1.0 / 16_777_216.0;

const SURFACES: usize = 10_000;

const WAYS: [(&str, &str); 4] = [
    ("one after the other", "naive"),
    ("eight lanes (this crate)", "lanes"),
    ("pairwise", "pairwise"),
    ("compensated (Neumaier)", "neumaier"),
];

pub fn tables(runs: usize) -> Vec<Table> {
    let mut rows = Vec::new();
    rows.extend(of::<31, Bins<400, 700>>(runs));
    rows.extend(of::<81, Nodes<380, 780>>(runs));
    rows.extend(of::<401, Nodes<380, 780>>(runs));
    rows.extend(of::<471, Nodes<360, 830>>(runs));
    let columns = with_price(vec![
        Column::key("terms", "terms"),
        Column::key("order", "order"),
        Column::figure("mean_e", "mean error, e"),
        Column::figure("max_e", "max"),
    ]);
    vec![Table {
        id: "sums",
        title: "Sums of products of positive f32".into(),
        about: format!(
            "X, Y and Z under D65 of {SURFACES} reflectances that are evenly random in 0..1. The terms at \
             both ends add next to nothing to a sum. Errors are in units of e, which is 2^-24 of the sum. \
             Times and instructions are those of one of the three sums."
        ),
        columns,
        rows,
    }]
}

fn of<const N: usize, G: Grid>(runs: usize) -> Vec<Vec<Cell>> {
    let d65 = D65.fine();
    let eye: Observer<3, N, Factor, G> = CIE_1931.under(&d65).fold(Curve::Step);
    let mut noise = Noise(N as u64);
    let mut errors = [[0.0_f64; 2]; WAYS.len()];
    for _ in 0..SURFACES {
        let values = noise.shares::<N>();
        for (weights, lanes) in eye.weights().iter().zip(eye.sees(&Spectrum::from_bins(values))) {
            let exact: f64 = weights.iter().zip(values).map(|(w, v)| f64::from(*w) * f64::from(v)).sum();
            let sums =
                [naive(weights, &values), lanes, pairwise(weights, &values), neumaier(weights, &values)];
            for ([mean, max], sum) in errors.iter_mut().zip(sums) {
                let error = (f64::from(sum) / exact - 1.0).abs() / E;
                *mean += error / (3 * SURFACES) as f64;
                *max = max.max(error);
            }
        }
    }
    let ([weights, ..], values) = (eye.weights(), noise.shares::<N>());
    let one = Observer::<1, N, Factor, G>::from_weights([*weights]);
    let surface = Spectrum::<Factor, N, G>::from_bins(values);
    let time =
        |sum: fn(&[f32], &[f32]) -> f32| nanoseconds(runs, || sum(black_box(weights), black_box(&values)));
    let times = [
        time(naive),
        nanoseconds(runs, || black_box(&one).sees(black_box(&surface))),
        time(pairwise),
        time(neumaier),
    ];
    let ways = WAYS.iter().zip(errors).zip(times);
    ways.map(|(((name, word), [mean, max]), time)| {
        let row = vec![Cell::key(N), Cell::key(name), Cell::figure(mean), Cell::figure(max)];
        priced(row, &format!("sum-{N}-{word}"), time)
    })
    .collect()
}

/// Collects what each addition loses and adds it at the end. Products are rounded as in the other sums.
///
/// # Reference
/// A. Neumaier, "Rundungsfehleranalyse einiger Verfahren zur Summation endlicher Summen", ZAMM 54 (1974).
fn neumaier(a: &[f32], b: &[f32]) -> f32 {
    let (mut sum, mut lost) = (0.0f32, 0.0f32);
    for (a, b) in a.iter().zip(b) {
        let term = a * b;
        let next = sum + term;
        lost += if sum.abs() >= term.abs() { (sum - next) + term } else { (term - next) + sum };
        sum = next;
    }
    sum + lost
}
