//! The classical dipole, which computes the reflectance of matter such as skin, milk or marble from how it
//! absorbs and scatters.

use crate::grid::{Bands, Bins};
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::math::{Math, sqrt};
use crate::matter::volume::diffuse_fresnel::{
    external_reflectance, fresnel, internal_reflectance, internal_reflectance_fit, is_denser,
};
use crate::spectrum::{Factor, Reflectance, Spectrum};
use core::f32::consts::PI;

/// The classical dipole model of a translucent material, whose absorption and scattering coefficients are
/// known.
///
/// Make it by [`new`](Self::new); [`reflectance`](Self::reflectance) is the color of a large area of it, and
/// [`profile`](Self::profile) tells how far from where it entered light leaves. The model is a half-space
/// behind a smooth surface, in which light diffuses. Coefficients are in 1/m (or all in 1 over another unit
/// of length).
///
/// # Reference
/// Jensen, Marschner, Levoy and Hanrahan 2001, "A practical model for subsurface light transport".
///
/// # Example
///
/// ```
/// # #[cfg(feature = "libm")] {
/// use nanospectra::matter::Dipole;
/// // Whole milk in red light (Jensen's table, in 1/mm) reflects 0.91.
/// let milk = Dipole::<16>::new([0.0011; 16], [2.55; 16], 1.3);
/// assert!((milk.reflectance().values()[0] - 0.91).abs() < 0.01);
/// // By the fit of the paper it is the same within 0.01.
/// let by_fit = Dipole::<16>::new_by_fit([0.0011; 16], [2.55; 16], 1.3);
/// assert!((by_fit.reflectance().values()[0] - milk.reflectance().values()[0]).abs() < 0.01);
/// // More light leaves at 1 mm from where it entered than at 2 mm.
/// assert!(milk.profile(1.0).values()[0] > milk.profile(2.0).values()[0]);
/// # }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Dipole<const N: usize, G = Bins<380, 730>> {
    absorption: [f32; N],
    scattering: [f32; N],
    eta: f32,
    /// (1 + Fdr) / (1 - Fdr), which tells how far outside the surface the fluence would be zero.
    mismatch: f32,
    grid: core::marker::PhantomData<G>,
}

impl<const N: usize, G: Bands> Dipole<N, G> {
    /// Makes a dipole from the absorption and the reduced scattering coefficient of each bin and the
    /// refractive index.
    ///
    /// Both coefficients are 0..=1e18; otherwise the bin is NaN. `eta` is the index of the volume relative to
    /// the outside, 1..=3; otherwise all bins are NaN. The reflectance of the surface from inside is the
    /// exact [`internal_reflectance`]. See the [example](#example).
    #[must_use]
    pub fn new(absorption: [f32; N], reduced_scattering: [f32; N], eta: f32) -> Self {
        Self::with(absorption, reduced_scattering, eta, internal_reflectance(eta))
    }

    /// Makes a dipole as [`new`](Self::new) does, but with the fit that the paper and most programs use,
    /// [`internal_reflectance_fit`]. See the [example](#example).
    #[must_use]
    pub fn new_by_fit(absorption: [f32; N], reduced_scattering: [f32; N], eta: f32) -> Self {
        Self::with(absorption, reduced_scattering, eta, internal_reflectance_fit(eta))
    }

    fn with(absorption: [f32; N], scattering: [f32; N], eta: f32, inside: f32) -> Self {
        let mismatch = if is_denser(eta) { (1.0 + inside) / (1.0 - inside) } else { f32::NAN };
        Dipole { absorption, scattering, eta, mismatch, grid: core::marker::PhantomData }
    }

    /// Computes the share of the light that entered which leaves again anywhere, 0..=1.
    ///
    /// This is the integral of the profile. It is 0 where nothing scatters. See the [example](#example).
    ///
    /// # Accuracy
    /// 5e-7 absolute from an `eta` of 1.2 on, and 2.5e-5 below, compared with the closed form in f64. Nearly
    /// all of it is the error of the reflectance from inside, [`internal_reflectance`].
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn reflectance(&self) -> Reflectance<N, G> {
        self.reflectance_with::<Portable>()
    }

    /// Computes the same as [`reflectance`](Self::reflectance), on the math backend `M`.
    #[must_use]
    pub fn reflectance_with<M: Math>(&self) -> Reflectance<N, G> {
        self.each(|albedo, decay, _| {
            0.5 * albedo * (1.0 + M::exp(-4.0 / 3.0 * self.mismatch * decay)) * M::exp(-decay)
        })
    }

    /// Computes the profile R(r) at the distance `r` from where light entered, in 1/m2.
    ///
    /// `r` is 0 or more; otherwise the result is NaN. See the [example](#example).
    ///
    /// # Accuracy
    /// (5 sigma_tr r + 20) units of 2^-24, relative, for the [`internal_reflectance`] as it is, and where the
    /// profile is above 1e-37 of the square of sigma_t', the sum of both coefficients. Farther out it fades
    /// to 0.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn profile(&self, r: f32) -> Spectrum<Factor, N, G> {
        self.profile_with::<Portable>(r)
    }

    /// Computes the same as [`profile`](Self::profile), on the math backend `M`.
    #[must_use]
    pub fn profile_with<M: Math>(&self, r: f32) -> Spectrum<Factor, N, G> {
        if r < 0.0 || r.is_nan() {
            return Spectrum::from_bins([f32::NAN; N]);
        }
        self.each(|albedo, decay, extinction| {
            // In units of the mean free path, the sources lie 1 below the surface and 1 + 4A/3 above it.
            let across = r * extinction;
            if across > 1e12 {
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

    /// Computes the reflectance of a large area that is lit evenly from all sides and seen at an angle,
    /// without the light that the surface itself reflects.
    ///
    /// `cos_theta` is the cosine of the angle between the normal and the direction of view. By reciprocity
    /// the reflectance, 0..=1, is also that of an area lit from this direction and seen from all.
    ///
    /// Where nothing is absorbed, this and the light reflected at the surface add up to less than 1: 5.7 %
    /// are lost at an `eta` of 1.3. The reason is that Jensen's model applies Fresnel's share on the way out
    /// twice, because R(r) contains it already. Divide by its mean, 1 - [`external_reflectance`], to account
    /// for all light.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn hemispherical_directional(&self, cos_theta: f32) -> Reflectance<N, G> {
        self.hemispherical_directional_with::<Portable>(cos_theta)
    }

    /// Computes the same as [`hemispherical_directional`](Self::hemispherical_directional), on the math
    /// backend `M`.
    #[must_use]
    pub fn hemispherical_directional_with<M: Math>(&self, cos_theta: f32) -> Reflectance<N, G> {
        let through = (1.0 - fresnel(self.eta, cos_theta)) * (1.0 - external_reflectance(self.eta));
        self.reflectance_with::<M>() * through
    }

    /// A value for each bin from the albedo of one scattering event, sigma_tr / sigma_t' and sigma_t'.
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
