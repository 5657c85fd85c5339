//! Rows 21 to 24, 52 and 53: microfacets that are nearly a mirror, grazing light, and integrals over the
//! hemisphere.

use super::Cases;
use core::f32::consts::{PI, TAU};
use nanospectra::geometry::{Direction, GaussLegendre, Hemisphere};
use nanospectra::math::{cos_turns, sqrt};
use nanospectra::matter::scattering::rho_hd;
use nanospectra::matter::{
    Brdf, Dielectric, Lambert, Microfacet, OrenNayar, Reflector, TrowbridgeReitz, VisibleNormals,
};

pub fn rows(cases: &mut impl Cases) {
    cases.row("21", &PEAKS, naive_density, density);
    cases.row("22", &[[0.0, 0.0], [1e-30, 0.0], [-1.0, 0.0]], naive_density, density);
    cases.row("23", &grazing(0.1), naive_facets, facets);
    cases.row("24a", &grazing(0.9), naive_matt, matt);
    cases.row("24b", &grazing(0.0), naive_matt, matt_or_lambert);
    cases.row("52", &GLOSS, gauss_32, visible_normals);
    cases.row("53", &[[1.5]], gauss_in_the_square, gauss_in_the_cosine);
}

/// Pairs of a roughness and a zenith angle, at the peak of the lobe, half way down and in its tail.
const PEAKS: [[f32; 2]; 10] = [
    [1e-3, 0.044_414_558],
    [1e-3, 0.0],
    [1e-3, 3e-4],
    [1e-3, 1e-3],
    [1e-3, 1e-2],
    [1e-4, 0.0],
    [1e-4, 3e-5],
    [1e-4, 1e-4],
    [1e-4, 1e-3],
    [0.3, 0.2],
];

fn density(&[alpha, theta]: &[f32; 2]) -> [f32; 1] {
    [TrowbridgeReitz::new(alpha).d(Direction::spherical(theta, 0.7))]
}

fn naive_density(&[alpha, theta]: &[f32; 2]) -> [f32; 1] {
    [naive_d(alpha, Direction::spherical(theta, 0.7).cos_theta())]
}

fn naive_d(alpha: f32, cos: f32) -> f32 {
    let a2 = alpha * alpha;
    let below = cos * cos * (a2 - 1.0) + 1.0;
    a2 / (PI * below * below)
}

/// Returns a roughness, two cosines and the turn between them, down to the horizon and below it.
fn grazing(roughness: f32) -> [[f32; 4]; 8] {
    [
        [roughness, 1e-6, 1e-6, 0.5],
        [roughness, 1e-6, 1.0, 0.0],
        [roughness, 1e-3, 0.3, 0.25],
        [roughness, 1e-6, 2e-6, 0.3],
        [roughness, 0.0, 0.0, 0.0],
        [roughness, 0.0, 0.5, 0.5],
        [roughness, 0.5, -0.5, 0.5],
        [roughness, 0.7, 0.6, 0.4],
    ]
}

fn pair(&[_, out, into, turns]: &[f32; 4]) -> (Direction, Direction) {
    (Direction::from_cosine(out, 0.0), Direction::from_cosine(into, turns))
}

/// Computes the textbook's D G F / (4 cos cos).
fn naive_facets(at: &[f32; 4]) -> [f32; 1] {
    let (wo, wi) = pair(at);
    let [alpha, ..] = *at;
    let [a, b] = [wo, wi].map(Direction::to_array);
    let sum = [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
    let cos_m = sum[2] / sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    let (o, i) = (wo.cos_theta(), wi.cos_theta());
    let lambda = |cos: f32| 0.5 * (sqrt(1.0 + alpha * alpha * (1.0 - cos * cos) / (cos * cos)) - 1.0);
    let g2 = 1.0 / (1.0 + lambda(o) + lambda(i));
    [naive_d(alpha, cos_m) * g2 / (4.0 * o * i)]
}

fn facets(at: &[f32; 4]) -> [f32; 1] {
    let (wo, wi) = pair(at);
    let [alpha, ..] = *at;
    [Microfacet { facets: TrowbridgeReitz::new(alpha), boundary: 1.0 }.f(wo, wi)]
}

const ALBEDO: f32 = 0.5;

/// Computes Oren and Nayar's qualitative model of 1994.
fn naive_matt(at: &[f32; 4]) -> [f32; 1] {
    let [sigma, out, into, turns] = *at;
    let s2 = sigma * sigma;
    let (a, b) = (1.0 - s2 / (2.0 * (s2 + 0.33)), 0.45 * s2 / (s2 + 0.09));
    let cos_phi = cos_turns(turns);
    let across = if cos_phi > 0.0 { cos_phi } else { 0.0 };
    // The factor sin(alpha) tan(beta), where beta is the smaller angle.
    let sine = |cos: f32| sqrt(1.0 - cos * cos);
    let larger = if out > into { out } else { into };
    [ALBEDO / PI * (a + b * across * (sine(out) * sine(into) / larger))]
}

fn matt(at: &[f32; 4]) -> [f32; 1] {
    let (wo, wi) = pair(at);
    let [sigma, ..] = *at;
    [OrenNayar::new(ALBEDO, sigma).f(wo, wi)]
}

/// Returns NaN unless a surface without roughness has exactly the bits of Lambert's law.
fn matt_or_lambert(at: &[f32; 4]) -> [f32; 1] {
    let (wo, wi) = pair(at);
    let [flat] = matt(at);
    let lambert = Lambert(ALBEDO).f(wo, wi);
    [if flat.to_bits() == lambert.to_bits() { lambert } else { f32::NAN }]
}

/// Pairs of a roughness and a cosine.
const GLOSS: [[f32; 2]; 6] = [[0.05, 0.1], [0.05, 0.5], [0.05, 1.0], [1e-3, 0.1], [0.2, 0.3], [0.5, 0.7]];

fn white(alpha: f32) -> Microfacet<f32> {
    Microfacet { facets: TrowbridgeReitz::new(alpha), boundary: 1.0 }
}

fn gauss_32(&[alpha, cos]: &[f32; 2]) -> [f32; 1] {
    [rho_hd(&white(alpha), Direction::from_cosine(cos, 0.0), &GaussLegendre::<32, 32>)]
}

fn visible_normals(&[alpha, cos]: &[f32; 2]) -> [f32; 1] {
    [rho_hd(&white(alpha), Direction::from_cosine(cos, 0.0), &VisibleNormals::<12, 12>)]
}

/// The four positive ones of eight Gauss-Legendre nodes on -1..1, and their weights.
const NODES: [(f32, f32); 4] = [
    (0.183_434_64, 0.362_683_78),
    (0.525_532_4, 0.313_706_65),
    (0.796_666_5, 0.222_381_03),
    (0.960_289_86, 0.101_228_54),
];

/// Integrates the flux over the square of the cosine, in which the flux is uniform.
fn gauss_in_the_square(&[eta]: &[f32; 1]) -> [f32; 1] {
    let mut sum = 0.0;
    for (x, weight) in NODES {
        for square in [0.5 * (1.0 - x), 0.5 * (1.0 + x)] {
            sum += 0.5 * weight * Dielectric::new(eta).reflectance(sqrt(square));
        }
    }
    [sum]
}

fn gauss_in_the_cosine(&[eta]: &[f32; 1]) -> [f32; 1] {
    let flux = GaussLegendre::<8, 1>.integrate_projected(|w| Dielectric::new(eta).reflectance(w.cos_theta()));
    [flux * 2.0 / TAU]
}
