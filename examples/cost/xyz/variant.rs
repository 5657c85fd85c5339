//! The same schemes in f64 with every sum at 0.1 nm: which way of doing it makes the difference to another study.

use super::lamps::{CLASSES, Class};
use super::scheme::Scheme;
use super::see::Range;
use super::world::{CES, Lamp, Points, World};
use model::delta_e::de2000;
use model::fine::{Curve, FineEye, nodes};
use model::fold::{EqualBins, Reconstructed, Reconstruction};
use model::interpolation::Outside;
use model::lab::lab;
use model::tables::Observer;

/// Mean CIEDE2000 of each class but lines, the curve through the bins drawn in this way.
pub fn means(
    world: &World,
    range: &Range,
    bands: usize,
    scheme: Scheme,
    how: Reconstruction,
) -> [f64; CLASSES.len()] {
    let grid = EqualBins { low: range.low, high: range.high, count: bands };
    let paints: Vec<Vec<f64>> = world.sets[CES]
        .surfaces
        .iter()
        .flat_map(|surface| surface.factors.first())
        .map(|points| averages(points, Outside::Hold, grid))
        .collect();
    let curves: Vec<Vec<f64>> = (0..bands).map(|k| unit(how, grid, k)).collect();
    let flat = FineEye::new(Observer::Cie1931, &Curve::new(vec![(360.0, 1.0), (830.0, 1.0)], Outside::Zero));
    let unlit = folded(&flat, &curves);
    let errors = |lamp: &Lamp| -> Vec<f64> {
        let weights = if scheme.is_folded() {
            folded(&lamp.fine, &curves)
        } else {
            let light = averages(&lamp.points, Outside::Zero, grid);
            let scale = lamp.fine.scale() / flat.scale();
            unlit.each_ref().map(|row| row.iter().zip(&light).map(|(w, power)| scale * w * power).collect())
        };
        let truth = lamp.truth.iter().take(1).flatten();
        let seen = paints.iter().map(|paint| lab(weights.each_ref().map(|row| dot(row, paint)), lamp.white));
        truth.zip(seen).map(|(truth, seen)| de2000(*truth, seen)).collect()
    };
    CLASSES.map(|class| {
        if class == Class::Lines {
            return f64::NAN;
        }
        let all: Vec<f64> = world.lamps.iter().filter(|lamp| lamp.class == class).flat_map(errors).collect();
        all.iter().sum::<f64>() / all.len() as f64
    })
}

/// The curve through bins that are 0 but for a 1 in bin `k`, every 0.1 nm.
fn unit(how: Reconstruction, grid: EqualBins, k: usize) -> Vec<f64> {
    let bins: Vec<f64> = (0..grid.count).map(|j| if j == k { 1.0 } else { 0.0 }).collect();
    let curve = Reconstructed::new(how, grid, &bins);
    nodes().map(|nm| curve.at(nm)).collect()
}

fn folded(eye: &FineEye, curves: &[Vec<f64>]) -> [Vec<f64>; 3] {
    eye.weights().map(|row| curves.iter().map(|curve| dot(&row, curve)).collect())
}

fn averages(points: &Points, outside: Outside, grid: EqualBins) -> Vec<f64> {
    let knots = points.iter().map(|&(nm, value)| (f64::from(nm), f64::from(value))).collect();
    let curve = Curve::new(knots, outside);
    (0..grid.count).map(|k| curve.mean(grid.edge(k), grid.edge(k + 1))).collect()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
