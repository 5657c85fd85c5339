//! Rough mirrors: facets of Trowbridge and Reitz's distribution (GGX).

use crate::geometry::{Direction, Integrand, gauss_legendre};
use crate::math::{at_least, at_most};
use crate::math::{cos_turns, sin_turns, sqrt};
use crate::matter::surface::brdf::{Brdf, visible};
use crate::matter::surface::reflector::Reflector;
use crate::matter::surface::scattering::Quadrature;
use core::f32::consts::FRAC_1_PI;

/// How the normals of a rough surface are distributed, after Trowbridge and Reitz (1975); also called GGX.
///
/// # Reference
/// B. Walter et al., "Microfacet models for refraction through rough surfaces", EGSR 2007; E. Heitz,
/// "Understanding the masking-shadowing function in microfacet-based BRDFs", JCGT 3 (2014).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrowbridgeReitz {
    alpha: f32,
}

/// Below this cosine, or 5.7e-5 degrees above the horizon, light counts as coming from there: what is divided
/// by a cosine stays finite.
const LOWEST_COSINE: f32 = 1e-6;

impl TrowbridgeReitz {
    /// `alpha` is the tangent of the typical slope, 1e-4 (a mirror) ..=1 (as rough as can be); what is
    /// outside counts as the nearer end.
    #[must_use]
    pub fn new(alpha: f32) -> Self {
        TrowbridgeReitz { alpha: at_most(at_least(alpha, 1e-4), 1.0) }
    }

    /// The roughness within 1e-4..=1.
    #[must_use]
    pub const fn alpha(self) -> f32 {
        self.alpha
    }

    /// Area of facets whose normal is `wm`, for each area of surface and each sr; 0 below the horizon.
    ///
    /// # Accuracy
    /// 8 units of 2^-24 relative, at every alpha.
    #[must_use]
    pub fn d(self, wm: Direction) -> f32 {
        if wm.cos_theta() <= 0.0 {
            return 0.0;
        }
        // The sine from x and y: from the cosine it is all rounding where a mirror's facets are.
        let (sine2, slope) = (wm.x() * wm.x() + wm.y() * wm.y(), self.alpha * wm.cos_theta());
        let part = self.alpha / (slope * slope + sine2);
        FRAC_1_PI * (part * part)
    }

    /// The share of facets turned to `w` that are seen from there, 0..=1; 0 below the horizon.
    #[must_use]
    pub fn g1(self, w: Direction) -> f32 {
        if w.cos_theta() <= 0.0 {
            return 0.0;
        }
        let cosine = at_least(w.cos_theta(), LOWEST_COSINE);
        2.0 * cosine / (cosine + self.projected(w))
    }

    /// Density of the normals that are seen from `w`, 1/sr: the integral over all of them is 1.
    #[must_use]
    pub fn visible_d(self, w: Direction, wm: Direction) -> f32 {
        let towards = w.dot(wm);
        if w.cos_theta() <= 0.0 || towards <= 0.0 {
            return 0.0;
        }
        let cosine = at_least(w.cos_theta(), LOWEST_COSINE);
        // G1 D (w wm) / cos, where the cosine cancels.
        2.0 * self.d(wm) * (towards / (cosine + self.projected(w)))
    }

    /// A normal seen from `w`: `share`, 0..=1, of the visible area lies nearer the rim, and `turns` goes
    /// around. Evenly spread numbers give normals distributed as [`visible_d`](Self::visible_d). A `w` below
    /// the horizon counts as on it.
    ///
    /// # Reference
    /// J. Dupuy, A. Benyoub, "Sampling visible GGX normals with spherical caps", Computer Graphics Forum 42
    /// (2023).
    #[must_use]
    pub fn visible_normal(self, w: Direction, share: f32, turns: f32) -> Direction {
        let cosine = at_least(w.cos_theta(), LOWEST_COSINE);
        // The surface stretched until its roughness is 1: there the reflected directions fill a cap evenly.
        let Some(seen) = Direction::from_vector([self.alpha * w.x(), self.alpha * w.y(), cosine]) else {
            return Direction::unit(f32::NAN, f32::NAN, f32::NAN);
        };
        let [x, y, z] = seen.to_array();
        // Their z goes from -z to 1; the height above that rim is what the normal has. sin^2 from its two
        // factors.
        let height = share * (1.0 + z);
        let sine = sqrt((1.0 - share) * (1.0 + z) * (1.0 - z + height));
        let normal =
            [self.alpha * (x + sine * cos_turns(turns)), self.alpha * (y + sine * sin_turns(turns)), height];
        Direction::from_vector(normal).unwrap_or(Direction::NORMAL)
    }

    /// sqrt(cos^2 + alpha^2 sin^2): the area of the stretched facets as seen from `w`.
    fn projected(self, w: Direction) -> f32 {
        let cosine = at_least(w.cos_theta(), LOWEST_COSINE);
        sqrt(cosine * cosine + self.alpha * self.alpha * (w.x() * w.x() + w.y() * w.y()))
    }

    /// G2 / (4 cos cos): masking and shadowing, where facets that are high are more likely to be seen and
    /// lit.
    fn visibility(self, wo: Direction, wi: Direction) -> f32 {
        let [o, i] = [wo, wi].map(|w| at_least(w.cos_theta(), LOWEST_COSINE));
        0.5 / (o * self.projected(wi) + i * self.projected(wo))
    }

    /// The BRDF of facets that reflect all, and the cosine at which they are met; 0 where there are none.
    #[inline]
    fn lobe(self, wo: Direction, wi: Direction) -> (f32, f32) {
        let above = visible(wo, wi);
        match wo.halfway(wi) {
            Some(wm) if above != 0.0 => {
                let shape = self.d(wm) * self.visibility(wo, wi);
                // The mean of two equal cosines: the same bits when the directions change places.
                (above * shape, 0.5 * (wo.dot(wm) + wi.dot(wm)))
            }
            _ => (0.0 * above, 1.0),
        }
    }

    /// G2 / G1(wo), the share of what is seen that is also lit: at most 1, also as rounded.
    fn lit(self, wo: Direction, wi: Direction) -> f32 {
        let [o, i] = [wo, wi].map(|w| at_least(w.cos_theta(), LOWEST_COSINE));
        let slope = self.alpha * wi.sin_theta();
        1.0 / (1.0 + o * (slope * slope) / ((self.projected(wi) + i) * (self.projected(wo) + o) * i))
    }
}

/// A surface of microfacets, each a smooth boundary: frosted metal, glazed clay, wet stone.
///
/// Counts light that is reflected once: at alpha = 1 and normal incidence even a perfect reflector returns
/// only 1 - ln 2 = 0.307 of it, at alpha = 0.1 99 %.
///
/// ```
/// # use nanospectra::matter::{Microfacet, TrowbridgeReitz, VisibleNormals, scattering::rho_hd};
/// # use nanospectra::geometry::Direction;
/// let rough = Microfacet { facets: TrowbridgeReitz::new(1.0), boundary: 1.0 };
/// let rho = rho_hd(&rough, Direction::NORMAL, &VisibleNormals::<16, 32>);
/// assert!((rho - 0.306_853).abs() < 2e-3);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Microfacet<F> {
    /// How the facets lie.
    pub facets: TrowbridgeReitz,
    /// What each of them reflects.
    pub boundary: F,
}

impl<F: Reflector> Brdf for Microfacet<F> {
    type Value = F::Value;

    #[inline]
    fn f(&self, wo: Direction, wi: Direction) -> F::Value {
        let (shape, cos_i) = self.facets.lobe(wo, wi);
        if shape == 0.0 {
            return F::Value::ZERO;
        }
        self.boundary.reflectance(cos_i) * shape
    }
}

/// The rule for [`Microfacet`]: `RIM` rings of `PHI` normals each, where those seen from a direction are.
///
/// The light comes from where these facets mirror it, at every roughness; each stands for an equal share in
/// azimuth and Gauss's in the other variable. What falls below the horizon is lost, as in the model.
///
/// # Accuracy
/// Of the reflectance, relative, worst over alpha 1e-4..=1 and all directions: 1.7e-2 with 12 x 12 nodes,
/// 8.2e-3 with 16 x 16, 2.3e-3 with 32 x 32; never above 1 for a perfect reflector
/// (`tests/matter/hard_cases_surfaces.rs`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct VisibleNormals<const RIM: usize, const PHI: usize>;

impl<const RIM: usize, const PHI: usize> VisibleNormals<RIM, PHI> {
    const RINGS: [(f32, f32); RIM] = gauss_legendre::nodes_and_weights();

    /// The normals of `facets` seen from `w`, and the share of each; all shares add up to 1.
    pub fn normals(self, facets: TrowbridgeReitz, w: Direction) -> impl Iterator<Item = (Direction, f32)> {
        let each = 1.0 / PHI as f32;
        const { &Self::RINGS }.iter().flat_map(move |(place, share)| {
            let normal = move |k| facets.visible_normal(w, *place, (k as f32 + 0.5) * each);
            (0..PHI).map(move |k| (normal(k), share * each))
        })
    }

    fn for_each<F: Reflector>(
        self,
        brdf: &Microfacet<F>,
        from: Direction,
        mut visit: impl FnMut(Direction, F::Value),
    ) {
        if from.cos_theta() <= 0.0 {
            return;
        }
        for (wm, share) in self.normals(brdf.facets, from) {
            let to = from.reflected(wm);
            if to.cos_theta() <= 0.0 {
                continue;
            }
            let lit = share * brdf.facets.lit(from, to);
            visit(to, brdf.boundary.reflectance(from.dot(wm)) * lit);
        }
    }
}

impl<F: Reflector, const RIM: usize, const PHI: usize> Quadrature<Microfacet<F>>
    for VisibleNormals<RIM, PHI>
{
    fn arriving(&self, brdf: &Microfacet<F>, wo: Direction, visit: impl FnMut(Direction, F::Value)) {
        self.for_each(brdf, wo, visit);
    }

    fn leaving(&self, brdf: &Microfacet<F>, wi: Direction, visit: impl FnMut(Direction, F::Value)) {
        self.for_each(brdf, wi, visit);
    }
}
