//! A pane of glass that absorbs: a colored window, with both of its faces and all that goes to and fro in it.

use crate::grid::{Bands, Bins, by_fields};
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::math::{Math, at_most, sqrt};
use crate::matter::volume::absorption::depth;
use crate::matter::{Absorber, AbsorberError, Dielectric, PowerShares};
use crate::spectrum::{Factor, RefractiveIndex, Spectrum};

/// A plane-parallel slab between two like media: window glass, a filter, the wall of a cuvette.
///
/// Each face reflects by Fresnel's equations as if the slab were clear, the inside absorbs by Beer and
/// Lambert's law along the refracted path, and every beam that goes to and fro counts. Powers add, not
/// fields: from 0.1 mm on in ordinary light (a thinner slab is a [`ThinFilm`](crate::matter::ThinFilm)).
///
/// ```
/// # #[cfg(feature = "libm")] {
/// use nanospectra::matter::{Absorber, Slab};
/// use nanospectra::{Reflectance, Spectrum};
///
/// // Tinted glass of n = 1.5, 4 mm thick, that lets half through between its faces.
/// let tint = Absorber::<16>::from_transmittance(&Reflectance::flat(0.5), 4e-3)?;
/// let window = Slab { index: Spectrum::flat(1.5), absorber: tint, thickness_m: 4e-3 };
/// // What lies behind it is seen as `lamp.onto(&paper).through(&window.transmittance(1.0))`.
/// assert!((window.transmittance(1.0).values()[0] - 0.460_98).abs() < 1e-5);
/// assert!((window.reflectance(1.0).values()[0] - 0.049_22).abs() < 1e-5);
/// # }
/// # Ok::<(), nanospectra::matter::AbsorberError>(())
/// ```
///
/// # Accuracy
/// Reflectance and transmittance 4e-7 and what is absorbed 2e-7, absolute, at every angle; reflected,
/// transmitted and absorbed add up to 1 within 3.5e-7 (`tests/matter/slab.rs`).
///
/// # Cost
/// 8 bytes for each bin and 4; a bin takes an exp, an expm1 and three square roots at each angle.
pub struct Slab<const N: usize, G = Bins<380, 730>> {
    /// Refractive index of each bin relative to what is around it, above 0; below 1 it is a gap of air in
    /// glass. [`Spectrum::flat`] is one index, [`Glass::indices`](crate::matter::Glass::indices) are those of
    /// a glass.
    pub index: Spectrum<RefractiveIndex, N, G>,
    /// What it is made of.
    pub absorber: Absorber<N, G>,
    /// Its thickness in m, 0 or more; a negative one is none, and all is NaN.
    pub thickness_m: f32,
}

impl<const N: usize, G: Bands> Slab<N, G> {
    /// From the external transmittance (faces included), measured at right angles, and `thickness_m` > 0.
    ///
    /// # Errors
    /// As [`internal_transmittance`], and a thickness that is not finite and above zero.
    #[cfg(feature = "libm")]
    pub fn from_transmittance(
        external: &Spectrum<Factor, N, G>,
        index: Spectrum<RefractiveIndex, N, G>,
        thickness_m: f32,
    ) -> Result<Self, AbsorberError> {
        Self::from_transmittance_with::<Portable>(external, index, thickness_m)
    }

    /// [`from_transmittance`](Self::from_transmittance) on another math backend.
    pub fn from_transmittance_with<M: Math>(
        external: &Spectrum<Factor, N, G>,
        index: Spectrum<RefractiveIndex, N, G>,
        thickness_m: f32,
    ) -> Result<Self, AbsorberError> {
        let internal = internal_transmittance(external, &index)?;
        let absorber = Absorber::from_transmittance_with::<M>(&internal, thickness_m)?;
        Ok(Slab { index, absorber, thickness_m })
    }

    /// The share of unpolarized light that comes back, 0..=1, at the cosine of the angle of incidence
    /// (outside 0..=1: the nearer end).
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn reflectance(&self, cos_theta: f32) -> Spectrum<Factor, N, G> {
        self.reflectance_with::<Portable>(cos_theta)
    }

    /// [`reflectance`](Self::reflectance) on another math backend.
    #[must_use]
    pub fn reflectance_with<M: Math>(&self, cos_theta: f32) -> Spectrum<Factor, N, G> {
        self.mean::<M>(cos_theta, |shares| shares.reflected)
    }

    /// The share of unpolarized light that gets through, 0..=1: the external transmittance.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn transmittance(&self, cos_theta: f32) -> Spectrum<Factor, N, G> {
        self.transmittance_with::<Portable>(cos_theta)
    }

    /// [`transmittance`](Self::transmittance) on another math backend.
    #[must_use]
    pub fn transmittance_with<M: Math>(&self, cos_theta: f32) -> Spectrum<Factor, N, G> {
        self.mean::<M>(cos_theta, |shares| shares.transmitted)
    }

    /// The share of unpolarized light that heats the slab, 0..=1; it holds where 1 - R - T is all rounding.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn absorbed(&self, cos_theta: f32) -> Spectrum<Factor, N, G> {
        self.absorbed_with::<Portable>(cos_theta)
    }

    /// [`absorbed`](Self::absorbed) on another math backend.
    #[must_use]
    pub fn absorbed_with<M: Math>(&self, cos_theta: f32) -> Spectrum<Factor, N, G> {
        self.mean::<M>(cos_theta, |shares| shares.absorbed)
    }

    /// One of the shares for s and for p polarized light, in this order.
    ///
    /// A tilted window is a weak [`Polarizer`](crate::matter::Polarizer): exact in the intensities, while
    /// light that arrives polarized askew stays so a little too much (1 % at Brewster's angle of n = 1.5).
    ///
    /// ```
    /// use nanospectra::matter::{Absorber, Polarizer, Slab};
    /// use nanospectra::{Light, Spectrum};
    /// let clear = Absorber::<16>::from_per_m([0.0; 16])?;
    /// let pane = Slab { index: Spectrum::flat(1.5), absorber: clear, thickness_m: 4e-3 };
    /// // At Brewster's angle all of p gets through, and (1 - R) / (1 + R) of s with R = 0.1479.
    /// let [s, p] = pane.components(0.554_700_2, |shares| shares.transmitted);
    /// assert!((p.values()[0] - 1.0).abs() < 1e-6 && (s.values()[0] - 0.742_27).abs() < 1e-5);
    /// // Its s axis lies along the reference direction, p a quarter of a turn from it.
    /// let tilted = Polarizer::new(&p, &s, 0.25);
    /// let [i, q, ..] = Light::flat(1.0).polarized().through(&tilted).stokes_at(0);
    /// assert!((q / i + 0.147_93).abs() < 1e-5);
    /// # Ok::<(), nanospectra::matter::AbsorberError>(())
    /// ```
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn components(
        &self,
        cos_theta: f32,
        pick: impl Fn(PowerShares) -> f32,
    ) -> [Spectrum<Factor, N, G>; 2] {
        self.components_with::<Portable>(cos_theta, pick)
    }

    /// [`components`](Self::components) on another math backend.
    #[must_use]
    pub fn components_with<M: Math>(
        &self,
        cos_theta: f32,
        pick: impl Fn(PowerShares) -> f32,
    ) -> [Spectrum<Factor, N, G>; 2] {
        let (mut s, mut p) = ([0.0; N], [0.0; N]);
        for ((s, p), shares) in s.iter_mut().zip(&mut p).zip(self.shares::<M>(cos_theta)) {
            [*s, *p] = shares.map(&pick);
        }
        [Spectrum::from_bins(s), Spectrum::from_bins(p)]
    }

    fn mean<M: Math>(&self, cos_theta: f32, pick: impl Fn(PowerShares) -> f32) -> Spectrum<Factor, N, G> {
        let mut values = [0.0; N];
        for (value, [s, p]) in values.iter_mut().zip(self.shares::<M>(cos_theta)) {
            *value = 0.5 * (pick(s) + pick(p));
        }
        Spectrum::from_bins(values)
    }

    /// What becomes of s and p polarized light, bin by bin.
    fn shares<M: Math>(&self, cos_theta: f32) -> impl Iterator<Item = [PowerShares; 2]> {
        self.index.values().iter().zip(self.absorber.per_m()).map(move |(index, sigma)| {
            let face = Dielectric::new(*index);
            let (reflected, entering) = (face.fresnel(cos_theta), face.entering(cos_theta));
            let tau = depth(*sigma, path(self.thickness_m, face.cos_refracted(cos_theta)));
            let (passed, lost) = (M::exp(-tau), -M::expm1(-tau));
            [(reflected.s, entering.s), (reflected.p, entering.p)]
                .map(|(reflected, entering)| to_and_fro(reflected, entering, passed, lost))
        })
    }
}

by_fields!([const N: usize, G] Slab<N, G>, "Slab": index, absorber, thickness_m);

/// The internal transmittance, 0..=1, between the faces of a slab, from the external one, faces included, as
/// it is measured at right angles. `index` is that of the slab relative to what is around it.
///
/// Makers' data sheets have it for a reference thickness; [`Absorber::from_transmittance`] takes it to any
/// other.
///
/// # Accuracy
/// 6 units of 2^-24, relative.
///
/// # Errors
/// [`AbsorberError::OutOfRange`]: a transmittance below 0, NaN, or above what clear glass of this index lets through,
/// (1 - R) / (1 + R), by more than rounding (1e-6): the index is too high, or the measurement.
///
/// # Reference
/// ISO 9050, annex; Schott TIE-35, "Transmittance of optical glass".
///
/// ```
/// use nanospectra::{Reflectance, Spectrum, matter::internal_transmittance};
/// let index = Spectrum::flat(1.5);
/// let internal = internal_transmittance(&Reflectance::<1>::flat(0.460_98), &index)?;
/// assert!((internal.values()[0] - 0.5).abs() < 1e-5);
/// assert!(internal_transmittance(&Reflectance::<1>::flat(0.95), &index).is_err()); // clear glass has 0.923
/// # Ok::<(), nanospectra::matter::AbsorberError>(())
/// ```
pub fn internal_transmittance<const N: usize, G: Bands>(
    external: &Spectrum<Factor, N, G>,
    index: &Spectrum<RefractiveIndex, N, G>,
) -> Result<Spectrum<Factor, N, G>, AbsorberError> {
    let mut internal = *external;
    for (bin, (value, index)) in internal.values_mut().iter_mut().zip(index.values()).enumerate() {
        let face = Dielectric::new(*index);
        let (reflected, entering) = (face.fresnel(1.0).s, face.entering(1.0).s);
        // The root of R^2 T tau^2 + (1 - R)^2 tau - T = 0 by the formula that does not cancel, over 1 - R so
        // that no square of a nearly closed face vanishes.
        let through = *value / entering;
        let both = 2.0 * reflected * through;
        let tau = 2.0 * through / (entering + sqrt(entering * entering + both * both));
        // Not for what is NaN either.
        if !(0.0..=1.0 + 1e-6).contains(&tau) {
            return Err(AbsorberError::OutOfRange { bin });
        }
        *value = at_most(tau, 1.0);
    }
    Ok(internal)
}

/// The sum over all beams, where a face reflects R and lets E in, and the inside passes tau and keeps a: 1 -
/// R tau is E + R a without cancellation.
fn to_and_fro(reflected: f32, entering: f32, passed: f32, lost: f32) -> PowerShares {
    if entering == 0.0 {
        // Grazing, or total reflection.
        return PowerShares { reflected: 1.0 + 0.0 * lost, transmitted: 0.0 * lost, absorbed: 0.0 * lost };
    }
    let round = reflected * passed;
    let arriving = entering / (entering + reflected * lost);
    let transmitted = passed * arriving * (entering / (1.0 + round));
    PowerShares {
        reflected: at_most(reflected + transmitted * round, 1.0),
        transmitted,
        absorbed: lost * arriving,
    }
}

fn path(thickness: f32, cos: f32) -> f32 {
    if thickness == 0.0 && cos == 0.0 { 0.0 } else { thickness / cos }
}
