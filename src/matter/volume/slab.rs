//! Panes that absorb, such as colored windows, with both faces and all reflections between them.

use crate::grid::{Bands, Bins, by_fields};
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::math::{Math, at_most, sqrt};
use crate::matter::volume::absorption::depth;
use crate::matter::{Absorber, AbsorberError, Dielectric, PowerShares};
use crate::spectrum::{Factor, RefractiveIndex, Spectrum};

/// A plane-parallel slab that has the same medium on both sides: window glass, a filter, the wall of a
/// cuvette.
///
/// Fill in its fields, or make it from a measured transmittance by
/// [`from_transmittance`](Self::from_transmittance). Then [`transmittance`](Self::transmittance) is the
/// filter that it is at an angle of incidence, and [`reflectance`](Self::reflectance) what it mirrors.
///
/// Each face reflects by Fresnel's equations as if the slab were clear, the inside absorbs by Beer and
/// Lambert's law along the refracted path, and every beam that goes to and fro counts. The powers of these
/// beams are added, not their fields. In ordinary light that is right from a thickness of 0.1 mm on; a
/// thinner slab is a [`ThinFilm`](crate::matter::ThinFilm).
///
/// # Example
///
/// ```
/// # #[cfg(feature = "libm")] {
/// use nanospectra::matter::{Absorber, Slab};
/// use nanospectra::{Reflectance, Spectrum};
///
/// // Tinted glass of n = 1.5, 4 mm thick, that lets half of the light through between its faces.
/// let tint = Absorber::<16>::from_transmittance(&Reflectance::flat(0.5), 4e-3)?;
/// let window = Slab { index: Spectrum::flat(1.5), absorber: tint, thickness_m: 4e-3 };
/// // `lamp.onto(&paper).through(&window.transmittance(1.0))` is what is seen of the paper behind it.
/// assert!((window.transmittance(1.0).values()[0] - 0.460_98).abs() < 1e-5);
/// assert!((window.reflectance(1.0).values()[0] - 0.049_22).abs() < 1e-5);
/// assert!((window.absorbed(1.0).values()[0] - 0.489_80).abs() < 1e-5); // all three add up to 1
/// // The same window from the transmittance that was measured with its faces.
/// let measured = Slab::from_transmittance(&Reflectance::<16>::flat(0.460_98), Spectrum::flat(1.5), 4e-3)?;
/// assert!((measured.transmittance(0.5).values()[0] - window.transmittance(0.5).values()[0]).abs() < 1e-5);
/// # }
/// # Ok::<(), nanospectra::matter::AbsorberError>(())
/// ```
///
/// # Accuracy
/// Reflectance and transmittance 5e-7 and what is absorbed 2.5e-7, absolute, at every angle; reflected,
/// transmitted and absorbed add up to 1 within 6e-7. Of a gap, whose index is below 1, the rounding of the
/// cosine costs up to 3e-3 beside the critical angle (searched in `tests/matter/worst_layers.rs`).
///
/// # Cost
/// 8 bytes for each bin and 4 more. A bin takes an exp, an expm1 and three square roots at each angle.
pub struct Slab<const N: usize, G = Bins<380, 730>> {
    /// The refractive index that each bin has relative to the medium around the slab, above 0.
    ///
    /// [`Spectrum::flat`] holds the same index in all bins, and
    /// [`Glass::indices`](crate::matter::Glass::indices) gives those of a glass. An index below 1 makes the
    /// slab a gap of air in glass.
    pub index: Spectrum<RefractiveIndex, N, G>,
    /// The medium that the slab is made of, as far as it absorbs. See the [example](#example).
    pub absorber: Absorber<N, G>,
    /// The thickness of the slab in m, 0 or more; if it is negative, all results are NaN.
    pub thickness_m: f32,
}

impl<const N: usize, G: Bands> Slab<N, G> {
    /// Makes a slab from its external transmittance, that is with both faces, measured at normal incidence.
    ///
    /// `index` is the refractive index relative to the medium around the slab, and `thickness_m` its
    /// thickness in m, above 0. See the [example](#example).
    ///
    /// # Errors
    /// As [`internal_transmittance`], and [`AbsorberError::Amount`]: the thickness is not a finite number
    /// above 0.
    #[cfg(feature = "libm")]
    pub fn from_transmittance(
        external: &Spectrum<Factor, N, G>,
        index: Spectrum<RefractiveIndex, N, G>,
        thickness_m: f32,
    ) -> Result<Self, AbsorberError> {
        Self::from_transmittance_with::<Portable>(external, index, thickness_m)
    }

    /// Makes the same as [`from_transmittance`](Self::from_transmittance), on the math backend `M`.
    pub fn from_transmittance_with<M: Math>(
        external: &Spectrum<Factor, N, G>,
        index: Spectrum<RefractiveIndex, N, G>,
        thickness_m: f32,
    ) -> Result<Self, AbsorberError> {
        let internal = internal_transmittance(external, &index)?;
        let absorber = Absorber::from_transmittance_with::<M>(&internal, thickness_m)?;
        Ok(Slab { index, absorber, thickness_m })
    }

    /// Computes the share of unpolarized light that the slab reflects, 0..=1.
    ///
    /// `cos_theta` is the cosine of the angle of incidence; outside 0..=1 it counts as the nearer end. See
    /// the [example](#example).
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn reflectance(&self, cos_theta: f32) -> Spectrum<Factor, N, G> {
        self.reflectance_with::<Portable>(cos_theta)
    }

    /// Computes the same as [`reflectance`](Self::reflectance), on the math backend `M`.
    #[must_use]
    pub fn reflectance_with<M: Math>(&self, cos_theta: f32) -> Spectrum<Factor, N, G> {
        self.mean::<M>(cos_theta, |shares| shares.reflected)
    }

    /// Computes the share of unpolarized light that gets through the slab, 0..=1, which is its external
    /// transmittance.
    ///
    /// `cos_theta` is as for [`reflectance`](Self::reflectance). See the [example](#example).
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn transmittance(&self, cos_theta: f32) -> Spectrum<Factor, N, G> {
        self.transmittance_with::<Portable>(cos_theta)
    }

    /// Computes the same as [`transmittance`](Self::transmittance), on the math backend `M`.
    #[must_use]
    pub fn transmittance_with<M: Math>(&self, cos_theta: f32) -> Spectrum<Factor, N, G> {
        self.mean::<M>(cos_theta, |shares| shares.transmitted)
    }

    /// Computes the share of unpolarized light that the slab absorbs, 0..=1.
    ///
    /// It stays accurate where 1 - R - T would be rounding error. `cos_theta` is as for
    /// [`reflectance`](Self::reflectance). See the [example](#example).
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn absorbed(&self, cos_theta: f32) -> Spectrum<Factor, N, G> {
        self.absorbed_with::<Portable>(cos_theta)
    }

    /// Computes the same as [`absorbed`](Self::absorbed), on the math backend `M`.
    #[must_use]
    pub fn absorbed_with<M: Math>(&self, cos_theta: f32) -> Spectrum<Factor, N, G> {
        self.mean::<M>(cos_theta, |shares| shares.absorbed)
    }

    /// Computes one of the shares for s and for p polarized light, in this order.
    ///
    /// `pick` picks the share, for instance `|shares| shares.transmitted`. A tilted window can be described
    /// as a weak [`Polarizer`](crate::matter::Polarizer). The intensities are then exact, but light that
    /// arrives polarized between the axes keeps its polarization a little too well, by 1 % at Brewster's
    /// angle of n = 1.5.
    ///
    /// # Example
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

    /// Computes the same as [`components`](Self::components), on the math backend `M`.
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

    /// The shares for s and p polarized light in each bin.
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

/// Computes the internal transmittance of a slab, between its faces, from the external one, which includes
/// both faces and is measured at normal incidence.
///
/// `index` is the refractive index of the slab relative to the medium around it. Data sheets of filter glass
/// list the internal transmittance for a reference thickness; [`Absorber::from_transmittance`] takes it to
/// any other.
///
/// # Accuracy
/// 12 units of 2^-24, relative.
///
/// # Errors
/// [`AbsorberError::OutOfRange`]: a transmittance is NaN, below 0, or above that of clear glass of this
/// index, (1 - R) / (1 + R), by more than rounding (1e-6). Then the index or the measurement is too high.
///
/// # Reference
/// ISO 9050, annex; Schott TIE-35, "Transmittance of optical glass".
///
/// # Example
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
        // The root of R^2 T tau^2 + (1 - R)^2 tau - T = 0 by the formula that does not cancel, divided by 1 -
        // R so that its square does not underflow where the face reflects nearly all light.
        let through = *value / entering;
        let both = 2.0 * reflected * through;
        let tau = 2.0 * through / (entering + sqrt(entering * entering + both * both));
        // The negated test refuses NaN too.
        if !(0.0..=1.0 + 1e-6).contains(&tau) {
            return Err(AbsorberError::OutOfRange { bin });
        }
        *value = at_most(tau, 1.0);
    }
    Ok(internal)
}

/// The sum over all beams, where a face reflects R and lets E in, and the inside passes tau and absorbs a. 1
/// - R tau is written as E + R a, which does not cancel.
fn to_and_fro(reflected: f32, entering: f32, passed: f32, lost: f32) -> PowerShares {
    if entering == 0.0 {
        // At grazing incidence, or under total reflection, nothing enters.
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
