//! Rough reflecting surfaces, made of facets with Trowbridge and Reitz's distribution (GGX).

use crate::geometry::{Direction, Integrand, gauss_legendre};
use crate::math::{at_least, at_most};
use crate::math::{cos_turns, sin_turns, sqrt};
use crate::matter::surface::brdf::{Brdf, visible};
use crate::matter::surface::reflector::Reflector;
use crate::matter::surface::scattering::Quadrature;
use core::f32::consts::FRAC_1_PI;

/// The distribution of the normals of a rough surface after Trowbridge and Reitz (1975), which is also called
/// GGX.
///
/// Make it from a roughness by [`new`](Self::new) and give it to a [`Microfacet`] surface. A renderer that
/// samples the surface draws a facet's normal by [`visible_normal`](Self::visible_normal), whose density is
/// [`visible_d`](Self::visible_d).
///
/// # Example
///
/// ```
/// use nanospectra::geometry::{Direction, GaussLegendre, Hemisphere};
/// use nanospectra::matter::TrowbridgeReitz;
/// let facets = TrowbridgeReitz::new(0.5);
/// assert_eq!(facets.alpha(), 0.5);
/// // D(n) = 1 / (pi alpha^2) at the normal itself.
/// assert!((facets.d(Direction::NORMAL) - 1.273_24).abs() < 1e-5);
/// // Seen from straight above, no facet hides another.
/// assert_eq!(facets.g1(Direction::NORMAL), 1.0);
/// // The facets project onto the whole of the surface: the integral of D times the cosine is 1.
/// let area = GaussLegendre::<32, 1>.integrate_projected(|wm| facets.d(wm));
/// assert!((area - 1.0).abs() < 1e-4);
/// // A ray that comes from `wo` meets a facet that is turned towards it; the facet reflects it to `wi`.
/// let wo = Direction::spherical(0.8, 0.0);
/// let wm = facets.visible_normal(wo, 0.3, 0.6); // two random numbers, 0..1
/// let wi = wo.reflected(wm);
/// assert!(wo.dot(wm) > 0.0 && (wi.dot(wm) - wo.dot(wm)).abs() < 1e-6);
/// // The density of `wi` per sr.
/// let pdf = facets.visible_d(wo, wm) / (4.0 * wo.dot(wm));
/// assert!(pdf > 0.0);
/// ```
///
/// # Reference
/// B. Walter et al., "Microfacet models for refraction through rough surfaces", EGSR 2007; E. Heitz,
/// "Understanding the masking-shadowing function in microfacet-based BRDFs", JCGT 3 (2014).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrowbridgeReitz {
    alpha: f32,
}

/// A smaller cosine counts as this one, which is 5.7e-5 degrees above the horizon, so that quotients by a
/// cosine stay finite.
const LOWEST_COSINE: f32 = 1e-6;

impl TrowbridgeReitz {
    /// Makes a distribution from its roughness `alpha`, the tangent of the typical slope of a facet.
    ///
    /// `alpha` is from 1e-4 (a mirror) to 1 (the roughest surface); outside this range it counts as the
    /// nearer end. See the [example](#example).
    #[must_use]
    pub fn new(alpha: f32) -> Self {
        TrowbridgeReitz { alpha: at_most(at_least(alpha, 1e-4), 1.0) }
    }

    /// Returns the roughness, which is in 1e-4..=1. See the [example](#example).
    #[must_use]
    pub const fn alpha(self) -> f32 {
        self.alpha
    }

    /// Computes the area of the facets whose normal is `wm`, for each unit of surface area and each sr.
    ///
    /// It is 0 below the horizon. See the [example](#example).
    ///
    /// # Accuracy
    /// 11 units of 2^-24 relative, at every alpha.
    #[must_use]
    pub fn d(self, wm: Direction) -> f32 {
        if wm.cos_theta() <= 0.0 {
            return 0.0;
        }
        // The sine comes from x and y. From the cosine it would be rounding error for the facets of a mirror.
        let (sine2, slope) = (wm.x() * wm.x() + wm.y() * wm.y(), self.alpha * wm.cos_theta());
        let part = self.alpha / (slope * slope + sine2);
        FRAC_1_PI * (part * part)
    }

    /// Computes the share of the facets turned to `w` that are visible from there, 0..=1 (Smith's masking
    /// function).
    ///
    /// It is 0 below the horizon. See the [example](#example).
    #[must_use]
    pub fn g1(self, w: Direction) -> f32 {
        if w.cos_theta() <= 0.0 {
            return 0.0;
        }
        let cosine = at_least(w.cos_theta(), LOWEST_COSINE);
        2.0 * cosine / (cosine + self.projected(w))
    }

    /// Computes the probability density of a normal `wm` among those that are visible from `w`, in 1/sr.
    ///
    /// Its integral over all normals is 1. Divide it by `4.0 * w.dot(wm)` for the density of the direction in
    /// which the facet reflects. See the [example](#example).
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

    /// Draws a normal that is visible from `w`, by two numbers that are uniform in 0..=1.
    ///
    /// The normals are distributed with the density [`visible_d`](Self::visible_d). `share` is the share of
    /// the visible area that lies closer to the rim, and `turns` the place around it. A `w` below the horizon
    /// counts as on the horizon. See the [example](#example).
    ///
    /// # Reference
    /// J. Dupuy, A. Benyoub, "Sampling visible GGX normals with spherical caps", Computer Graphics Forum 42
    /// (2023).
    #[must_use]
    pub fn visible_normal(self, w: Direction, share: f32, turns: f32) -> Direction {
        let cosine = at_least(w.cos_theta(), LOWEST_COSINE);
        // The surface is stretched until its roughness is 1. There the reflected directions fill a cap
        // evenly.
        let Some(seen) = Direction::from_vector([self.alpha * w.x(), self.alpha * w.y(), cosine]) else {
            return Direction::unit(f32::NAN, f32::NAN, f32::NAN);
        };
        let [x, y, z] = seen.to_array();
        // Their z goes from -z to 1, and the z of the normal is the height above that rim. sin^2 is computed
        // from its two factors.
        let height = share * (1.0 + z);
        let sine = sqrt((1.0 - share) * (1.0 + z) * (1.0 - z + height));
        let normal =
            [self.alpha * (x + sine * cos_turns(turns)), self.alpha * (y + sine * sin_turns(turns)), height];
        // Facets without any height or width all face up, but NaN is no direction.
        let none = normal.iter().any(|part| part.is_nan());
        let otherwise = if none { Direction::unit(f32::NAN, f32::NAN, f32::NAN) } else { Direction::NORMAL };
        Direction::from_vector(normal).unwrap_or(otherwise)
    }

    /// The area of the stretched facets as seen from `w`, sqrt(cos^2 + alpha^2 sin^2).
    fn projected(self, w: Direction) -> f32 {
        let cosine = at_least(w.cos_theta(), LOWEST_COSINE);
        sqrt(cosine * cosine + self.alpha * self.alpha * (w.x() * w.x() + w.y() * w.y()))
    }

    /// Masking and shadowing, G2 / (4 cos cos), where facets that lie high are more likely to be both visible
    /// and lit.
    fn visibility(self, wo: Direction, wi: Direction) -> f32 {
        let [o, i] = [wo, wi].map(|w| at_least(w.cos_theta(), LOWEST_COSINE));
        0.5 / (o * self.projected(wi) + i * self.projected(wo))
    }

    /// The BRDF of facets that reflect all light, 0 where there are none, and the cosine of incidence on
    /// them.
    #[inline]
    fn lobe(self, wo: Direction, wi: Direction) -> (f32, f32) {
        let above = visible(wo, wi);
        match wo.halfway(wi) {
            Some(wm) if above != 0.0 => {
                let shape = self.d(wm) * self.visibility(wo, wi);
                // The mean of two equal cosines has the same bits when the directions change places.
                (above * shape, 0.5 * (wo.dot(wm) + wi.dot(wm)))
            }
            _ => (0.0 * above, 1.0),
        }
    }

    /// The share of the visible facets that are also lit, G2 / G1(wo): at most 1, even when rounded.
    fn lit(self, wo: Direction, wi: Direction) -> f32 {
        let [o, i] = [wo, wi].map(|w| at_least(w.cos_theta(), LOWEST_COSINE));
        let slope = self.alpha * wi.sin_theta();
        1.0 / (1.0 + o * (slope * slope) / ((self.projected(wi) + i) * (self.projected(wo) + o) * i))
    }
}

/// A rough surface made of microfacets that are smooth boundaries, such as frosted metal, glazed clay or wet
/// stone.
///
/// Fill in both fields and evaluate it as a [`Brdf`]. Only light that is reflected once is counted. At alpha
/// = 1 and normal incidence even a perfect reflector therefore returns only 1 - ln 2 = 0.307 of the light,
/// and at alpha = 0.1 it returns 99 %.
///
/// # Example
///
/// ```
/// use nanospectra::geometry::Direction;
/// use nanospectra::matter::{Brdf, Conductor, Microfacet, TrowbridgeReitz};
/// use nanospectra::matter::{VisibleNormals, scattering::rho_hd};
/// // Rough copper in green, seen and lit from straight above, has F D / 4, where F is 0.5884 and D is
/// // 1 / (pi 0.3^2).
/// let copper = Microfacet { facets: TrowbridgeReitz::new(0.3), boundary: Conductor::new(1.15, 2.56) };
/// let f = copper.f(Direction::NORMAL, Direction::NORMAL);
/// assert!((f - 0.5203).abs() < 1e-4);
/// // The share that a perfect reflector of the greatest roughness returns: 1 - ln 2.
/// let rough = Microfacet { facets: TrowbridgeReitz::new(1.0), boundary: 1.0 };
/// let rho = rho_hd(&rough, Direction::NORMAL, &VisibleNormals::<16, 32>);
/// assert!((rho - 0.306_853).abs() < 2e-3);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Microfacet<F> {
    /// The distribution that the normals of the facets follow. See the [example](#example).
    pub facets: TrowbridgeReitz,
    /// The smooth boundary that each facet is, which is any [`Reflector`]. See the [example](#example).
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

/// The quadrature rule for [`Microfacet`] surfaces, which takes `RIM` rings of `PHI` normals each among those
/// that are visible.
///
/// The nodes are the directions in which these facets reflect, so the rule works at every roughness. Each
/// normal stands for an equal share in azimuth, and for Gauss's weight in the other variable. Light that a
/// facet reflects below the horizon is lost, as the model has it. See the [example](Microfacet#example).
///
/// # Accuracy
/// Of the reflectance, relative, worst over alpha 1e-4..=1 and all directions: 1.9e-2 with 12 x 12 nodes,
/// 1.2e-2 with 16 x 16, and 4.3e-3 with 32 x 32. It is worst at normal incidence, where a whole ring of nodes
/// falls below the horizon at once. The reflectance of a perfect reflector never exceeds 1
/// (`tests/matter/hard_cases_surfaces.rs`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct VisibleNormals<const RIM: usize, const PHI: usize>;

impl<const RIM: usize, const PHI: usize> VisibleNormals<RIM, PHI> {
    const RINGS: [(f32, f32); RIM] = gauss_legendre::nodes_and_weights();

    /// Returns normals of `facets` that are visible from `w`, each with the share that it stands for.
    ///
    /// All shares add up to 1.
    ///
    /// # Example
    ///
    /// ```
    /// use nanospectra::geometry::Direction;
    /// use nanospectra::matter::{TrowbridgeReitz, VisibleNormals};
    /// let normals = VisibleNormals::<4, 8>.normals(TrowbridgeReitz::new(0.3), Direction::NORMAL);
    /// let (count, shares) = normals.fold((0, 0.0), |(n, sum), (_, share)| (n + 1, sum + share));
    /// assert!(count == 32 && (shares - 1.0f32).abs() < 1e-6);
    /// ```
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
