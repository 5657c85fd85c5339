//! Matter that absorbs light at one wavelength and emits it at a longer one.

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

/// A fluorescent dye: a surface (or a filter) that reflects as any other, and besides glows in its own color,
/// however it was excited (Kasha's and Vavilov's rules).
///
/// What leaves bin `k` is `reflectance[k] * light[k] + emission[k] * sum(absorption * light)`, emission at
/// shorter waves than are absorbed included. These are two numbers more for each bin than a surface has; the
/// full [`Donaldson`](crate::matter::Donaldson) matrix has `N / 2`, and differs by 0.08 CIEDE2000 for the
/// vest below.
///
/// ```
/// use nanospectra::matter::Dye;
/// use nanospectra::{Bins, Light, Reflectance};
///
/// // 450, 550 and 650 nm: blue is absorbed and comes back as green.
/// type Grid = Bins<400, 700>;
/// let dye = Dye::new(
///     &Reflectance::<3, Grid>::from_bins([0.1, 0.8, 0.8]),
///     &Reflectance::from_bins([0.5, 0.0, 0.0]),
///     &Light::from_bins([0.0, 1.0, 0.0]),
///     0.88,
/// )?;
/// let vest = Light::<3, Grid>::flat(1.0).onto(&dye).collected();
/// // 0.88 photons of 550 nm for each of the half that is absorbed at 450 nm: 0.5 * 0.88 * 450 / 550 of its energy.
/// assert!((vest.values()[1] - (0.8 + 0.36)).abs() < 1e-6);
/// # Ok::<(), nanospectra::matter::FluorescenceError>(())
/// ```
///
/// # Accuracy
/// A vest in fluorescent yellow, each on its own white, under FL1 to FL12, the CIE LEDs, D65 and A, against 1
/// nm in f64: 0.03 CIEDE2000 in 60 bins of the default grid, 0.09 in 31, 0.4 in 16; leaving the glow out
/// costs 7 to 18 (`tests/matter/fluorescence.rs`). A grid that ends within the absorption loses what is
/// beyond: 3 % of Y in daylight for a dye that absorbs down to 360 nm, on a grid from 380 nm.
///
/// # Cost
/// At 31 bins light off a dye to XYZ takes 533 instructions on a Cortex-M4F, off a plain surface 378.
pub struct Dye<const N: usize, G = Bins<380, 730>> {
    pub(super) reflects: [f32; N],
    /// What light of 1 per nm adds to the glow.
    pub(super) absorbs: [f32; N],
    /// Per nm, for a glow of 1.
    pub(super) emits: [f32; N],
    /// (A function, so that a dye can be shared between threads whatever `G` is.)
    grid: PhantomData<fn() -> G>,
}

by_fields!([const N: usize, G] Dye<N, G>, "Dye": reflects, absorbs, emits);

/// The reason why numbers do not describe fluorescent matter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum FluorescenceError {
    /// Negative, infinite or not a number.
    OutOfRange {
        /// The bin.
        bin: usize,
    },
    /// Light leaves at shorter waves than it came with.
    AntiStokes {
        /// The bin it came in.
        from: usize,
        /// The bin it leaves in.
        to: usize,
    },
    /// A quantum yield outside 0..=1, or one that is not a number.
    QuantumYield,
    /// The emission is zero everywhere.
    NoEmission,
    /// Light of this bin leaves with more energy than it came with.
    Energy {
        /// The bin.
        bin: usize,
    },
    /// Light of this bin leaves as more photons than it came as.
    Photons {
        /// The bin.
        bin: usize,
    },
}

impl FluorescenceError {
    /// The reason without its numbers, for [`const_unwrap!`](crate::const_unwrap).
    #[must_use]
    pub const fn message(&self) -> &'static str {
        match self {
            Self::OutOfRange { .. } => "a value is negative or not finite",
            Self::AntiStokes { .. } => "light leaves at shorter waves than it came with",
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

/// What rounding may add to a sum that must not exceed 1.
pub(super) const ROUNDING: f64 = 1e-6;

impl<const N: usize, G: Bands> Dye<N, G> {
    /// A dye from what can be measured: the reflectance without the glow, the absorbed share of the light of
    /// each bin (0..=1), the emission (power per nm, in any unit), and the quantum yield (photons emitted for
    /// each absorbed, 0..=1).
    ///
    /// Give them at 1 nm and [`resample`](Self::resample) the result, or fold it. Absorption below the grid,
    /// in the ultraviolet, is lost: optical brighteners need a grid from 300 nm. Computes in f64, for `const`
    /// use.
    ///
    /// # Errors
    /// Values that are negative or not finite, no emission, a yield outside 0..=1; or a bin whose light
    /// leaves with more energy than it came with: reflectance and absorption above 1 together, or long waves
    /// that come back as short ones (at a low yield they may, as the tails of real dyes overlap).
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
        // Photons are power times wavelength: each that is absorbed comes back as one of the emission's mean.
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
            // Power emitted in all for each unit of power absorbed.
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

    /// The same dye on another grid: exact for light that is constant within each of the new bins, and the
    /// emitted energy is kept. Beyond this grid the reflectance is held, and nothing is absorbed or emitted.
    #[must_use]
    pub fn resample<const M: usize, H: Grid>(&self) -> Dye<M, H>
    where
        G: Grid,
    {
        let reflects = Spectrum::<Factor, N, G>::from_bins(self.reflects).resample::<M, H>();
        let emits = Spectrum::<Power, N, G>::from_bins(self.emits).resample::<M, H>();
        // Absorption is a total over each bin: per nm it is an average.
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
    /// The reflectance without the glow.
    #[must_use]
    pub const fn reflectance(&self) -> Spectrum<Factor, N, G> {
        Spectrum::unchecked(self.reflects)
    }

    /// The total power that the dye emits under this light, in units of the light's power per nm times nm.
    #[must_use]
    #[inline]
    pub fn glow_under<S: Stimulus<Power, N, G>>(&self, light: S) -> f32 {
        light.read(|light| self.glow_in(light))
    }

    /// [`Foldable::transposed`] in f64, for `const` use.
    pub(crate) const fn transposed_in_f64(&self, weights: &[f32; N]) -> [f32; N] {
        // How the eye sees the dye's own light.
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
