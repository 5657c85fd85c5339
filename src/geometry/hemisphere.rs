//! Integrals over the hemisphere above a surface, by fixed nodes.

use crate::geometry::gauss_legendre::nodes_and_weights;
use crate::geometry::{Direction, Integrand, Total};
use crate::math::sqrt;
use core::f32::consts::{PI, TAU};

/// A direction that stands for a piece of the hemisphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// Where the piece is.
    pub direction: Direction,
    /// Its solid angle, in sr: 2 pi for all pieces together.
    pub solid_angle_sr: f32,
    /// Its projected solid angle, in sr: times the cosine of the zenith angle; pi for all together.
    pub projected_sr: f32,
}

/// A rule that divides the hemisphere into pieces, as [`Uniform`], [`Cosine`] and [`GaussLegendre`] do into
/// `MU` rings of `PHI` pieces at equal azimuths. None of them has a node on the horizon or the zenith.
///
/// ```
/// # use nanospectra::geometry::{Direction, GaussLegendre, Hemisphere};
/// // The irradiance under a sky that is three times as bright at the zenith as at the horizon (CIE overcast):
/// // 7 pi / 9 of the zenith's radiance.
/// let sky = |w: Direction| (1.0 + 2.0 * w.cos_theta()) / 3.0;
/// let e = GaussLegendre::<4, 1>.integrate_projected(sky);
/// assert!((e - 2.443_461).abs() < 1e-6);
/// ```
pub trait Hemisphere {
    /// The pieces.
    fn nodes(&self) -> impl Iterator<Item = Node>;

    /// The integral of `f` over solid angle.
    fn integrate<V: Integrand>(&self, mut f: impl FnMut(Direction) -> V) -> V {
        let mut total = Total::new();
        self.nodes().for_each(|node| total.add(f(node.direction) * node.solid_angle_sr));
        total.sum
    }

    /// The integral of `f` over projected solid angle, that is of `f` times the cosine: irradiance from
    /// radiance.
    fn integrate_projected<V: Integrand>(&self, mut f: impl FnMut(Direction) -> V) -> V {
        let mut total = Total::new();
        self.nodes().for_each(|node| total.add(f(node.direction) * node.projected_sr));
        total.sum
    }
}

/// Pieces of equal solid angle, by the midpoint rule: the plainest rule there is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Uniform<const MU: usize, const PHI: usize>;

/// Pieces of equal projected solid angle: each is an equal share of what a matt surface reflects.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cosine<const MU: usize, const PHI: usize>;

/// Gauss's nodes in the cosine of the zenith angle, equal azimuths: the rule for what is smooth.
///
/// # Accuracy
/// 8 rings integrate Fresnel's reflectance of glass to 2e-8 (`tests/matter/hard_cases_surfaces.rs`), and
/// rough microfacets (alpha from 0.5, up to 70 degrees from the normal) to 4e-4 with 8 x 32 nodes. Not for
/// gloss: at alpha = 0.05 even 32 x 32 nodes can miss three quarters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct GaussLegendre<const MU: usize, const PHI: usize>;

impl<const MU: usize, const PHI: usize> Hemisphere for Uniform<MU, PHI> {
    fn nodes(&self) -> impl Iterator<Item = Node> {
        let rings = (0..MU).map(|ring| ((ring as f32 + 0.5) / MU as f32, 1.0 / MU as f32));
        rings.flat_map(|(cosine, share)| ring::<PHI>(cosine, TAU * share, TAU * share * cosine))
    }
}

impl<const MU: usize, const PHI: usize> Hemisphere for Cosine<MU, PHI> {
    fn nodes(&self) -> impl Iterator<Item = Node> {
        let rings = (0..MU).map(|ring| (sqrt((ring as f32 + 0.5) / MU as f32), 1.0 / MU as f32));
        rings.flat_map(|(cosine, share)| ring::<PHI>(cosine, PI * share / cosine, PI * share))
    }
}

impl<const MU: usize, const PHI: usize> GaussLegendre<MU, PHI> {
    /// Cosine and share of each ring.
    const RINGS: [(f32, f32); MU] = nodes_and_weights();
}

impl<const MU: usize, const PHI: usize> Hemisphere for GaussLegendre<MU, PHI> {
    fn nodes(&self) -> impl Iterator<Item = Node> {
        let rings = const { &Self::RINGS }.iter();
        rings.flat_map(|(cosine, share)| ring::<PHI>(*cosine, TAU * share, TAU * share * cosine))
    }
}

/// `PHI` nodes at equal azimuths, half a step off the x axis, that share out a ring's solid angles.
fn ring<const PHI: usize>(cosine: f32, solid_angle_sr: f32, projected_sr: f32) -> impl Iterator<Item = Node> {
    let share = 1.0 / PHI as f32;
    (0..PHI).map(move |k| Node {
        direction: Direction::from_cosine(cosine, (k as f32 + 0.5) * share),
        solid_angle_sr: solid_angle_sr * share,
        projected_sr: projected_sr * share,
    })
}
