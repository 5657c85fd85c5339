//! Is the f64 model itself right where there is no golden? What folding, reconstructing, fine
//! integration and the search for the color temperature must do by their definitions.

use model::cct::{cct, uv_at};
use model::fine::{Curve, FineEye};
use model::fold::{EqualBins, Reconstructed, Reconstruction, on_cie_nodes, weights};
use model::interpolation::{Interpolation, Outside};
use model::tables::{Observer, source};
use model::tristimulus::dot;

/// The curves that a grid has enough bins for.
fn curves(grid: EqualBins) -> Vec<Reconstruction> {
    let mut all = vec![Reconstruction::Step, Reconstruction::Parabola, Reconstruction::Spline];
    if grid.count >= 3 {
        all.push(Reconstruction::SplineNotAKnot);
    }
    all
}

const SIXTEEN: EqualBins = EqualBins { low: 380.0, high: 730.0, count: 16 };

const GRIDS: [EqualBins; 6] = [
    EqualBins { low: 380.0, high: 730.0, count: 1 },
    EqualBins { low: 380.0, high: 730.0, count: 2 },
    EqualBins { low: 380.0, high: 730.0, count: 3 },
    SIXTEEN,
    EqualBins { low: 400.0, high: 700.0, count: 31 },
    EqualBins { low: 377.5, high: 782.5, count: 81 },
];

/// Bin values without any pattern, from 0 to 1.
fn uneven(count: usize) -> Vec<f64> {
    (0..count).map(|k| (0.5 + 12.9898 * k as f64).sin().abs()).collect()
}

/// A light times a color-matching function at 1 nm.
fn fine_row() -> Vec<f64> {
    let light = source("FL11").on_cie_grid(Interpolation::Linear, Outside::Zero);
    let [x, _, _] = Observer::Cie1931.on_cie_grid();
    light.iter().zip(&x).map(|(s, x)| s * x).collect()
}

#[test]
fn every_reconstruction_keeps_the_average_of_every_bin() {
    for grid in GRIDS {
        let bins = uneven(grid.count);
        for how in curves(grid) {
            let curve = Reconstructed::new(how, grid, &bins);
            for (k, expected) in bins.iter().enumerate() {
                let (low, high) = (grid.edge(k), grid.edge(k + 1));
                // Simpson's rule is exact for a parabola; an edge belongs to two bins
                let inset = 1e-9;
                let mean =
                    (curve.at(low + inset) + 4.0 * curve.at(0.5 * (low + high)) + curve.at(high - inset))
                        / 6.0;
                assert!((mean - expected).abs() < 1e-8, "{how:?} {grid:?} bin {k}: {mean}");
            }
        }
    }
}

#[test]
fn the_histospline_is_smooth_and_flat_at_both_ends() {
    for grid in GRIDS {
        let bins = uneven(grid.count);
        let curve = Reconstructed::new(Reconstruction::Spline, grid, &bins);
        let h = 1e-4;
        let slope = |nm: f64| (curve.at(nm + h) - curve.at(nm - h)) / (2.0 * h);
        for k in 1..grid.count {
            let edge = grid.edge(k);
            let jump = curve.at(edge + 1e-9) - curve.at(edge - 1e-9);
            assert!(jump.abs() < 1e-8, "{grid:?}: a jump of {jump} at {edge}");
            let bend = slope(edge + 2.0 * h) - slope(edge - 2.0 * h);
            assert!(bend.abs() < 1e-4, "{grid:?}: a kink of {bend} at {edge}");
        }
        for end in [grid.low + 2.0 * h, grid.high - 2.0 * h] {
            assert!(slope(end).abs() < 1e-4, "{grid:?}: slope {} at {end}", slope(end));
        }
    }
}

#[test]
fn three_bins_make_one_parabola_with_not_a_knot_ends() {
    let grid = GRIDS[2];
    let bins = uneven(3);
    let parabola = Reconstructed::new(Reconstruction::Parabola, grid, &bins);
    let spline = Reconstructed::new(Reconstruction::SplineNotAKnot, grid, &bins);
    for nm in 380..=730 {
        let nm = f64::from(nm);
        let difference = parabola.at(nm) - spline.at(nm);
        assert!(difference.abs() < 1e-12, "{difference} at {nm}");
    }
}

#[test]
fn a_parabola_is_reconstructed_exactly() {
    let grid = SIXTEEN;
    let f = |nm: f64| 0.2 + 0.001 * (nm - 500.0) + 2e-5 * (nm - 560.0).powi(2);
    // the mean of a parabola over a bin: value in the middle plus curvature h^2 / 12
    let bins: Vec<f64> = (0..grid.count)
        .map(|k| f(0.5 * (grid.edge(k) + grid.edge(k + 1))) + 2e-5 * grid.width().powi(2) / 12.0)
        .collect();
    for how in [Reconstruction::Parabola, Reconstruction::SplineNotAKnot] {
        let curve = Reconstructed::new(how, grid, &bins);
        for nm in 380..=730 {
            let nm = f64::from(nm);
            assert!((curve.at(nm) - f(nm)).abs() < 1e-11, "{how:?}: {} at {nm}", curve.at(nm));
        }
    }
}

#[test]
fn folded_weights_do_to_bins_what_the_fine_row_does_to_their_curve() {
    let row = fine_row();
    for grid in GRIDS {
        let bins = uneven(grid.count);
        for how in curves(grid) {
            let folded = dot(&weights(&on_cie_nodes(&row), grid, how), &bins);
            let curve = Reconstructed::new(how, grid, &bins);
            let seen: f64 = on_cie_nodes(&row).iter().map(|&(nm, w)| w * curve.at_node(nm)).sum();
            assert!((folded - seen).abs() < 1e-9 * seen, "{how:?} {grid:?}: {folded} {seen}");
        }
    }
}

#[test]
fn folding_keeps_the_sum_of_the_row_so_white_stays_white() {
    let row = fine_row();
    let total: f64 = row.iter().sum();
    for grid in GRIDS {
        for how in curves(grid) {
            let folded: f64 = weights(&on_cie_nodes(&row), grid, how).iter().sum();
            assert!((folded - total).abs() < 1e-11 * total, "{how:?} {grid:?}: {folded} {total}");
        }
    }
}

#[test]
fn what_lies_outside_the_bins_sits_on_the_outer_edge() {
    let grid = SIXTEEN;
    let beyond = [(365.0, 1.0), (810.0, 2.0)];
    let step = weights(&beyond, grid, Reconstruction::Step);
    let mut expected = vec![0.0; grid.count];
    (expected[0], expected[grid.count - 1]) = (1.0, 2.0);
    assert_eq!(step, expected);
    for how in curves(grid) {
        let edge = [(380.0, 1.0), (730.0, 2.0)];
        let bins = uneven(grid.count);
        let curve = Reconstructed::new(how, grid, &bins);
        let on_edge: f64 = edge.iter().map(|&(nm, w)| w * curve.at(nm)).sum();
        let outside = dot(&weights(&beyond, grid, how), &bins);
        assert!((outside - on_edge).abs() < 1e-12, "{how:?}: {outside} {on_edge}");
    }
}

#[test]
fn a_curve_knows_its_exact_mean() {
    let knots = vec![(400.0, 1.0), (401.5, 4.0), (410.0, 0.0)];
    let zero = Curve::new(knots.clone(), Outside::Zero);
    let hold = Curve::new(knots, Outside::Hold);
    let area = 1.5 * 2.5 + 8.5 * 2.0;
    assert!((zero.mean(390.0, 420.0) - area / 30.0).abs() < 1e-14);
    assert!((hold.mean(390.0, 420.0) - (area + 10.0) / 30.0).abs() < 1e-14);
    // from 401 to 402: 3 to 4 in half a nanometer, then down by 8/17 per nanometer
    let expected = 0.5 * 3.5 + 0.5 * (4.0 - 0.5 * 0.5 * 8.0 / 17.0);
    let mean = zero.mean(401.0, 402.0);
    // slope of the second piece is -4 / 8.5 = -8 / 17
    assert!((mean - expected).abs() < 1e-14, "{mean} {expected}");
    assert_eq!((zero.at(399.9), zero.at(400.0), zero.at(410.0), zero.at(410.1)), (0.0, 1.0, 0.0, 0.0));
    assert_eq!((hold.at(399.9), hold.at(500.0)), (1.0, 0.0));
}

#[test]
fn fine_integration_comes_near_the_exact_integral_of_straight_lines() {
    for id in ["A", "D65", "LED-B3"] {
        let light = source(id);
        let power = light.on_cie_grid(Interpolation::Linear, Outside::Zero);
        // knots lie on whole nanometers, so each cell holds a product of two straight lines
        let exact = Observer::Cie1931.on_cie_grid().map(|row| -> f64 {
            let cell = |s: &[f64], x: &[f64]| {
                (2.0 * s[0] * x[0] + s[0] * x[1] + s[1] * x[0] + 2.0 * s[1] * x[1]) / 6.0
            };
            let cells = power.windows(2).zip(row.windows(2));
            cells.map(|(s, x)| cell(s, x)).sum()
        });
        let eye = FineEye::new(Observer::Cie1931, &Curve::new(light.points(), Outside::Zero));
        let white = eye.white();
        let gray = eye.sees(&Curve::new(vec![(500.0, 0.18)], Outside::Hold));
        for c in 0..3 {
            let expected = 100.0 * exact[c] / exact[1];
            assert!((white[c] - expected).abs() < 2e-4, "{id}: {} {expected}", white[c]);
            assert!((gray[c] - 0.18 * white[c]).abs() < 1e-11, "{id}: {gray:?}");
        }
        assert!((white[1] - 100.0).abs() < 1e-11);
    }
}

#[test]
fn the_temperature_is_found_from_1000_to_a_million_kelvin() {
    let mut compared = 0;
    let mut worst: f64 = 0.0;
    for i in 0..=300 {
        let mired = 1.0 * 1000f64.powf(f64::from(i) / 300.0);
        for duv in [-0.02, -0.005, 0.0, 0.005, 0.02] {
            let found = cct(uv_at(1e6 / mired, duv));
            let error = (1e6 / found.cct_k - mired).abs();
            worst = worst.max(error);
            assert!(error < 1e-7, "{mired} mired, Duv {duv}: {found:?}");
            assert!((found.duv - duv).abs() < 1e-12, "{mired} mired, Duv {duv}: {found:?}");
            compared += 1;
        }
    }
    println!("worst error {worst:e} mired");
    assert_eq!(compared, 301 * 5);
}
