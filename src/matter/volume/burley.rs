//! Burley's reflectance profile of matter such as skin, milk or marble, where light enters at one point and
//! leaves at another.

use crate::grid::{Bands, Bins};
use crate::math::Math;
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::spectrum::{Factor, Reflectance, Spectrum};
use core::f32::consts::PI;

/// The choice among the three fits of Christensen and Burley 2015, which depends on how light falls on the
/// surface and on which mean free path is known.
///
/// Give it to [`Burley::from_mean_free_path`].
///
/// # Example
///
/// ```
/// use nanospectra::matter::BurleyFit;
/// // At an albedo of 0.8 the mean free path is divided by 1.85 - 0.8 for a narrow beam.
/// assert!((BurleyFit::Beam.scaling(0.8) - 1.05).abs() < 1e-6);
/// assert!((BurleyFit::Diffuse.scaling(0.8) - 1.1).abs() < 1e-6);
/// assert!((BurleyFit::DiffusePath.scaling(0.33) - 3.5).abs() < 1e-6);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum BurleyFit {
    /// Light falls in as a narrow beam at normal incidence, and the volume mean free path is known. See the
    /// [example](#example).
    Beam,
    /// Light falls in from all sides and is refracted, and the volume mean free path is known. See the
    /// [example](#example).
    Diffuse,
    /// The diffuse mean free path is known, which is measured on the surface. See the [example](#example).
    DiffusePath,
}

impl BurleyFit {
    /// Returns the number by which a mean free path is divided to get Burley's d, for a surface albedo of
    /// 0..=1.
    ///
    /// See the [example](#example).
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

/// Burley's profile of normalized diffusion, which tells how far from where light entered a translucent
/// material it leaves.
///
/// The profile is R(r) = A (exp(-r/d) + exp(-r/3d)) / (8 pi d r) with an albedo A and a distance d for each
/// bin; its integral over the surface is A. Make it by [`new`](Self::new) or from mean free paths, evaluate
/// it by [`times_radius`](Self::times_radius), and place samples with
/// [`burley_distance`]. Where d is 0, light leaves where it entered, as from a
/// [`Lambert`](crate::matter::Lambert) surface. Lengths are in m (or all in another unit).
///
/// # Example
///
/// ```
/// # #[cfg(feature = "libm")] {
/// use nanospectra::Reflectance;
/// use nanospectra::matter::Burley;
/// let skin = Burley::<16>::new(Reflectance::flat(0.6), [1e-3; 16]);
/// // Within a distance of 3 d leaves A (1 - exp(-3) / 4 - 3 exp(-1) / 4).
/// assert!((skin.within(3e-3).values()[0] - 0.6 * 0.711_64).abs() < 1e-5);
/// // r R(r) at r = 0 is 2 A / (8 pi d).
/// assert!((skin.times_radius(0.0).values()[0] - 47.746).abs() < 1e-2);
/// // All that leaves is the albedo.
/// assert_eq!(skin.reflectance().values(), &[0.6; 16]);
/// assert_eq!(skin.distance(), &[1e-3; 16]);
/// # }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Burley<const N: usize, G = Bins<380, 730>> {
    albedo: Reflectance<N, G>,
    distance: [f32; N],
}

impl<const N: usize, G: Bands> Burley<N, G> {
    /// Makes a profile from the albedo, 0..=1, and the distance d of each bin, 0 or more, in m. See the
    /// [example](#example).
    #[must_use]
    pub const fn new(albedo: Reflectance<N, G>, distance: [f32; N]) -> Self {
        Burley { albedo, distance }
    }

    /// Makes a profile from the albedo, 0..=1, and the mean free path of each bin, 0 or more, in m.
    ///
    /// `by` says how light falls in and which mean free path it is.
    ///
    /// # Example
    ///
    /// ```
    /// use nanospectra::Reflectance;
    /// use nanospectra::matter::{Burley, BurleyFit};
    /// // At an albedo of 0.8 a mean free path of 1.05 mm makes a distance of 1 mm.
    /// let wax = Burley::<16>::from_mean_free_path(Reflectance::flat(0.8), [1.05e-3; 16], BurleyFit::Beam);
    /// assert!((wax.distance()[0] - 1e-3).abs() < 1e-8);
    /// ```
    #[must_use]
    pub fn from_mean_free_path(albedo: Reflectance<N, G>, path: [f32; N], by: BurleyFit) -> Self {
        let mut distance = path;
        for (d, albedo) in distance.iter_mut().zip(albedo.values()) {
            *d /= by.scaling(*albedo);
        }
        Burley { albedo, distance }
    }

    /// Computes the share of the light that leaves within the distance `r` from where it entered, 0..=albedo.
    ///
    /// This is the integral of the profile over that disk. `r` is 0 or more; otherwise the result is NaN. A
    /// bin with d = 0 gives its albedo at any `r`. See the [example](#example).
    ///
    /// # Accuracy
    /// 4 units of 2^-24, relative.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn within(&self, r: f32) -> Spectrum<Factor, N, G> {
        self.within_with::<Portable>(r)
    }

    /// Computes r R(r), the profile times the distance `r` from where light entered, in 1/m.
    ///
    /// 2 pi times this leaves from a ring of radius `r`, for each meter of its width. `r` is 0 or more;
    /// otherwise the result is NaN. A bin with d = 0 gives 0 beyond r = 0 and infinity at r = 0, or 0 if its
    /// albedo is 0. See the [example](#example).
    ///
    /// # Accuracy
    /// (r / d + 4) units of 2^-24, relative.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn times_radius(&self, r: f32) -> Spectrum<Factor, N, G> {
        self.times_radius_with::<Portable>(r)
    }

    /// Computes the same as [`times_radius`](Self::times_radius), on the math backend `M`.
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

    /// Returns the share of the light that leaves anywhere, which is the albedo. See the [example](#example).
    #[must_use]
    pub const fn reflectance(&self) -> Reflectance<N, G> {
        self.albedo
    }

    /// Returns the distance d of each bin, in m. See the [example](#example).
    #[must_use]
    pub const fn distance(&self) -> &[f32; N] {
        &self.distance
    }

    /// Computes the same as [`within`](Self::within), on the math backend `M`.
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

/// Computes the distance, in units of Burley's d, within which a given share of the light that leaves does
/// so.
///
/// It is the inverse of 1 - exp(-x)/4 - 3 exp(-x/3)/4 and turns a uniform random number into the distance of
/// a sample. `share` is 0..=1; otherwise the result is NaN.
///
/// # Accuracy
/// 4e-7, relative, for the share as it is rounded to f32.
///
/// # Example
///
/// ```
/// use nanospectra::matter::burley_distance;
/// // 1 - exp(-3) / 4 - 3 exp(-1) / 4 leaves within three times d.
/// assert!((burley_distance(0.711_644) - 3.0).abs() < 1e-4);
/// ```
#[cfg(feature = "libm")]
#[must_use]
pub fn burley_distance(share: f32) -> f32 {
    burley_distance_with::<Portable>(share)
}

/// Computes the distance, in units of Burley's d, within which a given share of the light leaves, on the math
/// backend `M`.
///
/// [`burley_distance`] does the same without naming a backend; see the [example](burley_distance#example)
/// there.
#[must_use]
pub fn burley_distance_with<M: Math>(share: f32) -> f32 {
    if !(0.0..=1.0).contains(&share) {
        return f32::NAN;
    }
    if share > 0.5 {
        // With e = e^(-x/3), e^3 + 3 e = 4 (1 - share) holds exactly. The left side is convex, so that
        // Newton's steps from above stay above.
        let rest = 4.0 * (1.0 - share);
        let mut e = rest / 3.0;
        for _ in 0..4 {
            e -= (e * (e * e + 3.0) - rest) / (3.0 * (e * e + 1.0));
        }
        return if e > 0.0 { -3.0 * M::ln(e) } else { f32::INFINITY };
    }
    // With e^(-x/3) = 1 - y, y^3 - 3 y^2 + 6 y = 4 share. The left side rises and is concave, so that
    // Newton's steps from below stay below.
    let mut y = share * (2.0 / 3.0);
    for _ in 0..6 {
        let excess = y * (6.0 - y * (3.0 - y)) - 4.0 * share;
        y -= excess / (6.0 - y * (6.0 - 3.0 * y));
    }
    let rest = 1.0 - y;
    if rest == 1.0 {
        return 3.0 * y;
    }
    // ln(1 - y), where 1 - y has lost digits of y: the rounding error cancels in the quotient.
    3.0 * M::ln(rest) * (y / (rest - 1.0))
}
