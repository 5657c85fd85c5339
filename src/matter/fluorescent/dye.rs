//! Dyes, which absorb light at one wavelength and emit it at a longer one.

use crate::grid::{Bands, Bins, Grid, Layout, by_fields};
use crate::math::const_for;
use crate::matter::effect::glowing;
use crate::matter::{Effect, Foldable, Glows};
use crate::observer::Stimulus;
use crate::price::{Effects, Price, Priced};
use crate::spectrum::{Factor, Outside, Power, Spectrum};
use crate::sum::rows;
use core::array::from_ref;
use core::marker::PhantomData;

/// A fluorescent dye: a surface (or a filter) that reflects as any other does, and also glows in a color of
/// its own, whatever light excites it.
///
/// Make it by [`new`](Self::new) from its reflectance, absorption, emission and quantum yield. Then put it
/// into a [path](crate::path) with `light.onto(&dye)`, or combine it with the observer that looks at it, by
/// [`Observer::looking_at_dye`](crate::Observer::looking_at_dye).
///
/// The light that leaves in bin `k` is `reflectance[k] * light[k] + emission[k] * sum(absorption * light)`,
/// where the emission at shorter wavelengths than are absorbed is included. That one emission spectrum is
/// enough is Kasha's and Vavilov's rule. A dye needs two numbers for each bin more than a plain surface; the
/// full [`Donaldson`](crate::matter::Donaldson) matrix needs `N / 2` and differs from the dye by 0.08
/// CIEDE2000 for a vest in fluorescent yellow.
///
/// # Example
///
/// ```
/// use nanospectra::matter::Dye;
/// use nanospectra::{Bins, Light, Reflectance};
///
/// // Bins at 450, 550 and 650 nm: blue is absorbed and comes back as green.
/// type Grid = Bins<400, 700>;
/// let dye = Dye::new(
///     &Reflectance::<3, Grid>::from_bins([0.1, 0.8, 0.8]),
///     &Reflectance::from_bins([0.5, 0.0, 0.0]),
///     &Light::from_bins([0.0, 1.0, 0.0]),
///     0.88,
/// )?;
/// let vest = Light::<3, Grid>::flat(1.0).onto(&dye).collected();
/// // Half of the photons at 450 nm are absorbed, and 0.88 of these come back as photons of 550 nm. That is
/// // 0.5 * 0.88 * 450 / 550 = 0.36 of the energy.
/// assert!((vest.values()[1] - (0.8 + 0.36)).abs() < 1e-6);
/// // In total the dye emits 0.36 of the power in a bin of 100 nm.
/// assert!((dye.glow_under(&Light::flat(1.0)) - 36.0).abs() < 1e-4);
/// // Without the glow it is a plain surface.
/// assert_eq!(dye.reflectance().values(), &[0.1, 0.8, 0.8]);
/// // On a finer grid the same dye emits as much.
/// let fine = dye.resample::<30, Grid>();
/// assert!((fine.glow_under(&Light::flat(1.0)) - 36.0).abs() < 1e-4);
/// # Ok::<(), nanospectra::matter::FluorescenceError>(())
/// ```
///
/// # Accuracy
/// The color of a vest in fluorescent yellow under FL1 to FL12, the CIE LEDs, D65 and A, on the white of each
/// light, differs from a computation at 1 nm in f64 by 0.03 CIEDE2000 in 60 bins of the default grid, by 0.09
/// in 31 and by 0.4 in 16. Leaving the glow out costs 7 to 18 (`tests/matter/fluorescence.rs`). A grid that
/// ends within the absorption band loses what is absorbed beyond: 3 % of Y in daylight for a dye that absorbs
/// down to 360 nm, on a grid from 380 nm.
///
/// # Cost
/// At 31 bins light off a dye to XYZ takes 533 instructions on a Cortex-M4F; off a plain surface it takes
/// 378.
pub struct Dye<const N: usize, G = Bins<380, 730>> {
    pub(super) reflects: [f32; N],
    /// How much light of 1 per nm in this bin adds to the glow.
    pub(super) absorbs: [f32; N],
    /// The emitted power per nm, for a glow of 1.
    pub(super) emits: [f32; N],
    // A function type, so that a dye can be shared between threads whatever `G` is.
    grid: PhantomData<fn() -> G>,
}

by_fields!([const N: usize, G] Dye<N, G>, "Dye": reflects, absorbs, emits);

/// The reason why numbers do not describe fluorescent matter.
///
/// It is returned by [`Dye::new`] and [`Donaldson::new`](crate::matter::Donaldson::new).
///
/// # Example
///
/// ```
/// use nanospectra::matter::{Donaldson, Dye, FluorescenceError};
/// use nanospectra::{Bins, Light, Reflectance};
///
/// type Grid = Bins<400, 700>;
/// let dye = |reflectance, absorption, emission, quantum_yield| {
///     let [reflectance, absorption] = [reflectance, absorption].map(Reflectance::from_bins);
///     Dye::<3, Grid>::new(&reflectance, &absorption, &Light::from_bins(emission), quantum_yield).err()
/// };
/// let (gray, blue, green) = ([0.4; 3], [0.5, 0.0, 0.0], [0.0, 1.0, 0.0]);
/// assert_eq!(dye(gray, blue, green, 0.9), None);
/// assert_eq!(dye(gray, blue, green, 1.1), Some(FluorescenceError::QuantumYield));
/// assert_eq!(dye(gray, blue, [0.0; 3], 0.9), Some(FluorescenceError::NoEmission));
/// assert_eq!(dye(gray, [-0.5, 0.0, 0.0], green, 0.9), Some(FluorescenceError::OutOfRange { bin: 0 }));
/// // 0.7 reflected and 0.5 absorbed are more than the light that came.
/// assert_eq!(dye([0.7; 3], blue, green, 0.9), Some(FluorescenceError::Energy { bin: 0 }));
///
/// // A matrix whose light of bin 1 leaves in bin 0, at a shorter wavelength.
/// let error = Donaldson::<3, 6, Grid>::new(&[[0.1, 0.2, 0.0], [0.0, 0.3, 0.0], [0.0, 0.0, 0.3]]).err();
/// assert_eq!(error, Some(FluorescenceError::AntiStokes { from: 1, to: 0 }));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum FluorescenceError {
    /// A value that is negative, infinite or not a number. See the [example](#example).
    OutOfRange {
        /// The bin in which the value stands, counted from 0.
        bin: usize,
    },
    /// Light leaves at a shorter wavelength than it came with. See the [example](#example).
    AntiStokes {
        /// The bin in which the light comes, counted from 0.
        from: usize,
        /// The bin in which the light leaves, counted from 0.
        to: usize,
    },
    /// The quantum yield is outside 0..=1, or it is not a number. See the [example](#example).
    QuantumYield,
    /// An emission spectrum that is zero everywhere. See the [example](#example).
    NoEmission,
    /// Light of a bin leaves with more energy than it came with. See the [example](#example).
    Energy {
        /// The bin in which the light comes, counted from 0.
        bin: usize,
    },
    /// Light of a bin leaves as more photons than it came as.
    Photons {
        /// The bin in which the light comes, counted from 0.
        bin: usize,
    },
}

impl FluorescenceError {
    /// Returns the reason without its numbers, as [`const_unwrap!`](crate::const_unwrap) reports it.
    #[must_use]
    pub const fn message(&self) -> &'static str {
        match self {
            Self::OutOfRange { .. } => "a value is negative or not finite",
            Self::AntiStokes { .. } => "light leaves at a shorter wavelength than it came with",
            Self::QuantumYield => "the quantum yield is not in 0..=1",
            Self::NoEmission => "the emission is zero everywhere",
            Self::Energy { .. } => "light leaves with more energy than it came with",
            Self::Photons { .. } => "light leaves as more photons than it came as",
        }
    }
}

impl core::fmt::Display for FluorescenceError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(self.message())?;
        match self {
            Self::OutOfRange { bin } | Self::Energy { bin } | Self::Photons { bin } => {
                write!(f, " (bin {bin})")
            }
            Self::AntiStokes { from, to } => write!(f, " (from bin {from} to bin {to})"),
            Self::QuantumYield | Self::NoEmission => Ok(()),
        }
    }
}

impl core::error::Error for FluorescenceError {}

/// How much rounding may add to a sum that must not exceed 1.
pub(super) const ROUNDING: f64 = 1e-6;

impl<const N: usize, G: Bands> Dye<N, G> {
    /// Makes a dye from four quantities that can be measured.
    ///
    /// * `reflectance`: the reflectance without the glow.
    /// * `absorption`: the share of the light of each bin that the dye absorbs, 0..=1.
    /// * `emission`: the spectrum that the dye emits, as power per nm in any unit.
    /// * `quantum_yield`: the number of photons emitted for each one absorbed, 0..=1.
    ///
    /// Best give them at 1 nm and [`resample`](Self::resample) the result. Absorption below the grid, in the
    /// ultraviolet, is lost; optical brighteners need a grid from 300 nm. The function computes in f64 and is
    /// meant for `const` use. See the [example](#example).
    ///
    /// # Errors
    /// * [`FluorescenceError::QuantumYield`]: the yield is outside 0..=1.
    /// * [`FluorescenceError::OutOfRange`]: a value is negative or not finite.
    /// * [`FluorescenceError::NoEmission`]: the emission is zero everywhere.
    /// * [`FluorescenceError::Energy`]: the light of a bin leaves with more energy than it came with. Either
    ///   reflectance and absorption are together above 1, or long wavelengths are emitted again as shorter
    ///   ones. At a low yield the latter is accepted, because the tails of real dyes overlap.
    pub const fn new(
        reflectance: &Spectrum<Factor, N, G>,
        absorption: &Spectrum<Factor, N, G>,
        emission: &Spectrum<Power, N, G>,
        quantum_yield: f32,
    ) -> Result<Self, FluorescenceError>
    where
        G: Grid,
    {
        if !(0.0 <= quantum_yield && quantum_yield <= 1.0) {
            return Err(FluorescenceError::QuantumYield);
        }
        // Photons are power times wavelength. Each one absorbed comes back, on average, as one of the
        // emission.
        let (mut power, mut photons) = (0.0, 0.0);
        const_for!(0..N, |k| {
            let values = [reflectance.0[k], absorption.0[k], emission.0[k]];
            const_for!(0..3, |i| {
                if !(0.0 <= values[i] && values[i] < f32::INFINITY) {
                    return Err(FluorescenceError::OutOfRange { bin: k });
                }
            });
            power += emission.0[k] as f64;
            photons += emission.0[k] as f64 * wavelength::<N, G>(k);
        });
        if photons == 0.0 {
            return Err(FluorescenceError::NoEmission);
        }
        let mut dye = Dye { reflects: reflectance.0, absorbs: [0.0; N], emits: [0.0; N], grid: PhantomData };
        const_for!(0..N, |k| {
            // The total power emitted for each unit of power absorbed.
            let stays = quantum_yield as f64 * wavelength::<N, G>(k) * power / photons;
            let absorbed = absorption.0[k] as f64;
            if reflectance.0[k] as f64 + absorbed > 1.0 + ROUNDING
                || reflectance.0[k] as f64 + absorbed * stays > 1.0 + ROUNDING
            {
                return Err(FluorescenceError::Energy { bin: k });
            }
            dye.absorbs[k] = (absorbed * stays * Layout::<G, N>::WIDTH) as f32;
            dye.emits[k] = (emission.0[k] as f64 / (power * Layout::<G, N>::WIDTH)) as f32;
        });
        Ok(dye)
    }

    /// Computes the same dye on another grid.
    ///
    /// The result is exact for light that is constant within each of the new bins, and the emitted energy is
    /// kept. Beyond the old grid the reflectance keeps its end values, and nothing is absorbed or emitted.
    /// See the [example](#example).
    #[must_use]
    pub fn resample<const M: usize, H: Grid>(&self) -> Dye<M, H>
    where
        G: Grid,
    {
        let reflects = Spectrum::<Factor, N, G>::from_bins(self.reflects).resample::<M, H>();
        let emits = Spectrum::<Power, N, G>::from_bins(self.emits).resample::<M, H>();
        // `absorbs` is a total over each bin; divided by the width it is an average, which can be resampled.
        let absorbs = Spectrum::<Factor, N, G>::from_bins(self.absorbs) * (1.0 / Layout::<G, N>::STEP);
        let absorbs = absorbs.resample_outside::<M, H>(Outside::Zero) * Layout::<H, M>::STEP;
        Dye {
            reflects: *reflects.values(),
            absorbs: *absorbs.values(),
            emits: *emits.values(),
            grid: PhantomData,
        }
    }
}

impl<const N: usize, G> Dye<N, G> {
    /// Returns the reflectance that the dye has without its glow. See the [example](#example).
    #[must_use]
    pub const fn reflectance(&self) -> Spectrum<Factor, N, G> {
        Spectrum::unchecked(self.reflects)
    }

    /// Computes the total power that the dye emits under this light, in the light's unit of power per nm,
    /// times nm. See the [example](#example).
    #[must_use]
    #[inline]
    pub fn glow_under<S: Stimulus<Power, N, G>>(&self, light: S) -> f32 {
        light.read(|light| self.glow_in(light))
    }

    /// [`Foldable::transposed`] in f64, for `const` use.
    pub(crate) const fn transposed_in_f64(&self, weights: &[f32; N]) -> [f32; N] {
        // The response of the observer to the light that the dye emits for a glow of 1.
        let mut glow = 0.0;
        const_for!(0..N, |k| glow += weights[k] as f64 * self.emits[k] as f64);
        let mut before = [0.0; N];
        const_for!(0..N, |k| {
            let reflected = weights[k] as f64 * self.reflects[k] as f64;
            before[k] = (reflected + glow * self.absorbs[k] as f64) as f32;
        });
        before
    }
}

impl<const N: usize, G> Effect<N, G> for Dye<N, G> {
    #[inline]
    fn leaving(&self, light: &Spectrum<Power, N, G>) -> Spectrum<Power, N, G> {
        glowing(self, light)
    }
}

impl<const N: usize, G> Glows<N, G> for Dye<N, G> {
    #[inline]
    fn glow_in(&self, light: &Spectrum<Power, N, G>) -> f32 {
        let [glow] = rows(from_ref(&self.absorbs), &light.0);
        glow
    }

    #[inline]
    fn leaving_bin(&self, k: usize, incoming: f32, glow: f32) -> f32 {
        let value = |values: &[f32; N]| values.get(k).copied().unwrap_or(f32::NAN);
        incoming * value(&self.reflects) + value(&self.emits) * glow
    }
}

impl<const N: usize, G> Foldable<N, G> for Dye<N, G> {
    fn transposed(&self, weights: &[f32; N]) -> [f32; N] {
        let [glow] = rows(from_ref(weights), &self.emits);
        let mut before = *weights;
        for ((weight, reflects), absorbs) in before.iter_mut().zip(&self.reflects).zip(&self.absorbs) {
            *weight = *weight * reflects + glow * absorbs;
        }
        before
    }

    fn without_effect(&self) -> Spectrum<Factor, N, G> {
        self.reflectance()
    }

    fn name(&self) -> &'static str {
        "dye"
    }

    fn price(&self) -> Price {
        Self::PRICE
    }
}

impl<const N: usize, G> Priced for Dye<N, G> {
    const PRICE: Price = Price { effects: Effects::FLUORESCENCE, multiply_adds: 3 * N, bytes: 12 * N };
    const AGAIN: usize = 2 * N;
}

/// The center of bin `k`, in nm.
pub(super) const fn wavelength<const N: usize, G: Grid>(k: usize) -> f64 {
    Layout::<G, N>::START + (k as f64 + 0.5) * Layout::<G, N>::WIDTH
}
