//! Volumes that absorb: colored glass, dyed water, wine. Beer and Lambert's law, band by band.

use crate::grid::{Bands, Bins, Grid, by_fields};
use crate::math::Math;
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::matter::rayleigh_per_m;
use crate::spectrum::{Factor, Reflectance, Spectrum};
use core::fmt;
use core::ops::Add;

/// How strongly a medium takes light out of a beam: the absorption (or extinction) coefficient of each bin,
/// in 1/m, to base e. 0 is clear, infinity is opaque.
///
/// A filter is the [`transmittance`](Self::transmittance) of a length of it. A sum of absorbers is their
/// mixture.
///
/// ```
/// # #[cfg(feature = "libm")] {
/// use nanospectra::Reflectance;
/// use nanospectra::matter::Absorber;
/// // Filter glass, measured at 2 mm without its surfaces; used at 3 mm.
/// let glass = Absorber::<16>::from_transmittance(&Reflectance::flat(0.25), 2e-3)?;
/// let thicker = glass.transmittance(3e-3);
/// assert!((thicker.values()[0] - 0.125).abs() < 1e-6); // 0.25^(3/2)
/// # }
/// # Ok::<(), nanospectra::matter::AbsorberError>(())
/// ```
pub struct Absorber<const N: usize, G = Bins<380, 730>> {
    per_m: [f32; N],
    grid: core::marker::PhantomData<G>,
}

/// The reason why numbers do not describe an absorber.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum AbsorberError {
    /// A coefficient below zero, which would be a laser, or NaN; or a transmittance outside 0..=1.
    OutOfRange {
        /// The offending bin, counted from 0.
        bin: usize,
    },
    /// A length or concentration that is not a finite number above zero.
    Amount,
}

impl fmt::Display for AbsorberError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfRange { bin } => write!(f, "bin {bin} does not absorb: its value is out of range"),
            Self::Amount => f.write_str("a length or concentration is not a finite number above zero"),
        }
    }
}

impl core::error::Error for AbsorberError {}

by_fields!([const N: usize, G] Absorber<N, G>, "Absorber": per_m);

impl<const N: usize, G: Bands> Absorber<N, G> {
    /// From absorption coefficients in 1/m, to base e, each 0 or more.
    ///
    /// # Errors
    /// [`AbsorberError::OutOfRange`]: a coefficient is negative or NaN.
    pub fn from_per_m(per_m: [f32; N]) -> Result<Self, AbsorberError> {
        match per_m.iter().position(|sigma| sigma.is_nan() || *sigma < 0.0) {
            Some(bin) => Err(AbsorberError::OutOfRange { bin }),
            None => Ok(Absorber { per_m, grid: core::marker::PhantomData }),
        }
    }

    /// From the internal transmittance, 0..=1, of a plate of `thickness_m` > 0: without reflection at its
    /// surfaces.
    ///
    /// # Errors
    /// [`AbsorberError`]: a transmittance outside 0..=1 or NaN, a thickness that is not finite and above zero.
    #[cfg(feature = "libm")]
    pub fn from_transmittance(plate: &Reflectance<N, G>, thickness_m: f32) -> Result<Self, AbsorberError> {
        Self::from_transmittance_with::<Portable>(plate, thickness_m)
    }

    /// [`from_transmittance`](Self::from_transmittance) on another math backend.
    pub fn from_transmittance_with<M: Math>(
        plate: &Reflectance<N, G>,
        thickness_m: f32,
    ) -> Result<Self, AbsorberError> {
        amount(thickness_m)?;
        // The range is checked here, as ln(NaN) and ln(2) alone would be found below.
        if let Some(bin) = plate.values().iter().position(|t| !(0.0..=1.0).contains(t)) {
            return Err(AbsorberError::OutOfRange { bin });
        }
        Self::from_per_m(plate.values().map(|t| if t == 1.0 { 0.0 } else { -M::ln(t) / thickness_m }))
    }

    /// A dissolved substance: from decadic molar absorption coefficients in L mol-1 cm-1, each 0 or more, and
    /// its concentration in mol/L, above zero; or from the absorbances of a cuvette of 1 cm with a
    /// concentration of 1.
    ///
    /// # Errors
    /// [`AbsorberError`]: a coefficient is negative or NaN; a concentration that is not finite and above zero.
    ///
    /// ```
    /// # #[cfg(feature = "libm")] {
    /// # use nanospectra::matter::Absorber;
    /// // Absorbance 1 in a cuvette of 1 cm: a tenth comes through.
    /// let wine = Absorber::<16>::from_molar([2000.0; 16], 5e-4)?;
    /// assert!((wine.transmittance(0.01).values()[0] - 0.1).abs() < 1e-7);
    /// # }
    /// # Ok::<(), nanospectra::matter::AbsorberError>(())
    /// ```
    pub fn from_molar(l_per_mol_cm: [f32; N], mol_per_l: f32) -> Result<Self, AbsorberError> {
        amount(mol_per_l)?;
        // 100 cm in a meter; ln 10 from base 10 to base e.
        Self::from_per_m(l_per_mol_cm.map(|epsilon| epsilon * mol_per_l * (100.0 * core::f32::consts::LN_10)))
    }

    /// The coefficients, in 1/m.
    #[must_use]
    pub const fn per_m(&self) -> &[f32; N] {
        &self.per_m
    }

    /// A medium with `k` times as much of it: k >= 0, else all is NaN.
    #[must_use]
    pub fn times(&self, k: f32) -> Self {
        Absorber { per_m: self.per_m.map(|sigma| depth(sigma, k)), grid: self.grid }
    }

    /// The share that comes through `path_m` meters, 0..=1: exp(-sigma d).
    ///
    /// 1 for a path of 0, and for a clear medium of any length. NaN for a negative path.
    ///
    /// # Accuracy
    /// (tau + 1) units of 2^-24, relative, with tau = sigma d; 0 beyond tau = 104. Bins are as narrow as the
    /// coefficient is smooth: within a bin it counts as constant.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn transmittance(&self, path_m: f32) -> Spectrum<Factor, N, G> {
        self.transmittance_with::<Portable>(path_m)
    }

    /// [`transmittance`](Self::transmittance) on another math backend.
    #[must_use]
    pub fn transmittance_with<M: Math>(&self, path_m: f32) -> Spectrum<Factor, N, G> {
        Spectrum::from_bins(self.per_m.map(|sigma| M::exp(-depth(sigma, path_m))))
    }

    /// The share that stays in `path_m` meters, 0..=1: 1 - exp(-sigma d), also where that is 1e-20.
    ///
    /// # Accuracy
    /// 2 units of 2^-24, relative.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn absorbed(&self, path_m: f32) -> Spectrum<Factor, N, G> {
        self.absorbed_with::<Portable>(path_m)
    }

    /// [`absorbed`](Self::absorbed) on another math backend.
    #[must_use]
    pub fn absorbed_with<M: Math>(&self, path_m: f32) -> Spectrum<Factor, N, G> {
        Spectrum::from_bins(self.per_m.map(|sigma| -M::expm1(-depth(sigma, path_m))))
    }
}

impl<const N: usize, G: Grid> Absorber<N, G> {
    /// What air scatters out of a beam (Rayleigh), at 288.15 K and 101325 Pa. Thinner air is
    /// [`times`](Self::times) its share of that density.
    ///
    /// For grids within 200..=2000 nm: below, where air also absorbs, the formula has poles.
    #[must_use]
    pub fn air() -> Self {
        let per_m = Spectrum::<Factor, N, G>::averaged(rayleigh_per_m);
        Absorber { per_m: *per_m.values(), grid: core::marker::PhantomData }
    }
}

impl<const N: usize, G> Add for Absorber<N, G> {
    type Output = Self;
    /// Both in the same volume.
    fn add(mut self, other: Self) -> Self {
        for (a, b) in self.per_m.iter_mut().zip(&other.per_m) {
            *a += b;
        }
        self
    }
}

/// Optical depth: none of infinity is none, and what is negative has none.
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
