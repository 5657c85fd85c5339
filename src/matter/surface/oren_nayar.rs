//! Rough matt surfaces.

use crate::geometry::{Direction, Integrand};
use crate::math::{Fast, Math};
use crate::math::{at_least, at_most};
use crate::matter::surface::brdf::{Brdf, visible};
use core::f32::consts::FRAC_1_PI;

/// A rough matt surface, of V-shaped grooves: plaster, clay, the moon. Brighter towards the light than
/// [`Lambert`](crate::matter::Lambert), flatter at the edge.
///
/// Oren and Nayar's model in the form that keeps energy and reciprocity: what a groove's first reflection
/// loses, the further ones return. At roughness 0 it is [`Lambert`](crate::matter::Lambert), bit by bit.
///
/// # Accuracy
/// 1e-7 absolute and 1e-7 relative, of the formulas. The white one (albedo 1) reflects 1 within what a rule
/// can integrate.
///
/// # Reference
/// J. Portsmouth, P. Kutz, S. Hill, "EON: a practical energy-preserving rough diffuse BRDF", J. Computer
/// Graphics Techniques 14 (2025), after Oren and Nayar (1994) and Fujii.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrenNayar<V> {
    albedo: V,
    /// The albedo of what is reflected more than once.
    multiple: V,
    roughness: f32,
}

/// 1/2 - 2 / (3 pi): the share that one reflection loses with roughness at grazing incidence.
const GRAZING: f32 = 0.287_793_4;
/// 2/3 - 28 / (15 pi): the same in the mean of all directions.
const MEAN: f32 = 0.072_488_21;

impl<V: Integrand> OrenNayar<V> {
    /// `albedo` is the reflectance of a groove's sides, 0..=1, and `roughness` from 0 (flat) to 1; what is
    /// outside counts as the nearer end.
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
        // sin sin cos of the azimuths' difference; over the larger cosine (tan beta) where it is positive.
        let towards = wo.x() * wi.x() + wo.y() * wi.y();
        let steep = at_least(if o > i { o } else { i }, 1e-6);
        let shape = if towards > 0.0 { towards / steep } else { towards };
        let flat = 1.0 / (1.0 + GRAZING * self.roughness);
        let once = flat * (1.0 + self.roughness * shape);
        let again = flat * self.roughness * (lost(wo) * lost(wi) / (GRAZING - MEAN));
        self.albedo * (FRAC_1_PI * (above * once)) + self.multiple * (FRAC_1_PI * again)
    }
}

/// What one reflection loses with roughness towards a direction, 0..=0.2878: the model's 1 - E without its
/// factors.
fn lost(w: Direction) -> f32 {
    let (cosine, sine) = (w.cos_theta(), w.sin_theta());
    // The own kernel, so that no feature is needed, and none changes the number.
    let theta = Fast::atan2(sine, cosine);
    // (1 - sin^3) / cos without the division, which at the horizon would be 0 / 0.
    let cubes = cosine * (1.0 + sine + sine * sine) / (1.0 + sine);
    let gained = sine * (theta - sine * cosine) + 2.0 / 3.0 * (sine * cubes - sine);
    at_least(GRAZING - gained * FRAC_1_PI, 0.0)
}
