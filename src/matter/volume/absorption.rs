//! Volumes that absorb, such as colored glass, dyed water or wine, by Beer and Lambert's law in each bin.

use crate::grid::{Bands, Bins, Grid, by_fields};
use crate::math::Math;
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::matter::rayleigh_per_m;
use crate::spectrum::{Factor, Reflectance, Spectrum};
use core::fmt;
use core::ops::Add;

/// A medium that takes light out of a beam, described by its absorption coefficient in each bin.
///
/// Make it [from the transmittance of a plate](Self::from_transmittance),
/// [from coefficients](Self::from_per_m) or [from a concentration](Self::from_molar); then the
/// [`transmittance`](Self::transmittance) of a length of it is a filter. The coefficients are in 1/m, to base
/// e: 0 is clear, and infinity is opaque. They may be extinction coefficients, which include what is
/// scattered out of the beam. The sum (`+`) of two absorbers is their mixture.
///
/// # Example
///
/// ```
/// # #[cfg(feature = "libm")] {
/// use nanospectra::Reflectance;
/// use nanospectra::matter::{Absorber, AbsorberError};
/// // A filter glass was measured at 2 mm, without the reflection at its faces, and is used at 3 mm.
/// let glass = Absorber::<16>::from_transmittance(&Reflectance::flat(0.25), 2e-3)?;
/// let thicker = glass.transmittance(3e-3);
/// assert!((thicker.values()[0] - 0.125).abs() < 1e-6); // 0.25^(3/2)
/// assert!((glass.absorbed(3e-3)[0] - 0.875).abs() < 1e-6); // the rest
/// // Twice as much of the pigment acts as twice the thickness: 0.25^2 at 2 mm.
/// assert!((glass.times(2.0).transmittance(2e-3)[0] - 0.0625).abs() < 1e-6);
/// // The coefficient is ln(4) / 2 mm.
/// assert!((glass.per_m()[0] - 693.147).abs() < 1e-2);
/// assert_eq!(Absorber::<16>::from_per_m([-1.0; 16]), Err(AbsorberError::OutOfRange { bin: 0 }));
/// assert_eq!(Absorber::<16>::from_molar([1.0; 16], 0.0), Err(AbsorberError::Amount));
/// # }
/// # Ok::<(), nanospectra::matter::AbsorberError>(())
/// ```
pub struct Absorber<const N: usize, G = Bins<380, 730>> {
    per_m: [f32; N],
    grid: core::marker::PhantomData<G>,
}

/// The reason why numbers do not describe an [`Absorber`].
///
/// See the [example](Absorber#example).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum AbsorberError {
    /// A coefficient that is NaN or below 0, as only a laser has it, or a transmittance that is outside
    /// 0..=1.
    OutOfRange {
        /// The first bin with such a value, counted from 0.
        bin: usize,
    },
    /// A length or a concentration that is not a finite number above 0.
    Amount,
}

impl fmt::Display for AbsorberError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfRange { bin } => write!(f, "the value of bin {bin} is out of range"),
            Self::Amount => f.write_str("a length or concentration is not a finite number above zero"),
        }
    }
}

impl core::error::Error for AbsorberError {}

by_fields!([const N: usize, G] Absorber<N, G>, "Absorber": per_m);

impl<const N: usize, G: Bands> Absorber<N, G> {
    /// Makes an absorber from its absorption coefficients in 1/m, to base e, each 0 or more.
    ///
    /// See the [example](#example).
    ///
    /// # Errors
    /// [`AbsorberError::OutOfRange`]: a coefficient is negative or NaN.
    pub fn from_per_m(per_m: [f32; N]) -> Result<Self, AbsorberError> {
        match per_m.iter().position(|sigma| sigma.is_nan() || *sigma < 0.0) {
            Some(bin) => Err(AbsorberError::OutOfRange { bin }),
            None => Ok(Absorber { per_m, grid: core::marker::PhantomData }),
        }
    }

    /// Makes an absorber from the internal transmittance of a plate, 0..=1, and its thickness in m, above 0.
    ///
    /// The internal transmittance is that without the reflection at the faces of the plate;
    /// [`internal_transmittance`](crate::matter::internal_transmittance) computes it from a measurement that
    /// includes them. See the [example](#example).
    ///
    /// # Errors
    /// * [`AbsorberError::OutOfRange`]: a transmittance is outside 0..=1 or NaN.
    /// * [`AbsorberError::Amount`]: the thickness is not a finite number above 0.
    #[cfg(feature = "libm")]
    pub fn from_transmittance(plate: &Reflectance<N, G>, thickness_m: f32) -> Result<Self, AbsorberError> {
        Self::from_transmittance_with::<Portable>(plate, thickness_m)
    }

    /// Makes the same as [`from_transmittance`](Self::from_transmittance), on the math backend `M`.
    pub fn from_transmittance_with<M: Math>(
        plate: &Reflectance<N, G>,
        thickness_m: f32,
    ) -> Result<Self, AbsorberError> {
        amount(thickness_m)?;
        // The range is checked here, since `from_per_m` would not find every wrong transmittance.
        if let Some(bin) = plate.values().iter().position(|t| !(0.0..=1.0).contains(t)) {
            return Err(AbsorberError::OutOfRange { bin });
        }
        Self::from_per_m(plate.values().map(|t| if t == 1.0 { 0.0 } else { -M::ln(t) / thickness_m }))
    }

    /// Makes an absorber from the molar absorption coefficients of a dissolved substance and its
    /// concentration.
    ///
    /// `l_per_mol_cm` are decadic coefficients in L mol-1 cm-1, each 0 or more, and `mol_per_l` is the
    /// concentration in mol/L, above 0. To start from the absorbances of a cuvette of 1 cm, give these with a
    /// concentration of 1.
    ///
    /// # Errors
    /// * [`AbsorberError::OutOfRange`]: a coefficient is negative or NaN.
    /// * [`AbsorberError::Amount`]: the concentration is not a finite number above 0.
    ///
    /// # Example
    ///
    /// ```
    /// # #[cfg(feature = "libm")] {
    /// # use nanospectra::matter::Absorber;
    /// // The absorbance is 1 in a cuvette of 1 cm, so a tenth gets through.
    /// let wine = Absorber::<16>::from_molar([2000.0; 16], 5e-4)?;
    /// assert!((wine.transmittance(0.01).values()[0] - 0.1).abs() < 1e-7);
    /// # }
    /// # Ok::<(), nanospectra::matter::AbsorberError>(())
    /// ```
    pub fn from_molar(l_per_mol_cm: [f32; N], mol_per_l: f32) -> Result<Self, AbsorberError> {
        amount(mol_per_l)?;
        // There are 100 cm in a meter, and ln 10 leads from base 10 to base e.
        Self::from_per_m(l_per_mol_cm.map(|epsilon| epsilon * mol_per_l * (100.0 * core::f32::consts::LN_10)))
    }

    /// Returns the absorption coefficient of each bin, in 1/m. See the [example](#example).
    #[must_use]
    pub const fn per_m(&self) -> &[f32; N] {
        &self.per_m
    }

    /// Makes the medium that holds `k` times as much of the absorbing substance in the same volume.
    ///
    /// `k` is 0 or more; otherwise all coefficients are NaN. See the [example](#example).
    #[must_use]
    pub fn times(&self, k: f32) -> Self {
        Absorber { per_m: self.per_m.map(|sigma| depth(sigma, k)), grid: self.grid }
    }

    /// Computes the share of the light that gets through `path_m` meters of the medium, 0..=1.
    ///
    /// It is exp(-sigma d): 1 for a path of 0, and for any length of a clear medium. For a negative path it
    /// is NaN. See the [example](#example).
    ///
    /// # Accuracy
    /// (tau + 1.2) units of 2^-24, relative, with tau = sigma d; 0 beyond tau = 104. The coefficient counts
    /// as constant within a bin, so choose bins that are narrow where it changes quickly.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn transmittance(&self, path_m: f32) -> Spectrum<Factor, N, G> {
        self.transmittance_with::<Portable>(path_m)
    }

    /// Computes the same as [`transmittance`](Self::transmittance), on the math backend `M`.
    #[must_use]
    pub fn transmittance_with<M: Math>(&self, path_m: f32) -> Spectrum<Factor, N, G> {
        Spectrum::from_bins(self.per_m.map(|sigma| M::exp(-depth(sigma, path_m))))
    }

    /// Computes the share of the light that is absorbed within `path_m` meters of the medium, 0..=1.
    ///
    /// It is 1 - exp(-sigma d), computed so that it stays accurate where it is as small as 1e-20. See the
    /// [example](#example).
    ///
    /// # Accuracy
    /// 2 units of 2^-24, relative.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn absorbed(&self, path_m: f32) -> Spectrum<Factor, N, G> {
        self.absorbed_with::<Portable>(path_m)
    }

    /// Computes the same as [`absorbed`](Self::absorbed), on the math backend `M`.
    #[must_use]
    pub fn absorbed_with<M: Math>(&self, path_m: f32) -> Spectrum<Factor, N, G> {
        Spectrum::from_bins(self.per_m.map(|sigma| -M::expm1(-depth(sigma, path_m))))
    }
}

impl<const N: usize, G: Grid> Absorber<N, G> {
    /// Makes an absorber that stands for the light that air scatters out of a beam (Rayleigh scattering).
    ///
    /// It holds at 288.15 K and 101325 Pa. For thinner air multiply it, by [`times`](Self::times), with the
    /// share of that density. The grid must lie within 200..=2000 nm: below, air also absorbs, and the
    /// formula has poles.
    ///
    /// # Example
    ///
    /// ```
    /// # #[cfg(feature = "libm")] {
    /// use nanospectra::{Bins, matter::Absorber};
    /// // A vertical beam crosses as much air as 8.4 km of it at sea level. The sky takes more of the blue.
    /// let air = Absorber::<3, Bins<400, 700>>::air().transmittance(8400.0);
    /// assert!(air[0] < air[1] && air[1] < air[2]);
    /// // The optical depth at 550 nm is 0.097 (Bodhaine et al. 1999).
    /// assert!((air[1] - 0.907).abs() < 0.01);
    /// # }
    /// ```
    #[must_use]
    pub fn air() -> Self {
        let per_m = Spectrum::<Factor, N, G>::averaged(rayleigh_per_m);
        Absorber { per_m: *per_m.values(), grid: core::marker::PhantomData }
    }
}

impl<const N: usize, G> Add for Absorber<N, G> {
    type Output = Self;
    /// Mixes two absorbers, so that both fill the same volume.
    fn add(mut self, other: Self) -> Self {
        for (a, b) in self.per_m.iter_mut().zip(&other.per_m) {
            *a += b;
        }
        self
    }
}

/// The optical depth of a path: 0 times infinity is 0, and a negative path has none (NaN).
pub(super) fn depth(sigma: f32, path: f32) -> f32 {
    if path < 0.0 {
        f32::NAN
    } else if (sigma == 0.0 && path == f32::INFINITY) || (path == 0.0 && sigma == f32::INFINITY) {
        0.0
    } else {
        sigma * path
    }
}

fn amount(x: f32) -> Result<(), AbsorberError> {
    if x > 0.0 && x < f32::INFINITY { Ok(()) } else { Err(AbsorberError::Amount) }
}
