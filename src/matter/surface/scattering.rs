//! Integrals over a BRDF: the radiance that a surface scatters, its reflectances, and checks of its energy
//! and reciprocity.
//!
//! Use this module to compute what a surface looks like under a sky or another extended light, to find its
//! albedo, and to test a BRDF of your own. Each function takes a [`Quadrature`], the rule by which it
//! integrates: one of the [`Hemisphere`] rules for matt and rough surfaces,
//! [`VisibleNormals`](crate::matter::VisibleNormals) for microfacets and
//! [`Specular`](crate::matter::Specular) for mirrors.
//!
//! # Example
//!
//! ```
//! use nanospectra::geometry::{Direction, GaussLegendre};
//! use nanospectra::matter::{Lambert, scattering};
//! // A matt surface that reflects 0.6 does so in every sense of the word.
//! let (paper, rule) = (Lambert(0.6), GaussLegendre::<8, 8>);
//! let from = Direction::spherical(0.7, 0.0);
//! assert!((scattering::rho_hd(&paper, from, &rule) - 0.6).abs() < 1e-6);
//! assert!((scattering::rho_dh(&paper, from, &rule) - 0.6).abs() < 1e-6);
//! assert!((scattering::rho_hh(&paper, &rule, &rule) - 0.6).abs() < 1e-6);
//! // Light takes the same way back, and no more leaves than arrives.
//! assert_eq!(scattering::reciprocity(&paper, &rule), 0.0);
//! assert!((scattering::white_furnace(&paper, &rule, &rule) - 0.6).abs() < 1e-6);
//! ```

use crate::geometry::{Direction, Hemisphere, Integrand, Total};
use crate::matter::surface::brdf::Brdf;
use core::f32::consts::FRAC_1_PI;
use core::ops::Mul;

/// A rule that integrates a BRDF times a cosine over the hemisphere.
///
/// Every [`Hemisphere`] rule is one for every BRDF. [`VisibleNormals`](crate::matter::VisibleNormals) is the
/// rule for glossy microfacets, and [`Specular`](crate::matter::Specular) that for mirrors, which reflect in
/// one direction only. See the [example](self#example).
pub trait Quadrature<B: Brdf> {
    /// Calls `visit` for each node `wi` with the share of the light from there that goes to `wo`.
    ///
    /// The share is f(wo, wi) times the projected solid angle that the node stands for.
    fn arriving(&self, brdf: &B, wo: Direction, visit: impl FnMut(Direction, B::Value));

    /// Calls `visit` for each node `wo` with the share of the light from `wi` that goes there.
    ///
    /// The share is f(wo, wi) times the projected solid angle that the node stands for.
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

/// Computes the radiance that leaves towards `wo` where the radiance `li` arrives from the hemisphere.
///
/// This is the scattering equation, Lo(wo) = integral of f(wo, wi) Li(wi) cos(theta_i) over solid angle. `li`
/// returns a number or a spectrum of power for each direction.
///
/// # Example
///
/// ```
/// use nanospectra::{Light, Reflectance, matter::{Lambert, scattering::scattered}};
/// use nanospectra::geometry::{Direction, GaussLegendre};
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

/// Computes the hemispherical-directional reflectance: the radiance that leaves towards `wo`, divided by that
/// of uniform light from the whole hemisphere.
///
/// See the [example](self#example).
pub fn rho_hd<B: Brdf>(brdf: &B, wo: Direction, quadrature: &impl Quadrature<B>) -> B::Value {
    let mut total = Total::new();
    quadrature.arriving(brdf, wo, |_, share| total.add(share));
    total.sum
}

/// Computes the directional-hemispherical reflectance: the share of the power from `wi` that leaves the
/// surface.
///
/// By reciprocity it equals [`rho_hd`] of the same direction. See the [example](self#example).
pub fn rho_dh<B: Brdf>(brdf: &B, wi: Direction, quadrature: &impl Quadrature<B>) -> B::Value {
    let mut total = Total::new();
    quadrature.leaving(brdf, wi, |_, share| total.add(share));
    total.sum
}

/// Computes the hemispherical-hemispherical reflectance: the share of the power of uniform light from the
/// whole hemisphere that leaves the surface.
///
/// `outer` is the rule for the directions in which light leaves, `inner` for those from which it comes. See
/// the [example](self#example).
pub fn rho_hh<B: Brdf>(brdf: &B, outer: &impl Hemisphere, inner: &impl Quadrature<B>) -> B::Value {
    outer.integrate_projected(|wo| rho_hd(brdf, wo, inner)) * FRAC_1_PI
}

/// Computes by how much a BRDF violates Helmholtz's reciprocity, in 1/sr.
///
/// This is the largest |f(wo, wi) - f(wi, wo)| over all pairs of nodes and all wavelengths. It is 0 for every
/// surface of [`matter`](crate::matter). See the [example](self#example).
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

/// Computes the largest [`rho_hd`] over the directions of `outer` and all wavelengths (the white furnace
/// test).
///
/// Above 1 the surface would return more light than falls on it, which no matter does.
///
/// # Example
///
/// ```
/// use nanospectra::matter::{Lambert, OrenNayar, scattering::white_furnace};
/// use nanospectra::geometry::GaussLegendre;
/// let rule = GaussLegendre::<16, 32>;
/// assert!((white_furnace(&OrenNayar::new(1.0, 1.0), &rule, &rule) - 1.0).abs() < 1e-2);
/// assert!(white_furnace(&Lambert(1.1), &rule, &rule) > 1.0); // creates light
/// ```
pub fn white_furnace<B: Brdf>(brdf: &B, outer: &impl Hemisphere, inner: &impl Quadrature<B>) -> f32 {
    outer.nodes().fold(0.0, |most, node| larger(most, rho_hd(brdf, node.direction, inner).peak()))
}

/// The larger of two numbers, or NaN if one of them is NaN.
fn larger(a: f32, b: f32) -> f32 {
    if b <= a || a.is_nan() { a } else { b }
}
