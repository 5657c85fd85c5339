//! Integrates over the hemisphere above a surface by rules of fixed nodes.

use crate::geometry::gauss_legendre::nodes_and_weights;
use crate::geometry::{Direction, Integrand, Total};
use crate::math::sqrt;
use core::f32::consts::{PI, TAU};

/// A direction that represents one piece of the hemisphere, with the piece's size.
///
/// [`Hemisphere::nodes`] lists the nodes of a rule. See its [example](Hemisphere#example).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// The direction at which the function to integrate is evaluated for this piece.
    pub direction: Direction,
    /// The solid angle that the piece covers, in sr. All pieces together cover 2 pi.
    pub solid_angle_sr: f32,
    /// The projected solid angle that the piece covers, in sr: its solid angle times the cosine of its zenith
    /// angle. All pieces together cover pi.
    pub projected_sr: f32,
}

/// A rule that divides the hemisphere above a surface into pieces, over which functions are integrated.
///
/// [`Uniform`], [`Cosine`] and [`GaussLegendre`] divide it into `MU` rings of `PHI` pieces at equal steps of
/// azimuth. None of them has a node on the horizon or at the zenith. Call
/// [`integrate_projected`](Self::integrate_projected) to get irradiance from radiance.
///
/// # Example
/// ```
/// use nanospectra::geometry::{Direction, GaussLegendre, Hemisphere};
///
/// // The irradiance under the CIE overcast sky, which is three times as bright at the zenith as at the
/// // horizon, is 7 pi / 9 of the zenith's radiance.
/// let sky = |w: Direction| (1.0 + 2.0 * w.cos_theta()) / 3.0;
/// let e = GaussLegendre::<4, 1>.integrate_projected(sky);
/// assert!((e - 2.443_461).abs() < 1e-6);
///
/// // The same sky without the cosine of the receiving surface: its mean radiance is 2 / 3 of the zenith's.
/// assert!((GaussLegendre::<4, 1>.integrate(sky) / core::f32::consts::TAU - 2.0 / 3.0).abs() < 1e-6);
///
/// // What `integrate_projected` computes, written out.
/// let sum: f32 =
///     GaussLegendre::<4, 1>.nodes().map(|node| sky(node.direction) * node.projected_sr).sum();
/// assert!((sum - e).abs() < 1e-6);
/// ```
pub trait Hemisphere {
    /// Returns the pieces into which the rule divides the hemisphere. See the [example](Hemisphere#example).
    fn nodes(&self) -> impl Iterator<Item = Node>;

    /// Returns the integral of `f` over the solid angle of the hemisphere.
    ///
    /// See the [example](Hemisphere#example).
    ///
    /// `f` returns a number, a spectrum, or any other [`Integrand`].
    fn integrate<V: Integrand>(&self, mut f: impl FnMut(Direction) -> V) -> V {
        let mut total = Total::new();
        self.nodes().for_each(|node| total.add(f(node.direction) * node.solid_angle_sr));
        total.sum
    }

    /// Returns the integral of `f` times the cosine of the zenith angle, which gives irradiance for a
    /// radiance.
    ///
    /// See the [example](Hemisphere#example).
    fn integrate_projected<V: Integrand>(&self, mut f: impl FnMut(Direction) -> V) -> V {
        let mut total = Total::new();
        self.nodes().for_each(|node| total.add(f(node.direction) * node.projected_sr));
        total.sum
    }
}

/// A rule that divides the hemisphere into pieces of equal solid angle, with nodes at their midpoints.
///
/// It is the simplest rule, and suits functions that are not smooth.
///
/// # Example
/// ```
/// use nanospectra::geometry::{Hemisphere, Uniform};
/// // The cap within 60 degrees of the normal has a solid angle of 2 pi (1 - cos 60 degrees) = pi.
/// let cap = Uniform::<16, 1>.integrate(|w| if w.cos_theta() > 0.5 { 1.0 } else { 0.0 });
/// assert!((cap - core::f32::consts::PI).abs() < 1e-5);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Uniform<const MU: usize, const PHI: usize>;

/// A rule that divides the hemisphere into pieces of equal projected solid angle.
///
/// A matt surface reflects an equal share of its light into each piece.
///
/// # Example
/// ```
/// use nanospectra::geometry::{Cosine, Hemisphere};
/// // The cap within 60 degrees of the normal receives sin^2 60 degrees = 3 / 4 of a matt surface's light.
/// let cap = Cosine::<16, 1>.integrate_projected(|w| if w.cos_theta() > 0.5 { 1.0 } else { 0.0 });
/// assert!((cap / core::f32::consts::PI - 0.75).abs() < 1e-6);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cosine<const MU: usize, const PHI: usize>;

/// A rule that suits smooth functions, with Gauss-Legendre nodes in the cosine of the zenith angle.
///
/// Azimuths are divided into equal steps. Among the rules of this module it needs the fewest nodes for a
/// smooth function. See the [example](Hemisphere#example).
///
/// # Accuracy
/// 8 rings integrate Fresnel's reflectance of glass to 2e-8 (`tests/matter/hard_cases_surfaces.rs`), and 8 x
/// 32 nodes integrate rough microfacets (alpha of at least 0.5, up to 70 degrees from the normal) to 4e-4. Do
/// not use the rule for glossy surfaces: at alpha = 0.05 even 32 x 32 nodes can miss three quarters of the
/// light.
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
        let rings = (0..MU).map(|ring| {
            let [below, middle, above] = [0.0, 0.5, 1.0].map(|part| sqrt((ring as f32 + part) / MU as f32));
            // Between two circles of latitude lies 2 pi times the difference of their cosines. The difference
            // of the roots is the share over their sum.
            (middle, TAU / MU as f32 / (below + above))
        });
        rings.flat_map(|(cosine, solid_angle)| ring::<PHI>(cosine, solid_angle, PI / MU as f32))
    }
}

impl<const MU: usize, const PHI: usize> GaussLegendre<MU, PHI> {
    /// The cosine of each ring's zenith angle, and the ring's share of the hemisphere.
    const RINGS: [(f32, f32); MU] = nodes_and_weights();
}

impl<const MU: usize, const PHI: usize> Hemisphere for GaussLegendre<MU, PHI> {
    fn nodes(&self) -> impl Iterator<Item = Node> {
        let rings = const { &Self::RINGS }.iter();
        rings.flat_map(|(cosine, share)| ring::<PHI>(*cosine, TAU * share, TAU * share * cosine))
    }
}

/// Divides a ring into `PHI` nodes at equal steps of azimuth, the first half a step from the x axis.
fn ring<const PHI: usize>(cosine: f32, solid_angle_sr: f32, projected_sr: f32) -> impl Iterator<Item = Node> {
    let share = 1.0 / PHI as f32;
    (0..PHI).map(move |k| Node {
        direction: Direction::from_cosine(cosine, (k as f32 + 0.5) * share),
        solid_angle_sr: solid_angle_sr * share,
        projected_sr: projected_sr * share,
    })
}
