//! The scattering equation, the reflectances that are integrals of it, and checks of a BRDF.

use crate::geometry::{Direction, Hemisphere, Integrand, Total};
use crate::matter::surface::brdf::Brdf;
use core::f32::consts::FRAC_1_PI;
use core::ops::Mul;

/// A rule for integrals of a BRDF times a cosine over the hemisphere.
///
/// Every [`Hemisphere`] rule is one for every BRDF, [`VisibleNormals`](crate::matter::VisibleNormals) the one
/// for glossy microfacets, [`Specular`](crate::matter::Specular) the one for mirrors, which have one
/// direction only.
pub trait Quadrature<B: Brdf> {
    /// Calls `visit` with directions `wi` and f(wo, wi) times their projected solid angle: the share that
    /// goes to `wo`.
    fn arriving(&self, brdf: &B, wo: Direction, visit: impl FnMut(Direction, B::Value));

    /// Calls `visit` with directions `wo` and f(wo, wi) times their projected solid angle: the share from
    /// `wi`.
    fn leaving(&self, brdf: &B, wi: Direction, visit: impl FnMut(Direction, B::Value));
}

impl<B: Brdf, H: Hemisphere> Quadrature<B> for H {
    fn arriving(&self, brdf: &B, wo: Direction, mut visit: impl FnMut(Direction, B::Value)) {
        self.nodes().for_each(|node| visit(node.direction, brdf.f(wo, node.direction) * node.projected_sr));
    }

    fn leaving(&self, brdf: &B, wi: Direction, mut visit: impl FnMut(Direction, B::Value)) {
        self.nodes().for_each(|node| visit(node.direction, brdf.f(node.direction, wi) * node.projected_sr));
    }
}

/// The scattering equation: the radiance that leaves towards `wo` where radiance `li` arrives from the
/// hemisphere.
///
/// Lo(wo) = integral of f(wo, wi) Li(wi) cos(theta_i) over solid angle. `li` may be a number or a spectrum of
/// power.
///
/// ```
/// # use nanospectra::{Light, Reflectance, matter::{Lambert, scattering::scattered}};
/// # use nanospectra::geometry::{Direction, GaussLegendre};
/// // A sky that is bright above and dark at the horizon, on gray paper.
/// let paper = Lambert(Reflectance::<16>::flat(0.6));
/// let sky = |wi: Direction| Light::<16>::flat(wi.cos_theta());
/// let lo = scattered(&paper, Direction::NORMAL, &GaussLegendre::<4, 1>, sky);
/// assert!((lo.values()[0] - 0.4).abs() < 1e-6); // 0.6 / pi times 2 pi / 3
/// ```
pub fn scattered<B: Brdf, L: Integrand + Mul<B::Value, Output = L>>(
    brdf: &B,
    wo: Direction,
    quadrature: &impl Quadrature<B>,
    mut li: impl FnMut(Direction) -> L,
) -> L {
    let mut radiance = Total::new();
    quadrature.arriving(brdf, wo, |wi, share| radiance.add(li(wi) * share));
    radiance.sum
}

/// Hemispherical-directional reflectance: the radiance towards `wo` over that of even light from the whole
/// hemisphere.
pub fn rho_hd<B: Brdf>(brdf: &B, wo: Direction, quadrature: &impl Quadrature<B>) -> B::Value {
    let mut total = Total::new();
    quadrature.arriving(brdf, wo, |_, share| total.add(share));
    total.sum
}

/// Directional-hemispherical reflectance: the share of the power from `wi` that leaves; by reciprocity
/// [`rho_hd`] of the same direction.
pub fn rho_dh<B: Brdf>(brdf: &B, wi: Direction, quadrature: &impl Quadrature<B>) -> B::Value {
    let mut total = Total::new();
    quadrature.leaving(brdf, wi, |_, share| total.add(share));
    total.sum
}

/// Hemispherical-hemispherical reflectance: the share of the power of an even light from the whole hemisphere
/// that leaves; `outer` is the rule for where to, `inner` for where from.
pub fn rho_hh<B: Brdf>(brdf: &B, outer: &impl Hemisphere, inner: &impl Quadrature<B>) -> B::Value {
    outer.integrate_projected(|wo| rho_hd(brdf, wo, inner)) * FRAC_1_PI
}

/// By how much a BRDF fails Helmholtz' reciprocity: the largest |f(wo, wi) - f(wi, wo)| over all pairs of
/// nodes and all wavelengths, 1/sr. 0 for every surface of [`matter`](crate::matter).
pub fn reciprocity<B: Brdf>(brdf: &B, nodes: &impl Hemisphere) -> f32 {
    let mut most = 0.0;
    for a in nodes.nodes() {
        for b in nodes.nodes() {
            let difference = brdf.f(a.direction, b.direction).distance(&brdf.f(b.direction, a.direction));
            most = larger(most, difference);
        }
    }
    most
}

/// The white furnace: the largest [`rho_hd`] over the directions of `outer` and all wavelengths. Above 1 a
/// surface would return more light than falls on it, as no matter does.
///
/// ```
/// # use nanospectra::matter::{Lambert, OrenNayar, scattering::white_furnace};
/// # use nanospectra::geometry::GaussLegendre;
/// let rule = GaussLegendre::<16, 32>;
/// assert!((white_furnace(&OrenNayar::new(1.0, 1.0), &rule, &rule) - 1.0).abs() < 1e-2);
/// assert!(white_furnace(&Lambert(1.1), &rule, &rule) > 1.0); // creates light
/// ```
pub fn white_furnace<B: Brdf>(brdf: &B, outer: &impl Hemisphere, inner: &impl Quadrature<B>) -> f32 {
    outer.nodes().fold(0.0, |most, node| larger(most, rho_hd(brdf, node.direction, inner).peak()))
}

/// The larger of two, and NaN if there is one.
fn larger(a: f32, b: f32) -> f32 {
    if b <= a || a.is_nan() { a } else { b }
}
