//! Light that enters skin, milk or marble at one point and leaves at another: the reflectance profiles of
//! Burley and of the classical dipole.

use crate::grid::{Bands, Bins};
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::math::{Math, sqrt};
use crate::matter::volume::diffuse_fresnel::{
    external_reflectance, fresnel, internal_reflectance, internal_reflectance_fit, is_denser,
};
use crate::spectrum::{Factor, Reflectance, Spectrum};
use core::f32::consts::PI;

/// How light falls on the surface, and which mean free path is known: the three fits of Christensen and
/// Burley 2015.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum BurleyFit {
    /// A narrow beam at right angles; the volume mean free path.
    Beam,
    /// Light from all sides, refracted; the volume mean free path.
    Diffuse,
    /// The diffuse mean free path, which is measured on the surface.
    DiffusePath,
}

impl BurleyFit {
    /// What a mean free path is divided by to get Burley's d, for a surface albedo of 0..=1.
    ///
    /// # Reference
    /// Christensen and Burley 2015, "Approximate reflectance profiles for efficient subsurface scattering",
    /// eqs. 5, 6 and 8.
    #[must_use]
    pub const fn scaling(self, albedo: f32) -> f32 {
        let (x, y) = (albedo - 0.8, albedo - 0.33);
        match self {
            Self::Beam => 1.85 - albedo + 7.0 * (x * x * x).abs(),
            Self::Diffuse => 1.9 - albedo + 3.5 * (x * x),
            Self::DiffusePath => 3.5 + 100.0 * ((y * y) * (y * y)),
        }
    }
}

/// Burley's normalized diffusion: R(r) = A (exp(-r/d) + exp(-r/3d)) / (8 pi d r), with an albedo A, which is
/// its integral over the surface, and a distance d for each bin. Where d is 0, light leaves where it entered:
/// Lambert.
///
/// Lengths are in m (or in any one unit).
///
/// ```
/// # #[cfg(feature = "libm")] {
/// use nanospectra::Reflectance;
/// use nanospectra::matter::Burley;
/// let skin = Burley::<16>::new(Reflectance::flat(0.6), [1e-3; 16]);
/// // Within a distance of 3 d: A (1 - exp(-3) / 4 - 3 exp(-1) / 4).
/// assert!((skin.within(3e-3).values()[0] - 0.6 * 0.711_64).abs() < 1e-5);
/// # }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Burley<const N: usize, G = Bins<380, 730>> {
    albedo: Reflectance<N, G>,
    distance: [f32; N],
}

impl<const N: usize, G: Bands> Burley<N, G> {
    /// A profile from the albedo, 0..=1, and the distance d >= 0 of each bin, in m.
    #[must_use]
    pub const fn new(albedo: Reflectance<N, G>, distance: [f32; N]) -> Self {
        Burley { albedo, distance }
    }

    /// From the albedo and the mean free path >= 0 of each bin.
    #[must_use]
    pub fn from_mean_free_path(albedo: Reflectance<N, G>, path: [f32; N], by: BurleyFit) -> Self {
        let mut distance = path;
        for (d, albedo) in distance.iter_mut().zip(albedo.values()) {
            *d /= by.scaling(*albedo);
        }
        Burley { albedo, distance }
    }

    /// The distance d of each bin.
    #[must_use]
    pub const fn distance(&self) -> &[f32; N] {
        &self.distance
    }

    /// All that leaves: the albedo.
    #[must_use]
    pub const fn reflectance(&self) -> Reflectance<N, G> {
        self.albedo
    }

    /// r R(r), in 1/m, at `r` >= 0 (else NaN) from where light entered; 2 pi times this leaves from a ring,
    /// for each meter of its width. A bin with d = 0 gives 0 beyond r = 0, and infinity there (0 if nothing
    /// leaves).
    ///
    /// # Accuracy
    /// (r / d + 4) units of 2^-24, relative.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn times_radius(&self, r: f32) -> Spectrum<Factor, N, G> {
        self.times_radius_with::<Portable>(r)
    }

    /// [`times_radius`](Self::times_radius) on another math backend.
    #[must_use]
    pub fn times_radius_with<M: Math>(&self, r: f32) -> Spectrum<Factor, N, G> {
        self.each(r, |albedo, d| {
            if d == 0.0 && (r > 0.0 || albedo == 0.0) {
                return albedo * 0.0;
            }
            let x = if r == 0.0 { 0.0 } else { r / d };
            albedo * (M::exp(-x) + M::exp(-x / 3.0)) / (8.0 * PI * d)
        })
    }

    /// What leaves within `r` >= 0 (else NaN) of where light entered: the integral of the profile over that
    /// disk, 0..=albedo. A bin with d = 0 gives its albedo at any `r`.
    ///
    /// # Accuracy
    /// 4 units of 2^-24, relative.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn within(&self, r: f32) -> Spectrum<Factor, N, G> {
        self.within_with::<Portable>(r)
    }

    /// [`within`](Self::within) on another math backend.
    #[must_use]
    pub fn within_with<M: Math>(&self, r: f32) -> Spectrum<Factor, N, G> {
        self.each(r, |albedo, d| {
            let x = if d == 0.0 { f32::INFINITY } else { r / d };
            albedo * (-0.25 * M::expm1(-x) - 0.75 * M::expm1(-x / 3.0))
        })
    }

    fn each(&self, r: f32, value: impl Fn(f32, f32) -> f32) -> Spectrum<Factor, N, G> {
        let mut values = *self.albedo.values();
        for (v, d) in values.iter_mut().zip(&self.distance) {
            *v = if r >= 0.0 && *d >= 0.0 { value(*v, *d) } else { f32::NAN };
        }
        Spectrum::from_bins(values)
    }
}

/// The distance, in units of Burley's d, within which the `share` (0..=1, else NaN) of what leaves does, for
/// placing samples: the inverse of 1 - exp(-x)/4 - 3 exp(-x/3)/4.
///
/// # Accuracy
/// 4e-7, relative, of the share as rounded.
#[cfg(feature = "libm")]
#[must_use]
pub fn burley_distance(share: f32) -> f32 {
    burley_distance_with::<Portable>(share)
}

/// [`burley_distance`] on another math backend.
#[must_use]
pub fn burley_distance_with<M: Math>(share: f32) -> f32 {
    if !(0.0..=1.0).contains(&share) {
        return f32::NAN;
    }
    if share > 0.5 {
        // With e = e^(-x/3): e^3 + 3 e = 4 (1 - share), exactly. Convex: Newton's steps from above stay
        // above.
        let rest = 4.0 * (1.0 - share);
        let mut e = rest / 3.0;
        for _ in 0..4 {
            e -= (e * (e * e + 3.0) - rest) / (3.0 * (e * e + 1.0));
        }
        return if e > 0.0 { -3.0 * M::ln(e) } else { f32::INFINITY };
    }
    // With e^(-x/3) = 1 - y: y^3 - 3 y^2 + 6 y = 4 share. Rising and concave: Newton's steps from below stay
    // below.
    let mut y = share * (2.0 / 3.0);
    for _ in 0..6 {
        let excess = y * (6.0 - y * (3.0 - y)) - 4.0 * share;
        y -= excess / (6.0 - y * (6.0 - 3.0 * y));
    }
    let rest = 1.0 - y;
    if rest == 1.0 {
        return 3.0 * y;
    }
    // ln(1 - y) where 1 - y has lost digits of y: what was rounded cancels.
    3.0 * M::ln(rest) * (y / (rest - 1.0))
}

/// The classical dipole: a diffusing half-space of known absorption and scattering, in 1/m (or 1 over any one
/// unit of length), behind a smooth surface.
///
/// # Reference
/// Jensen, Marschner, Levoy and Hanrahan 2001, "A practical model for subsurface light transport".
///
/// ```
/// # #[cfg(feature = "libm")] {
/// use nanospectra::matter::Dipole;
/// // Whole milk in red light (Jensen's table, 1/mm): it reflects 0.91.
/// let milk = Dipole::<16>::new([0.0011; 16], [2.55; 16], 1.3);
/// assert!((milk.reflectance().values()[0] - 0.91).abs() < 0.01);
/// # }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Dipole<const N: usize, G = Bins<380, 730>> {
    absorption: [f32; N],
    scattering: [f32; N],
    eta: f32,
    /// (1 + Fdr) / (1 - Fdr): how far outside the surface the fluence would be zero.
    mismatch: f32,
    grid: core::marker::PhantomData<G>,
}

impl<const N: usize, G: Bands> Dipole<N, G> {
    /// From the absorption and the reduced scattering coefficient of each bin, both 0..=1e18 (else NaN), and
    /// the index of refraction `eta` of the volume over that outside, 1..=3 (else all is NaN), by
    /// [`internal_reflectance`].
    #[must_use]
    pub fn new(absorption: [f32; N], reduced_scattering: [f32; N], eta: f32) -> Self {
        Self::with(absorption, reduced_scattering, eta, internal_reflectance(eta))
    }

    /// As [`new`](Self::new), by the fit of the paper and most programs, [`internal_reflectance_fit`].
    #[must_use]
    pub fn new_by_fit(absorption: [f32; N], reduced_scattering: [f32; N], eta: f32) -> Self {
        Self::with(absorption, reduced_scattering, eta, internal_reflectance_fit(eta))
    }

    fn with(absorption: [f32; N], scattering: [f32; N], eta: f32, inside: f32) -> Self {
        let mismatch = if is_denser(eta) { (1.0 + inside) / (1.0 - inside) } else { f32::NAN };
        Dipole { absorption, scattering, eta, mismatch, grid: core::marker::PhantomData }
    }

    /// All that leaves of the light that entered: the integral of the profile, 0..=1. 0 where nothing
    /// scatters.
    ///
    /// # Accuracy
    /// 1e-7 absolute beside the closed form in f64.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn reflectance(&self) -> Reflectance<N, G> {
        self.reflectance_with::<Portable>()
    }

    /// [`reflectance`](Self::reflectance) on another math backend.
    #[must_use]
    pub fn reflectance_with<M: Math>(&self) -> Reflectance<N, G> {
        self.each(|albedo, decay, _| {
            0.5 * albedo * (1.0 + M::exp(-4.0 / 3.0 * self.mismatch * decay)) * M::exp(-decay)
        })
    }

    /// R(r), in 1/m2, at `r` >= 0 (else NaN) from where light entered.
    ///
    /// # Accuracy
    /// (2 sigma_tr r + 20) units of 2^-24, relative.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn profile(&self, r: f32) -> Spectrum<Factor, N, G> {
        self.profile_with::<Portable>(r)
    }

    /// [`profile`](Self::profile) on another math backend.
    #[must_use]
    pub fn profile_with<M: Math>(&self, r: f32) -> Spectrum<Factor, N, G> {
        self.each(|albedo, decay, extinction| {
            // In units of the mean free path: the sources lie at 1 below and 1 + 4A/3 above.
            let across = r * extinction;
            if r < 0.0 {
                return f32::NAN;
            } else if across > 1e12 {
                return albedo * 0.0;
            }
            let source = |depth: f32| {
                let distance = sqrt(across * across + depth * depth);
                let path = decay * distance;
                depth * (1.0 + path) * M::exp(-path) / (distance * distance * distance)
            };
            let both = source(1.0) + source(1.0 + 4.0 / 3.0 * self.mismatch);
            albedo / (4.0 * PI) * both * extinction * extinction
        })
    }

    /// The reflectance, 0..=1 and without the gloss, of a large area lit evenly from all sides and seen from
    /// `cos_theta`, or the other way round.
    ///
    /// Where nothing is absorbed, this and the gloss are together less than 1: 5.7 % are lost at `eta` 1.3.
    /// The reason is that Jensen's model takes Fresnel's share on the way out, which R(r) contains, once
    /// more. Divided by the mean of that, 1 - [`external_reflectance`], all light is accounted for.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn hemispherical_directional(&self, cos_theta: f32) -> Reflectance<N, G> {
        self.hemispherical_directional_with::<Portable>(cos_theta)
    }

    /// [`hemispherical_directional`](Self::hemispherical_directional) on another math backend.
    #[must_use]
    pub fn hemispherical_directional_with<M: Math>(&self, cos_theta: f32) -> Reflectance<N, G> {
        let through = (1.0 - fresnel(self.eta, cos_theta)) * (1.0 - external_reflectance(self.eta));
        self.reflectance_with::<M>() * through
    }

    /// A value for each bin from the albedo of a scattering, sigma_tr / sigma_t' and sigma_t'.
    fn each(&self, value: impl Fn(f32, f32, f32) -> f32) -> Spectrum<Factor, N, G> {
        let mut values = self.absorption;
        for (v, scattering) in values.iter_mut().zip(&self.scattering) {
            let absorption = *v;
            let extinction = absorption + scattering;
            let known = [absorption, *scattering].iter().all(|c| (0.0..=1e18).contains(c));
            *v = if !known || self.mismatch.is_nan() {
                f32::NAN
            } else if *scattering == 0.0 {
                0.0
            } else {
                value(scattering / extinction, sqrt(3.0 * (absorption / extinction)), extinction)
            };
        }
        Spectrum::from_bins(values)
    }
}
