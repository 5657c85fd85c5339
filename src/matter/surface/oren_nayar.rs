//! Rough matt surfaces, such as plaster.

use crate::geometry::{Direction, Integrand};
use crate::math::{Fast, Math};
use crate::math::{at_least, at_most};
use crate::matter::surface::brdf::{Brdf, visible};
use core::f32::consts::FRAC_1_PI;

/// A rough matt surface that is made of V-shaped grooves, such as plaster, clay or the surface of the moon.
///
/// It sends more light back towards its source than [`Lambert`](crate::matter::Lambert) does, and a sphere of
/// it looks flatter at the edge. This is Oren and Nayar's model in the form that keeps energy and
/// reciprocity: the light that the first reflection in a groove loses is returned by further ones. At
/// roughness 0 the values are those of [`Lambert`](crate::matter::Lambert), bit by bit.
///
/// # Example
///
/// ```
/// use nanospectra::geometry::Direction;
/// use nanospectra::matter::{Brdf, Lambert, OrenNayar};
/// let (plaster, paper) = (OrenNayar::new(0.8, 1.0), Lambert(0.8));
/// let (low, opposite) = (Direction::spherical(1.2, 0.0), Direction::spherical(1.2, 3.141_592_7));
/// // Seen from the side of the lamp, plaster is brighter than paper; seen from the other side it is darker.
/// assert!(plaster.f(low, low) > paper.f(low, low));
/// assert!(plaster.f(opposite, low) < paper.f(opposite, low));
/// assert_eq!(OrenNayar::new(0.8, 0.0).f(opposite, low), paper.f(opposite, low));
/// ```
///
/// # Accuracy
/// 1.5e-7 over the larger of the cosines of both directions, if that is at least 1e-6, compared with the
/// formulas in f64 (searched in `tests/matter/worst_scattering.rs`). A white surface (albedo 1) reflects 1,
/// as closely as a quadrature rule can integrate it.
///
/// # Reference
/// J. Portsmouth, P. Kutz, S. Hill, "EON: a practical energy-preserving rough diffuse BRDF", J. Computer
/// Graphics Techniques 14 (2025), after Oren and Nayar (1994) and Fujii.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrenNayar<V> {
    albedo: V,
    /// The albedo of the light that is reflected more than once.
    multiple: V,
    roughness: f32,
}

/// The share that one reflection loses with roughness at grazing incidence, 1/2 - 2 / (3 pi).
const GRAZING: f32 = 0.287_793_4;
/// The same share in the mean over all directions, 2/3 - 28 / (15 pi).
const MEAN: f32 = 0.072_488_21;

impl<V: Integrand> OrenNayar<V> {
    /// Makes a surface from the reflectance of the sides of its grooves and from its roughness.
    ///
    /// `albedo` is 0..=1, as a number or a spectrum, and `roughness` from 0 (flat) to 1; outside these ranges
    /// they count as the nearer end. See the [example](#example).
    #[must_use]
    pub fn new(albedo: V, roughness: f32) -> Self {
        let roughness = at_most(at_least(roughness, 0.0), 1.0);
        let mean = (1.0 + MEAN * roughness) / (1.0 + GRAZING * roughness);
        let albedo = albedo.map(|r| at_most(at_least(r, 0.0), 1.0));
        let multiple = albedo.map(|r| r * r * mean / (1.0 - r * (1.0 - mean)));
        OrenNayar { albedo, multiple, roughness }
    }
}

impl<V: Integrand> Brdf for OrenNayar<V> {
    type Value = V;

    #[inline]
    fn f(&self, wo: Direction, wi: Direction) -> V {
        let above = visible(wo, wi);
        if above == 0.0 {
            return V::ZERO;
        }
        let (o, i) = (wo.cos_theta(), wi.cos_theta());
        // sin sin cos(difference of the azimuths), divided by the larger cosine (tan beta) where it is
        // positive.
        let towards = wo.x() * wi.x() + wo.y() * wi.y();
        let steep = at_least(if o > i { o } else { i }, 1e-6);
        let shape = if towards > 0.0 { towards / steep } else { towards };
        let flat = 1.0 / (1.0 + GRAZING * self.roughness);
        let once = flat * (1.0 + self.roughness * shape);
        let again = flat * self.roughness * (lost(wo) * lost(wi) / (GRAZING - MEAN));
        self.albedo * (FRAC_1_PI * (above * once)) + self.multiple * (FRAC_1_PI * again)
    }
}

/// The share that one reflection loses with roughness towards a direction, 0..=0.2878: the model's 1 - E
/// without its factors.
fn lost(w: Direction) -> f32 {
    let (cosine, sine) = (w.cos_theta(), w.sin_theta());
    // The crate's own atan2, so that no feature is needed and none changes the number.
    let theta = Fast::atan2(sine, cosine);
    // (1 - sin^3) / cos, written without the division that would be 0 / 0 at the horizon.
    let cubes = cosine * (1.0 + sine + sine * sine) / (1.0 + sine);
    let gained = sine * (theta - sine * cosine) + 2.0 / 3.0 * (sine * cubes - sine);
    at_least(GRAZING - gained * FRAC_1_PI, 0.0)
}
