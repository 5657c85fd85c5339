//! Rows 1 to 13: Planck's law, solid angles and form factors.

use super::claim::Naive::{Fails, Holds};
use super::claim::{Claim, Off, absolute, relative, share};
use model::{geometry, planck};

pub const CLAIMS: &[Claim] = &[
    Claim {
        row: "1",
        what: "Planck, 2hc²/λ⁵/(eˣ − 1) in SI units",
        inputs: "360 to 830 nm, 500 K to 1e5 K",
        measured: "relative",
        limit: 1.0,
        unit: "(3x + 8) e",
        asked: "",
        naive: Holds,
        test: "spectrum/hard_cases::planck_is_right_wherever_light_is_seen",
        judge: radiance,
    },
    Claim {
        row: "2",
        what: "Planck of great heat",
        inputs: "360, 555, 830 nm at 1e8, 1e10, 1e12 K",
        measured: "relative",
        limit: 8.0,
        unit: "e",
        asked: "4 e",
        naive: Fails,
        test: "spectrum/hard_cases::planck_holds_at_a_trillion_kelvin_and_for_x_rays",
        judge: |at, got| relative(got, &[1e-9 * planck::radiance(at[0], at[1])]),
    },
    Claim {
        row: "3",
        what: "Planck of X-rays, λ⁵ underflows",
        inputs: "0.1 and 1 nm, 300 K to 1e12 K",
        measured: "relative",
        limit: 8.0,
        unit: "e",
        asked: "4 e",
        naive: Fails,
        test: "spectrum/hard_cases::planck_holds_at_a_trillion_kelvin_and_for_x_rays",
        judge: |at, got| {
            let exact = 1e-9 * planck::radiance(at[0], at[1]);
            if exact < 1e-38 { absolute(got, &[0.0]) } else { relative(got, &[exact]) }
        },
    },
    Claim {
        row: "4",
        what: "Planck where eˣ overflows",
        inputs: "555 nm, 250 to 320 K",
        measured: "relative",
        limit: 1.0,
        unit: "(3x + 8) e, 0 below 1e-38",
        asked: "(x + 6) e",
        naive: Fails,
        test: "spectrum/hard_cases::planck_fades_out_instead_of_stopping_where_the_exponential_overflows",
        judge: |at, got| {
            let exact = 1e-9 * planck::radiance(at[0], at[1]);
            if exact < 1e-38 { absolute(got, &[0.0]) } else { radiance(at, got) }
        },
    },
    Claim {
        row: "5",
        what: "shape over 560 nm, quotient of two Plancks",
        inputs: "360 to 830 nm, 100 K to 1e5 K",
        measured: "relative",
        limit: 1.0,
        unit: "(4|Δx| + 12) e",
        asked: "(|Δx| + 8) e",
        naive: Fails,
        test: "spectrum/hard_cases::the_shape_of_a_black_body_is_right_where_both_ends_underflow",
        judge: |at, got| {
            let ln = |nm| planck::ln_radiance(nm, at[1]);
            let dx = planck::x(at[0], at[1]) - planck::x(560.0, at[1]);
            relative(got, &[(ln(at[0]) - ln(560.0)).exp()]).per(4.0 * dx.abs() + 12.0)
        },
    },
    Claim {
        row: "6",
        what: "Planck by micromath's exp",
        inputs: "as row 1",
        measured: "relative",
        limit: 1.0,
        unit: "(3x + 8) e",
        asked: "",
        naive: Fails,
        test: "spectrum/hard_cases::micromath_is_no_backend_for_colour",
        judge: radiance,
    },
    Claim {
        row: "7",
        what: "cone, 2π(1 − cos θ)",
        inputs: "1e-4 to 3 rad, the sun",
        measured: "relative",
        limit: 4.0,
        unit: "e",
        asked: "",
        naive: Fails,
        test: "radiometry/hard_cases::narrow_cones_keep_their_solid_angle",
        judge: |at, got| relative(got, &[geometry::cone(at[0])]),
    },
    Claim {
        row: "8",
        what: "sphere, 2π(1 − √(1 − s²))",
        inputs: "r/d 1e-4 to 0.999, the sun",
        measured: "relative",
        limit: 6.0,
        unit: "e",
        asked: "4 e",
        naive: Fails,
        test: "radiometry/hard_cases::far_spheres_keep_their_solid_angle",
        judge: |at, got| relative(got, &[geometry::sphere(at[0], at[1])]),
    },
    Claim {
        row: "9",
        what: "coaxial discs, ½(S − √(S² − 4…))",
        inputs: "r/d 1e-3 to 3",
        measured: "relative",
        limit: 6.0,
        unit: "e",
        asked: "",
        naive: Fails,
        test: "radiometry/hard_cases::far_coaxial_discs_keep_their_form_factor",
        judge: |at, got| relative(got, &[geometry::coaxial_discs(at[0], at[1], 1.0)]),
    },
    Claim {
        row: "10",
        what: "small triangles, a·(b × c)",
        inputs: "size 1e-3 to 1e-6 at a distance of 1",
        measured: "relative",
        limit: 1e-4,
        unit: "",
        asked: "",
        naive: Fails,
        test: "radiometry/hard_cases::small_triangles_keep_their_solid_angle",
        judge: small_triangle,
    },
    Claim {
        row: "11a",
        what: "the same by L'Huilier",
        inputs: "as row 10",
        measured: "relative",
        limit: 1e-4,
        unit: "",
        asked: "",
        naive: Fails,
        test: "radiometry/hard_cases::small_triangles_keep_their_solid_angle",
        judge: small_triangle,
    },
    Claim {
        row: "11b",
        what: "the same by Girard",
        inputs: "as row 10",
        measured: "relative",
        limit: 1e-4,
        unit: "",
        asked: "",
        naive: Fails,
        test: "radiometry/hard_cases::small_triangles_keep_their_solid_angle",
        judge: small_triangle,
    },
    Claim {
        row: "12",
        what: "huge triangles, atan for atan2",
        inputs: "height 0.1 to 1e-7 above the observer",
        measured: "relative",
        limit: 8.0,
        unit: "e",
        asked: "",
        naive: Fails,
        test: "radiometry/hard_cases::huge_triangles_fill_the_hemisphere",
        judge: |at, got| relative(got, &[geometry::triangle(corners(at))]),
    },
    Claim {
        row: "13",
        what: "triangles without a view, Girard",
        inputs: "no area, observer on a vertex or in the plane",
        measured: "absolute",
        limit: 0.0,
        unit: "",
        asked: "",
        naive: Fails,
        test: "radiometry/hard_cases::triangles_without_a_view_are_zero",
        judge: |_, got| absolute(got, &[0.0]),
    },
];

/// Per nm, allowed as much as rounding the inputs costs.
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
