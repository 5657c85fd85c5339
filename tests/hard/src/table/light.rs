//! Rows 1 to 13: Planck's law, solid angles and form factors.

use super::judge::{Judge, Off, absolute, relative, share, zero};
use model::{geometry, planck};

pub const JUDGES: &[(&str, Judge)] = &[
    ("1", radiance),
    ("2", |at, got| relative(got, &[1e-9 * planck::radiance(at[0], at[1])])),
    ("3", |at, got| {
        let exact = 1e-9 * planck::radiance(at[0], at[1]);
        if exact < 1e-38 { absolute(got, &[0.0]) } else { relative(got, &[exact]) }
    }),
    ("4", |at, got| {
        let exact = 1e-9 * planck::radiance(at[0], at[1]);
        if exact < 1e-38 { absolute(got, &[0.0]) } else { radiance(at, got) }
    }),
    ("5", |at, got| {
        let ln = |nm| planck::ln_radiance(nm, at[1]);
        let dx = planck::x(at[0], at[1]) - planck::x(560.0, at[1]);
        relative(got, &[(ln(at[0]) - ln(560.0)).exp()]).per(4.0 * dx.abs() + 12.0)
    }),
    ("6", radiance),
    ("7", |at, got| relative(got, &[geometry::cone(at[0])])),
    ("8", |at, got| relative(got, &[geometry::sphere(at[0], at[1])])),
    ("9", |at, got| relative(got, &[geometry::coaxial_disks(at[0], at[1], 1.0)])),
    ("10", small_triangle),
    ("11a", small_triangle),
    ("11b", small_triangle),
    ("12", |at, got| relative(got, &[geometry::triangle(corners(at))])),
    ("13", zero),
];

/// Judges a radiance per nm, and allows as much as the rounding of the inputs costs.
fn radiance(at: &[f64], got: &[f64]) -> Off {
    let exact = 1e-9 * planck::radiance(at[0], at[1]);
    relative(got, &[exact]).per(3.0 * planck::x(at[0], at[1]) + 8.0)
}

fn corners(at: &[f64]) -> [geometry::Point; 3] {
    [0, 3, 6].map(|k| [at[k], at[k + 1], at[k + 2]])
}

fn small_triangle(at: &[f64], got: &[f64]) -> Off {
    share(got, &[geometry::small_triangle(&geometry::gauss(8), corners(at))])
}
