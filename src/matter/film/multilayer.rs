//! Stacks of layers that may absorb, such as mirrors of many films, metal on glass, or oxide on silicon.

use crate::grid::Grid;
use crate::math::Complex;
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::math::{Double, Math};
use crate::matter::PowerShares;
use crate::matter::film::shares::bins;
use crate::matter::film::thin_film::held;
use crate::spectrum::{Factor, Spectrum};

/// A medium of a [`Stack`] at one wavelength, which is described by its complex refractive index n + ik.
///
/// See the [example](Stack#example).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Medium {
    /// The real part of the index, which sets the speed of light in the medium: 1e-3..=1e3.
    pub n: f32,
    /// The extinction coefficient, by which power falls as exp(-4 pi k d / lambda): 0..=1e3.
    pub k: f32,
}

/// A layer of a [`Stack`], described by its medium and its thickness.
///
/// See the [example](Stack#example).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Layer {
    /// The medium that the layer is made of.
    pub medium: Medium,
    /// How thick the layer is, in nm: 0..=1e12.
    pub thickness_nm: f32,
}

/// A stack of `L` layers on a substrate, described by what its media are at one wavelength.
///
/// Fill in the fields and call [`at`](Self::at) for one wavelength, or [`stack_bins`] for spectra; for
/// these, write a function that makes the stack of each wavelength, since media disperse. All layers count as
/// coherent. A plate of millimeters is therefore not a layer: it is the `substrate`, or a filter of its own.
///
/// # Example
///
/// ```
/// # #[cfg(feature = "libm")] {
/// use nanospectra::matter::{Layer, Medium, PowerShares, Stack};
/// // A quarter of a wave of SiO2 on silicon, for red light: nearly none of it comes back.
/// let oxide = Layer { medium: Medium { n: 1.457, k: 0.0 }, thickness_nm: 109.0 };
/// let wafer = Stack { incident: 1.0, layers: [oxide], substrate: Medium { n: 3.88, k: 0.02 } };
/// let shares = PowerShares::mean(wafer.at(633.0, 1.0));
/// assert!(shares.reflected < 0.09 && shares.transmitted > 0.9);
/// # }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stack<const L: usize> {
    /// The refractive index of the medium that the light comes from, which does not absorb: 1e-3..=1e3. See
    /// the [example](#example).
    pub incident: f32,
    /// The layers in the order in which light meets them. See the [example](#example).
    pub layers: [Layer; L],
    /// The medium behind the last layer, which has no end: the light that enters it counts as transmitted.
    pub substrate: Medium,
}

impl Medium {
    fn is_some(self) -> bool {
        (1e-3..=1e3).contains(&self.n) && (0.0..=1e3).contains(&self.k)
    }

    fn square(self) -> Complex {
        Complex::new((self.n - self.k) * (self.n + self.k), 2.0 * self.n * self.k)
    }
}

impl<const L: usize> Stack<L> {
    /// Computes the shares of s and of p polarized light of one wavelength that are reflected, transmitted
    /// and absorbed.
    ///
    /// `nm` 1..=1e9 is the wavelength in vacuum, and `cos_theta` the cosine of the angle of incidence,
    /// clamped to 0..=1. The shares are NaN where an index, a thickness or the wavelength is out of range.
    /// See the [example](#example).
    ///
    /// # Accuracy
    /// 2e-4 absolute for up to eight layers of a wave or two, seen from air at cosines from 0.05: the worst
    /// that a search has found, at sharp resonances. Of 100 000 such stacks drawn at random, none is off by
    /// more than 5e-6. Except at normal incidence thicker layers add some roundings for each turn of phase.
    /// The shares of clear layers add up to 1 within 2e-7, and those of absorbing ones, of any thickness,
    /// within 1e-6 (`tests/matter/films_properties.rs`).
    ///
    /// # Cost
    /// Two exponentials, a sine and a cosine for each layer.
    ///
    /// # Reference
    /// The characteristic matrix: Born and Wolf, Principles of Optics, 1.6.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn at(&self, nm: f32, cos_theta: f32) -> [PowerShares; 2] {
        self.at_with::<Portable>(nm, cos_theta)
    }

    /// Computes the same as [`at`](Self::at), on the math backend `M`.
    #[must_use]
    pub fn at_with<M: Math>(&self, nm: f32, cos_theta: f32) -> [PowerShares; 2] {
        let media = Medium { n: self.incident, k: 0.0 }.is_some() && self.substrate.is_some();
        let layers = self
            .layers
            .iter()
            .all(|layer| layer.medium.is_some() && (0.0..=1e12).contains(&layer.thickness_nm));
        if !(media && layers && (1.0..=1e9).contains(&nm)) || cos_theta.is_nan() {
            return [PowerShares::NAN; 2];
        }
        let cos = held(cos_theta);
        let first = self.incident * cos;
        let across = self.incident * self.incident * (1.0 - cos) * (1.0 + cos);
        let last = tilted(self.substrate, self.incident, first, across);
        // Fields per polarization (s: electric and magnetic; p: the other way round), from the last face
        // upwards.
        let mut waves = [last, last * self.substrate.square().inverse()]
            .map(|end| Wave { fields: [ONE, end], arriving: end.re });
        for layer in self.layers.iter().rev() {
            let tilted = tilted(layer.medium, self.incident, first, across);
            let crossing = Crossing::of::<M>(tilted, layer.thickness_nm, nm);
            for (wave, per_index) in waves.iter_mut().zip([ONE, layer.medium.square()]) {
                wave.rise(&crossing, tilted, per_index);
            }
        }
        let clear = self.layers.iter().all(|layer| layer.medium.k == 0.0);
        let [s, p] = waves;
        [s.shares(first, clear), p.shares(cos / self.incident, clear)]
    }
}

const ONE: Complex = Complex::new(1.0, 0.0);

/// The two tangential fields at a face, up to a common factor.
struct Wave {
    fields: [Complex; 2],
    /// The power that arrives in the substrate, in the units of `fields`.
    arriving: f32,
}

impl Wave {
    /// Carries the fields from below a layer to above it.
    fn rise(&mut self, crossing: &Crossing, tilted: Complex, per_index: Complex) {
        const MINUS_I: Complex = Complex::new(0.0, -1.0);
        let Crossing { cos, sin_over, weakened } = *crossing;
        let [one, other] = self.fields;
        let rises = [
            cos * one + MINUS_I * sin_over * per_index * other,
            cos * other + MINUS_I * sin_over * tilted * tilted * per_index.inverse() * one,
        ];
        // Only the ratio of the fields matters, so they are rescaled: many layers neither overflow nor
        // underflow.
        let size = rises.iter().fold(0.0, |size: f32, field| size.max(field.re.abs()).max(field.im.abs()));
        self.fields = rises.map(|field| field.times(1.0 / size));
        self.arriving *= weakened / size / size;
    }

    /// The shares for light from a medium of admittance `first`; `clear` layers absorb nothing.
    fn shares(&self, first: f32, clear: bool) -> PowerShares {
        let [one, other] = self.fields;
        let all = (one.times(first) + other).power();
        if all == 0.0 {
            // Light grazes the plane between two equal media, which is no boundary.
            return PowerShares::NOTHING;
        }
        let entering = 4.0 * first * (one.re * other.re + one.im * other.im) / all;
        let transmitted = 4.0 * first * self.arriving / all;
        let reflected = (one.times(first) - other).power() / all;
        // A sharp resonance magnifies the rounding of what arrives to as much as 1 %. The shares are
        // therefore divided by their sum, for absorbing layers only where it exceeds 1.
        let both = reflected + transmitted;
        let (whole, absorbed) = if clear { (both, 0.0) } else { (both.max(1.0), entering - transmitted) };
        PowerShares { reflected: reflected / whole, transmitted: transmitted / whole, absorbed }.held()
    }
}

/// n cos(theta) in a medium.
fn tilted(medium: Medium, incident: f32, first: f32, across: f32) -> Complex {
    let Medium { n, k } = medium;
    if k == 0.0 {
        // Where the index is close to that of the first medium, the difference of the indices is more
        // accurate than that of their squares.
        return Complex::new((n - incident) * (n + incident) + first * first, 0.0).sqrt();
    }
    Complex::new((n - k) * (n + k) - across, 2.0 * n * k).sqrt()
}

/// The cosine of the complex phase of one crossing, and its sine over n cos(theta), both weakened as the
/// wave is.
#[derive(Clone, Copy)]
struct Crossing {
    cos: Complex,
    sin_over: Complex,
    /// The factor by which the power of the wave is weakened.
    weakened: f32,
}

impl Crossing {
    fn of<M: Math>(tilted: Complex, thickness_nm: f32, nm: f32) -> Self {
        const TAU: f32 = core::f32::consts::TAU;
        let turns = Double::product(tilted.re, thickness_nm).over(nm).fraction();
        let (sin, cos) = (M::sin_turns(turns), M::cos_turns(turns));
        let length = TAU * (thickness_nm / nm);
        // exp(-2 kappa), which overflows at no thickness, takes the place of cosh and sinh.
        let lost = -M::expm1(-2.0 * tilted.im * length);
        let (sum, difference) = (1.0 - 0.5 * lost, 0.5 * lost);
        let sine = Complex::new(sin * sum, cos * difference);
        let sin_over =
            if tilted.power() == 0.0 { Complex::new(length, 0.0) } else { sine * tilted.inverse() };
        Crossing {
            cos: Complex::new(cos * sum, -sin * difference),
            sin_over,
            weakened: M::exp(-2.0 * tilted.im * length),
        }
    }
}

/// Computes the mean over each bin of one share of a [`Stack`], such as its reflectance, for s and for p
/// polarized light.
///
/// `stack` makes the stack of a wavelength in nm, `cos_theta` is as in [`Stack::at`], and `share` picks the
/// share (`|shares| shares.reflected`). Each bin is divided into `panels` pieces that are read at three
/// points each. Take at least one panel for each fringe within a bin, and more where resonances are sharper
/// than a fringe.
///
/// # Accuracy
/// Ten panels for each fringe (counted by twice the sum of index times thickness over the wavelength) hold the
/// mean within 2.5e-6 if indices are 1.3 to 2.4 and cosines at least 0.5, as in coatings of glass. For four
/// layers of up to 1 um with indices of 1 to 4, seen at cosines from 0.05, ten may be off by 0.03, and a
/// hundred by 7e-6 (searched in `tests/matter/worst_layers.rs`).
///
/// # Cost
/// On a Cortex-M4F two layers on 31 bands take 760 bytes of stack at opt-level 3, and 900 at "s".
///
/// # Example
///
/// ```
/// use nanospectra::matter::{Layer, Medium, Stack, stack_bins};
/// use nanospectra::{Bins, Spectrum};
/// let wafer = |nm: f32| Stack {
///     incident: 1.0,
///     layers: [Layer { medium: Medium { n: 1.448 + 3500.0 / (nm * nm), k: 0.0 }, thickness_nm: 300.0 }],
///     substrate: Medium { n: 3.9, k: 0.02 },
/// };
/// let [s, p] = stack_bins::<1, 31, Bins<380, 730>>(wafer, 1.0, 1, |shares| shares.reflected);
/// assert!((s.values()[15] - p.values()[15]).abs() < 1e-6);
/// ```
#[cfg(feature = "libm")]
#[must_use]
pub fn stack_bins<const L: usize, const N: usize, G: Grid>(
    stack: impl Fn(f32) -> Stack<L>,
    cos_theta: f32,
    panels: u16,
    share: impl Fn(PowerShares) -> f32,
) -> [Spectrum<Factor, N, G>; 2] {
    stack_bins_with::<Portable, L, N, G>(stack, cos_theta, panels, share)
}

/// Computes the mean over each bin of one share of a [`Stack`], on the math backend `M`.
///
/// [`stack_bins`] does the same without naming a backend; see the [example](stack_bins#example) there.
#[must_use]
pub fn stack_bins_with<M: Math, const L: usize, const N: usize, G: Grid>(
    stack: impl Fn(f32) -> Stack<L>,
    cos_theta: f32,
    panels: u16,
    share: impl Fn(PowerShares) -> f32,
) -> [Spectrum<Factor, N, G>; 2] {
    bins(|low_nm, high_nm| {
        let panels = u32::from(panels.max(1));
        PowerShares::averaged(low_nm, high_nm, panels, |nm| stack(nm).at_with::<M>(nm, cos_theta)).map(&share)
    })
}
