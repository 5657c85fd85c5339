//! Correlated color temperature and Duv by definition: the nearest point of the Planckian locus
//! in the CIE 1960 diagram, 1931 observer, sums at 1 nm from 360 to 830 nm.

use std::sync::OnceLock;

use super::chromaticity::uv1960;
use super::planck::{C2_CIE, C2_CODATA, relative};
use super::tables::Observer;
use super::tristimulus::dot;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cct {
    pub cct_k: f64,
    /// Distance from the locus, positive above it (towards green).
    pub duv: f64,
}

fn cmf() -> &'static [Vec<f64>; 3] {
    static CMF: OnceLock<[Vec<f64>; 3]> = OnceLock::new();
    CMF.get_or_init(|| Observer::Cie1931.on_cie_grid())
}

/// A point of the locus and its derivative by temperature.
pub fn planckian(kelvin: f64, c2: f64) -> ([f64; 2], [f64; 2]) {
    let nodes = || (360..=830).map(f64::from);
    let power: Vec<f64> = nodes().map(|nm| relative(nm, kelvin, c2)).collect();
    // dB/dT = B x / (T (1 - e^-x))
    let slope: Vec<f64> = nodes()
        .zip(&power)
        .map(|(nm, p)| {
            let x = c2 / (nm * 1e-9 * kelvin);
            p * x / kelvin / -(-x).exp_m1()
        })
        .collect();
    let xyz = [0, 1, 2].map(|c| dot(&power, &cmf()[c]));
    let change = [0, 1, 2].map(|c| dot(&slope, &cmf()[c]));
    let bottom = xyz[0] + 15.0 * xyz[1] + 3.0 * xyz[2];
    let bottom_change = change[0] + 15.0 * change[1] + 3.0 * change[2];
    let quotient =
        |top: f64, top_change: f64| (top_change * bottom - top * bottom_change) / (bottom * bottom);
    let slopes = [quotient(4.0 * xyz[0], 4.0 * change[0]), quotient(6.0 * xyz[1], 6.0 * change[1])];
    (uv1960(xyz), slopes)
}

/// Chromaticity of a Planckian radiator with the colorimetric c2.
pub fn planckian_uv(kelvin: f64) -> [f64; 2] {
    planckian(kelvin, C2_CIE).0
}

/// The point at a distance `duv` from the locus, on the normal at `kelvin`.
pub fn uv_at(kelvin: f64, duv: f64) -> [f64; 2] {
    let ([u, v], [du, dv]) = planckian(kelvin, C2_CIE);
    let length = du.hypot(dv);
    [u + duv * dv / length, v - duv * du / length]
}

/// Nearest point of the locus with the colorimetric c2 = 1.4388e-2 m K.
pub fn cct(uv: [f64; 2]) -> Cct {
    static LOCUS: OnceLock<Vec<(f64, [f64; 2])>> = OnceLock::new();
    nearest(uv, C2_CIE, LOCUS.get_or_init(|| locus(C2_CIE)))
}

/// The same with c2 of CODATA 2018.
pub fn cct_codata(uv: [f64; 2]) -> Cct {
    static LOCUS: OnceLock<Vec<(f64, [f64; 2])>> = OnceLock::new();
    nearest(uv, C2_CODATA, LOCUS.get_or_init(|| locus(C2_CODATA)))
}

/// Coarse locus by reciprocal megakelvin, from 10^8 K down to 333 K.
fn locus(c2: f64) -> Vec<(f64, [f64; 2])> {
    (0..=750)
        .map(|i| if i == 0 { 0.01 } else { 4.0 * f64::from(i) })
        .map(|mired| (mired, planckian(1e6 / mired, c2).0))
        .collect()
}

/// Every local minimum of the coarse search is bisected to the foot of the perpendicular, and the
/// nearest foot wins: far from the locus there may be two branches.
fn nearest(uv: [f64; 2], c2: f64, coarse: &[(f64, [f64; 2])]) -> Cct {
    let distance = |at: [f64; 2]| (uv[0] - at[0]).hypot(uv[1] - at[1]);
    // grows towards colder light while the foot is still further along: slope of the distance
    let ahead = |mired: f64| {
        let ([u, v], [du, dv]) = planckian(1e6 / mired, c2);
        -((uv[0] - u) * du + (uv[1] - v) * dv)
    };
    let last = coarse.len() - 1;
    let mut best: Option<(f64, f64)> = None;
    for i in 0..=last {
        let here = distance(coarse[i].1);
        let (left, right) = (i.saturating_sub(1), (i + 1).min(last));
        if distance(coarse[left].1) < here || distance(coarse[right].1) < here {
            continue;
        }
        let (mut low, mut high) = (coarse[left].0, coarse[right].0);
        for _ in 0..48 {
            let middle = 0.5 * (low + high);
            if ahead(middle) > 0.0 { low = middle } else { high = middle }
        }
        let mired = 0.5 * (low + high);
        let found = distance(planckian(1e6 / mired, c2).0);
        if best.is_none_or(|(_, nearest)| found < nearest) {
            best = Some((mired, found));
        }
    }
    let (mired, _) = best.expect("a chromaticity that is a number has a nearest point");
    let ([u, v], [du, dv]) = planckian(1e6 / mired, c2);
    let duv = ((uv[0] - u) * dv - (uv[1] - v) * du) / du.hypot(dv);
    Cct { cct_k: 1e6 / mired, duv }
}
