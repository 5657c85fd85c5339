//! What a solved curve stands for: a reflectance, an unbounded quantity, a light.

use crate::grid::Grid;
use crate::spectrum::{Factor, Power, Spectrum};
use crate::upsample::shape::Shape;

/// A reflectance 0..=1: scale times a curve, or 1 minus that. Four numbers and a bit, 16 bytes as a texel.
///
/// ```
/// use nanospectra::upsample::SigmoidReflectance;
/// let gray = SigmoidReflectance::gray(0.3);
/// assert_eq!((gray.at(400.0), gray.at(700.0)), (0.3, 0.3));
/// assert_eq!(SigmoidReflectance::from_texel(gray.to_texel()), gray);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SigmoidReflectance {
    /// The curve.
    pub shape: Shape,
    /// What it is multiplied with; 0..=1, for grays up to 2 (their curve is 1/2).
    pub scale: f32,
    /// Whether the reflectance is 1 minus scale times the curve, as for bright colors.
    pub complement: bool,
}

/// Scale times a curve, of any size: a density, an emission, a color above 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SigmoidUnbounded {
    /// The curve.
    pub shape: Shape,
    /// What it is multiplied with; twice the largest component of the RGB.
    pub scale: f32,
}

/// A light: scale times a curve times the white light that RGB (1, 1, 1) stands for.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SigmoidIlluminant {
    /// The light over the white one.
    pub factor: SigmoidUnbounded,
}

impl SigmoidReflectance {
    /// The same share at every wavelength, to the bit; black is `gray(0.0)`, white `gray(1.0)`.
    #[must_use]
    pub const fn gray(share: f32) -> Self {
        SigmoidReflectance { shape: Shape { q: [0.0; 3] }, scale: 2.0 * share, complement: false }
    }

    /// The reflectance at a wavelength in nm, 0..=1.
    ///
    /// # Accuracy
    /// 1e-6 relative for dark spectra, down to a reflectance of 1e-7 and below.
    #[must_use]
    #[inline]
    pub fn at(self, nm: f32) -> f32 {
        let (offset, scale) = self.offset_and_scale();
        offset + scale * self.shape.at(nm)
    }

    /// The reflectance on a grid: the value at the center of each bin, which is what the solver solved for.
    ///
    /// # Cost
    /// 0.7 ns a sample for x86-64-v3, 1.5 for the default x86-64; 50 instructions on a Cortex-M4F.
    #[must_use]
    #[inline]
    pub fn on_grid<const N: usize, G: Grid>(self) -> Spectrum<Factor, N, G> {
        let (offset, scale) = self.offset_and_scale();
        Spectrum::from_bins(self.shape.on_grid::<N, G>(offset, scale))
    }

    /// Four numbers, as a texture stores them: q0, q1, q2, and the scale with the bit as its sign. Those of
    /// sRGB fit f16; steep curves of colors out of reach do not.
    #[must_use]
    pub const fn to_texel(self) -> [f32; 4] {
        let [q0, q1, q2] = self.shape.q;
        [q0, q1, q2, if self.complement { -self.scale } else { self.scale }]
    }

    /// From the four numbers of a texture.
    #[must_use]
    pub const fn from_texel([q0, q1, q2, scale]: [f32; 4]) -> Self {
        SigmoidReflectance {
            shape: Shape { q: [q0, q1, q2] },
            scale: scale.abs(),
            complement: scale.is_sign_negative(),
        }
    }

    #[inline(always)]
    fn offset_and_scale(self) -> (f32, f32) {
        if self.complement { (1.0, -self.scale) } else { (0.0, self.scale) }
    }
}

impl SigmoidUnbounded {
    /// The value at a wavelength in nm, zero or more.
    #[must_use]
    #[inline]
    pub fn at(self, nm: f32) -> f32 {
        self.scale * self.shape.at(nm)
    }

    /// The values on a grid. (A factor, but not of passive matter: it may be above 1.)
    #[must_use]
    #[inline]
    pub fn on_grid<const N: usize, G: Grid>(self) -> Spectrum<Factor, N, G> {
        Spectrum::from_bins(self.shape.on_grid::<N, G>(0.0, self.scale))
    }
}

impl SigmoidIlluminant {
    /// The light on a grid, as bright for RGB (1, 1, 1) as `white`, which is the light of the
    /// [`Viewing`](crate::upsample::Viewing) that was solved for.
    #[must_use]
    #[inline]
    pub fn on_grid<const N: usize, G: Grid>(self, white: &Spectrum<Power, N, G>) -> Spectrum<Power, N, G> {
        *white * self.factor.on_grid()
    }
}
