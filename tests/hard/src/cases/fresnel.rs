//! Rows 14 to 20: Fresnel's equations for media that hardly differ, beyond the critical angle, and for
//! metals.

use super::Cases;
use nanospectra::math::sqrt;
use nanospectra::matter::{Conductor, Dielectric};

pub fn rows(cases: &mut impl Cases) {
    cases.row("14", &[[1.0001, 0.5]], dielectric, ours);
    cases.row("15", &[[1.000_001, 1e-3]], dielectric, ours);
    cases.row("16a", &BEYOND, dielectric, ours);
    cases.row("16b", &JUST_BELOW, dielectric, ours);
    cases.row("17", &[[1.0, 0.0], [1.0, 1e-30], [1.0, 1e-3], [1.0, 1.0]], dielectric, ours);
    cases.row("18a", &SILVERY, conductor, metal);
    cases.row("18b", &SILVERY, |at| conductor(at).map(|r| 1.0 - r), entering);
    cases.row("19", &[[0.2, 1e10, 1.0], [0.2, 1e10, 0.5], [1.0, 1e19, 0.1]], conductor, metal);
    cases.row(
        "20",
        &[0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 1.0].map(|cos| [0.2, 1e-4, cos]),
        s_of_conductor,
        s_of_metal,
    );
}

/// Pairs of a relative index and a cosine at which all light is reflected.
const BEYOND: [[f32; 2]; 4] = [[1.0 / 1.5, 0.7], [1.0 / 1.5, 0.1], [0.999, 0.04], [0.5, 0.8]];
const JUST_BELOW: [[f32; 2]; 4] =
    [[1.0 / 1.5, 0.7455], [1.0 / 1.5, 0.7461], [0.999, 0.044_72], [0.5, 0.8661]];

/// Indices and cosines of metals that reflect nearly everything.
const SILVERY: [[f32; 3]; 6] = [
    [0.01, 20.0, 1.0],
    [0.01, 20.0, 0.919_533_97],
    [0.01, 20.0, 0.8],
    [0.01, 20.0, 0.5],
    [0.01, 20.0, 0.2],
    [0.01, 20.0, 0.05],
];

/// Returns the reflectances for s and p by the angle of refraction, as pbrt computes them.
fn dielectric(&[eta, cos_i]: &[f32; 2]) -> [f32; 2] {
    let cos_t = sqrt(1.0 - (1.0 - cos_i * cos_i) / (eta * eta));
    let parallel = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    let perpendicular = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    [perpendicular * perpendicular, parallel * parallel]
}

fn ours(&[eta, cos_i]: &[f32; 2]) -> [f32; 2] {
    let shares = Dielectric::new(eta).fresnel(cos_i);
    [shares.s, shares.p]
}

/// Returns the reflectances of a metal for s and p in real numbers, as pbrt-v3 computes them.
fn conductor(&[eta, k, cos]: &[f32; 3]) -> [f32; 2] {
    let cos2 = cos * cos;
    let sin2 = 1.0 - cos2;
    let (eta2, k2) = (eta * eta, k * k);
    let t0 = eta2 - k2 - sin2;
    let a2_and_b2 = sqrt(t0 * t0 + 4.0 * eta2 * k2);
    let t1 = a2_and_b2 + cos2;
    let a = sqrt(0.5 * (a2_and_b2 + t0));
    let t2 = 2.0 * cos * a;
    let s = (t1 - t2) / (t1 + t2);
    let (t3, t4) = (cos2 * a2_and_b2 + sin2 * sin2, t2 * sin2);
    [s, s * (t3 - t4) / (t3 + t4)]
}

fn s_of_conductor(at: &[f32; 3]) -> [f32; 1] {
    let [s, _] = conductor(at);
    [s]
}

fn s_of_metal(at: &[f32; 3]) -> [f32; 1] {
    let [s, _] = metal(at);
    [s]
}

fn metal(&[eta, k, cos_i]: &[f32; 3]) -> [f32; 2] {
    let shares = Conductor::new(eta, k).fresnel(cos_i);
    [shares.s, shares.p]
}

fn entering(&[eta, k, cos_i]: &[f32; 3]) -> [f32; 2] {
    let shares = Conductor::new(eta, k).entering(cos_i);
    [shares.s, shares.p]
}
