//! Rows 14 to 24, 52 and 53: Fresnel's equations, microfacets, matt surfaces.

use super::claim::Naive::Fails;
use super::claim::{Claim, Off, absolute, relative, share};
use model::{fresnel, surface};
use nanospectra::radiometry::Direction;
use std::f64::consts::PI;

pub const CLAIMS: &[Claim] = &[
    Claim {
        row: "14",
        what: "Fresnel by the angle of refraction",
        inputs: "η = 1.0001, cos 0.5",
        measured: "relative",
        limit: 8.0,
        unit: "e",
        asked: "",
        naive: Fails,
        test: "matter/hard_cases_surfaces::fresnel_holds_for_media_that_hardly_differ",
        judge: |at, got| relative(got, &reflectances(at[0], 0.0, at[1])),
    },
    Claim {
        row: "15",
        what: "the same, grazing",
        inputs: "η = 1.000001, cos 1e-3",
        measured: "relative",
        limit: 8.0,
        unit: "e",
        asked: "",
        naive: Fails,
        test: "matter/hard_cases_surfaces::fresnel_holds_for_media_that_hardly_differ",
        judge: |at, got| relative(got, &reflectances(at[0], 0.0, at[1])),
    },
    Claim {
        row: "16a",
        what: "total reflection, √ of a negative number",
        inputs: "beyond the critical angle",
        measured: "absolute",
        limit: 0.0,
        unit: "",
        asked: "",
        naive: Fails,
        test: "matter/hard_cases_surfaces::beyond_the_critical_angle_all_is_reflected_and_just_below_nearly_so",
        judge: |_, got| absolute(got, &[1.0, 1.0]),
    },
    Claim {
        row: "16b",
        what: "just below the critical angle",
        inputs: "within 1e-3 of it",
        measured: "absolute",
        limit: 2e-5,
        unit: "",
        asked: "",
        naive: Fails,
        test: "matter/hard_cases_surfaces::beyond_the_critical_angle_all_is_reflected_and_just_below_nearly_so",
        judge: |at, got| absolute(got, &reflectances(at[0], 0.0, at[1])),
    },
    Claim {
        row: "17",
        what: "no boundary, 0/0 at grazing incidence",
        inputs: "η = 1, cos 0 to 1",
        measured: "absolute",
        limit: 0.0,
        unit: "",
        asked: "",
        naive: Fails,
        test: "matter/hard_cases_surfaces::no_boundary_reflects_nothing_and_grazing_light_is_all_reflected",
        judge: |_, got| absolute(got, &[0.0, 0.0]),
    },
    Claim {
        row: "18a",
        what: "reflectance of a metal, pbrt-v3's form",
        inputs: "n = 0.01, k = 20, cos 0.05 to 1",
        measured: "relative",
        limit: 4.0,
        unit: "e",
        asked: "",
        naive: Fails,
        test: "matter/hard_cases_surfaces::metals_reflect_and_absorb_right_down_to_the_best_of_mirrors",
        judge: |at, got| relative(got, &reflectances(at[0], at[1], at[2])),
    },
    Claim {
        row: "18b",
        what: "what it absorbs, 1 − R",
        inputs: "the same",
        measured: "relative",
        limit: 12.0,
        unit: "e",
        asked: "own formula",
        naive: Fails,
        test: "matter/hard_cases_surfaces::metals_reflect_and_absorb_right_down_to_the_best_of_mirrors",
        judge: |at, got| {
            let (s, p) = fresnel::absorbed([at[0], at[1]], at[2]);
            relative(got, &[s, p])
        },
    },
    Claim {
        row: "19",
        what: "a metal's k⁴ overflows",
        inputs: "k = 1e10 and 1e19",
        measured: "relative",
        limit: 4.0,
        unit: "e",
        asked: "finite",
        naive: Fails,
        test: "matter/hard_cases_surfaces::metals_of_any_index_stay_finite",
        judge: |at, got| relative(got, &reflectances(at[0], at[1], at[2])),
    },
    Claim {
        row: "20",
        what: "a metal that is nearly a gas, s",
        inputs: "n = 0.2, k = 1e-4, off the critical angle",
        measured: "relative",
        limit: 8.0,
        unit: "e",
        asked: "",
        naive: Fails,
        test: "matter/hard_cases_surfaces::metals_reflect_and_absorb_right_down_to_the_best_of_mirrors",
        judge: |at, got| relative(got, &reflectances(at[0], at[1], at[2])[..1]),
    },
    Claim {
        row: "21",
        what: "GGX, (n·h)²(α² − 1) + 1",
        inputs: "α = 1e-3 and 1e-4, peak to tail",
        measured: "relative",
        limit: 16.0,
        unit: "e",
        asked: "",
        naive: Fails,
        test: "matter/hard_cases_surfaces::the_density_of_facets_holds_at_its_peak_however_sharp",
        judge: |at, got| {
            let wm = Direction::spherical(at[1] as f32, 0.7).to_array().map(f64::from);
            relative(got, &[surface::ggx_d(at[0], wm)])
        },
    },
    Claim {
        row: "22",
        what: "GGX without roughness",
        inputs: "α = 0, 1e-30, −1 (taken as 1e-4)",
        measured: "relative",
        limit: 16.0,
        unit: "e",
        asked: "no NaN",
        naive: Fails,
        test: "matter/hard_cases_surfaces::no_roughness_makes_facets_infinite",
        judge: |_, got| relative(got, &[1.0 / (PI * 1e-8)]),
    },
    Claim {
        row: "23",
        what: "microfacets, DGF/(4 cos cos)",
        inputs: "α = 0.1, cos 1 to 1e-6, 0 and below",
        measured: "relative",
        limit: 1e-6,
        unit: "",
        asked: "finite",
        naive: Fails,
        test: "matter/hard_cases_surfaces::grazing_light_leaves_brdfs_finite_and_light_from_below_gives_nothing",
        judge: |at, got| over(at, got, |wo, wi| surface::ggx_f(at[0], wo, wi)),
    },
    Claim {
        row: "24a",
        what: "Oren and Nayar's sin α tan β; Portsmouth's model",
        inputs: "σ = 0.9, cos 1 to 1e-6, 0 and below",
        measured: "finite, 0 below",
        limit: 0.0,
        unit: "",
        asked: "",
        naive: Fails,
        test: "matter/hard_cases_surfaces::grazing_light_leaves_brdfs_finite_and_light_from_below_gives_nothing",
        judge: |at, got| {
            let finite = got[0].is_finite() && got[0] >= 0.0;
            if at[1] > 0.0 && at[2] > 0.0 && finite { absolute(got, got) } else { absolute(got, &[0.0]) }
        },
    },
    Claim {
        row: "24b",
        what: "without roughness it is Lambert's to the bit",
        inputs: "σ = 0, the same directions",
        measured: "relative",
        limit: 1.0,
        unit: "e",
        asked: "",
        naive: Fails,
        test: "matter/hard_cases_surfaces::oren_and_nayar_without_roughness_are_lambert_to_the_bit",
        judge: |at, got| over(at, got, |_, _| 0.5 / PI),
    },
    Claim {
        row: "52",
        what: "white GGX by Gauss 32 × 32; by visible normals 12 × 12",
        inputs: "α = 1e-3 to 0.5, cos 0.1 to 1",
        measured: "relative",
        limit: 0.02,
        unit: "",
        asked: "",
        naive: Fails,
        test: "matter/hard_cases_surfaces::visible_normals_find_the_light_at_every_roughness",
        judge: |at, got| share(got, &[surface::ggx_rho(at[0], at[1], 200)]),
    },
    Claim {
        row: "53",
        what: "diffuse reflectance of glass, 8 nodes of Gauss in μ²; in μ",
        inputs: "n = 1.5",
        measured: "absolute",
        limit: 1e-6,
        unit: "",
        asked: "",
        naive: Fails,
        test: "matter/hard_cases_surfaces::eight_rings_give_the_diffuse_reflectance_of_glass",
        judge: |at, got| {
            let steps = 20_000;
            let cosines = (0..steps).map(|k| (f64::from(k) + 0.5) / f64::from(steps));
            let flux: f64 = cosines.map(|c| 2.0 * c * fresnel::unpolarised([at[0], 0.0], c)).sum();
            absolute(got, &[flux / f64::from(steps)])
        },
    },
];

fn reflectances(eta: f64, k: f64, cos: f64) -> [f64; 2] {
    let (s, p) = fresnel::reflectances([eta, k], cos);
    [s, p]
}

/// A BRDF at two cosines and a turn; 0 where light comes from below or along the surface, or goes there.
fn over(at: &[f64], got: &[f64], f: impl Fn(surface::Vector, surface::Vector) -> f64) -> Off {
    let direction =
        |cos: f64, turns: f64| Direction::from_cosine(cos as f32, turns as f32).to_array().map(f64::from);
    let exact =
        if at[1] > 0.0 && at[2] > 0.0 { f(direction(at[1], 0.0), direction(at[2], at[3])) } else { 0.0 };
    share(got, &[exact])
}
