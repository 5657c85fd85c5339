//! Rows 14 to 24, 52 and 53: Fresnel's equations, microfacets, matt surfaces.

use super::judge::{Judge, Off, absolute, relative, share, zero};
use model::{fresnel, surface};
use nanospectra::geometry::Direction;
use std::f64::consts::PI;

pub const JUDGES: &[(&str, Judge)] = &[
    ("14", dielectric),
    ("15", dielectric),
    ("16a", |_, got| absolute(got, &[1.0, 1.0])),
    ("16b", |at, got| absolute(got, &reflectances(at[0], 0.0, at[1]))),
    ("17", zero),
    ("18a", metal),
    ("18b", |at, got| {
        let (s, p) = fresnel::absorbed([at[0], at[1]], at[2]);
        relative(got, &[s, p])
    }),
    ("19", metal),
    ("20", |at, got| relative(got, &reflectances(at[0], at[1], at[2])[..1])),
    ("21", |at, got| {
        let wm = Direction::spherical(at[1] as f32, 0.7).to_array().map(f64::from);
        relative(got, &[surface::ggx_d(at[0], wm)])
    }),
    ("22", |_, got| relative(got, &[1.0 / (PI * 1e-8)])),
    ("23", |at, got| over(at, got, |wo, wi| surface::ggx_f(at[0], wo, wi))),
    ("24a", |at, got| {
        let finite = got[0].is_finite() && got[0] >= 0.0;
        if at[1] > 0.0 && at[2] > 0.0 && finite { absolute(got, got) } else { absolute(got, &[0.0]) }
    }),
    ("24b", |at, got| over(at, got, |_, _| 0.5 / PI)),
    ("52", |at, got| share(got, &[surface::ggx_rho(at[0], at[1], 200)])),
    ("53", |at, got| {
        let steps = 20_000;
        let cosines = (0..steps).map(|k| (f64::from(k) + 0.5) / f64::from(steps));
        let flux: f64 = cosines.map(|c| 2.0 * c * fresnel::unpolarized([at[0], 0.0], c)).sum();
        absolute(got, &[flux / f64::from(steps)])
    }),
];

fn reflectances(eta: f64, k: f64, cos: f64) -> [f64; 2] {
    let (s, p) = fresnel::reflectances([eta, k], cos);
    [s, p]
}

fn dielectric(at: &[f64], got: &[f64]) -> Off {
    relative(got, &reflectances(at[0], 0.0, at[1]))
}

fn metal(at: &[f64], got: &[f64]) -> Off {
    relative(got, &reflectances(at[0], at[1], at[2]))
}

/// Judges a BRDF at two cosines and the turn between them. The right value is 0 where light comes from below
/// or along the surface, or leaves there.
fn over(at: &[f64], got: &[f64], f: impl Fn(surface::Vector, surface::Vector) -> f64) -> Off {
    let direction =
        |cos: f64, turns: f64| Direction::from_cosine(cos as f32, turns as f32).to_array().map(f64::from);
    let exact =
        if at[1] > 0.0 && at[2] > 0.0 { f(direction(at[1], 0.0), direction(at[2], at[3])) } else { 0.0 };
    share(got, &[exact])
}
