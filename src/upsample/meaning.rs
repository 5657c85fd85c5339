//! What a solved curve stands for: a reflectance, an unbounded quantity or a light.

use crate::grid::Grid;
use crate::spectrum::{Factor, Power, Spectrum};
use crate::upsample::shape::Shape;

/// The reflectance of a surface as [`Sigmoid`](crate::upsample::Sigmoid) finds it: a smooth curve times a
/// scale, or 1 minus that.
///
/// It can be read at any wavelength or [on a grid](Self::on_grid), and is stored as
/// [four numbers](Self::to_texel) in a texture.
///
/// # Example
/// ```
/// use nanospectra::upsample::SigmoidReflectance;
/// let gray = SigmoidReflectance::gray(0.3);
/// assert_eq!((gray.at(400.0), gray.at(700.0)), (0.3, 0.3));
/// assert_eq!(SigmoidReflectance::from_texel(gray.to_texel()), gray);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SigmoidReflectance {
    /// The smooth curve, whose values lie within 0..=1.
    pub shape: Shape,
    /// The factor by which the curve is multiplied: 0..=1, or for grays, whose curve is 1/2, up to 2.
    pub scale: f32,
    /// Whether the reflectance is 1 minus scale times the curve, as it is for bright colors.
    pub complement: bool,
}

/// A smooth curve times a scale of any size, which describes a density, an emission or a color above 1.
///
/// [`Sigmoid::unbounded`](crate::upsample::Sigmoid::unbounded) returns it.
///
/// # Example
/// ```
/// use nanospectra::upsample::{Shape, SigmoidUnbounded};
/// // The flat curve is 1/2 everywhere.
/// let bright = SigmoidUnbounded { shape: Shape::default(), scale: 5.0 };
/// assert_eq!(bright.at(550.0), 2.5);
/// assert_eq!(bright.on_grid::<31, nanospectra::Nodes<400, 700>>().values()[0], 2.5);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SigmoidUnbounded {
    /// The smooth curve, whose values lie within 0..=1.
    pub shape: Shape,
    /// The factor by which the curve is multiplied: twice the largest component of the RGB.
    pub scale: f32,
}

/// A light as [`Sigmoid`](crate::upsample::Sigmoid) finds it: a smooth curve times a scale, times the white
/// light that RGB (1, 1, 1) stands for.
///
/// [`Sigmoid::illuminant`](crate::upsample::Sigmoid::illuminant) returns it, and [`on_grid`](Self::on_grid)
/// multiplies it by the white.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SigmoidIlluminant {
    /// The factor for each wavelength by which the white light is multiplied.
    pub factor: SigmoidUnbounded,
}

impl SigmoidReflectance {
    /// Returns the reflectance on a grid, with the value at the center of each bin, which is what the solver
    /// solved for.
    ///
    /// See the [example](crate::upsample#example) of the module.
    ///
    /// # Cost
    /// A sample takes 0.7 ns for x86-64-v3, 1.5 ns for the default x86-64 target, and 50 instructions on a
    /// Cortex-M4F.
    #[must_use]
    #[inline]
    pub fn on_grid<const N: usize, G: Grid>(self) -> Spectrum<Factor, N, G> {
        let (offset, scale) = self.offset_and_scale();
        Spectrum::from_bins(self.shape.on_grid::<N, G>(offset, scale))
    }

    /// Returns the reflectance at a wavelength in nm, which lies within 0..=1. See the [example](#example).
    ///
    /// # Accuracy
    /// The value is within 3.5e-7 (1 + t), relative, also for dark spectra, down to a reflectance of 1e-7 and
    /// below. Here t is the sum of the sizes of the three terms of the quadratic; of a complement the error
    /// is as large in absolute terms (searched in `tests/upsample/worst_reflectances.rs`). For spectra of
    /// dark colors of sRGB this makes 1e-6.
    #[must_use]
    #[inline]
    pub fn at(self, nm: f32) -> f32 {
        let (offset, scale) = self.offset_and_scale();
        offset + scale * self.shape.at(nm)
    }

    /// Returns four numbers for a texture, from which [`from_texel`](Self::from_texel) makes the reflectance
    /// again.
    ///
    /// They are q0, q1 and q2 of the [`Shape`], and the scale, which is negative for a
    /// [complement](Self::complement). Those of sRGB colors fit f16. Steep curves of colors out of reach do
    /// not. See the [example](#example).
    #[must_use]
    pub const fn to_texel(self) -> [f32; 4] {
        let [q0, q1, q2] = self.shape.q;
        [q0, q1, q2, if self.complement { -self.scale } else { self.scale }]
    }

    /// Makes a reflectance from the four numbers that [`to_texel`](Self::to_texel) has returned.
    ///
    /// See the [example](#example).
    #[must_use]
    pub const fn from_texel([q0, q1, q2, scale]: [f32; 4]) -> Self {
        SigmoidReflectance {
            shape: Shape { q: [q0, q1, q2] },
            scale: scale.abs(),
            complement: scale.is_sign_negative(),
        }
    }

    /// Returns a gray, which reflects the same share at every wavelength, to the bit.
    ///
    /// Black is `gray(0.0)`, and white is `gray(1.0)`. See the [example](#example).
    #[must_use]
    pub const fn gray(share: f32) -> Self {
        SigmoidReflectance { shape: Shape { q: [0.0; 3] }, scale: 2.0 * share, complement: false }
    }

    /// Returns the reflectance that is a sigmoid itself.
    pub(super) const fn of(q: [f32; 3]) -> Self {
        SigmoidReflectance { shape: Shape { q }, scale: 1.0, complement: false }
    }

    #[inline(always)]
    fn offset_and_scale(self) -> (f32, f32) {
        if self.complement { (1.0, -self.scale) } else { (0.0, self.scale) }
    }
}

impl SigmoidUnbounded {
    /// Returns the values on a grid as factors, which may be above 1 although no surface reflects more than
    /// all light.
    ///
    /// See the [example](#example).
    #[must_use]
    #[inline]
    pub fn on_grid<const N: usize, G: Grid>(self) -> Spectrum<Factor, N, G> {
        Spectrum::from_bins(self.shape.on_grid::<N, G>(0.0, self.scale))
    }

    /// Returns the value at a wavelength in nm, which is zero or more. See the [example](#example).
    #[must_use]
    #[inline]
    pub fn at(self, nm: f32) -> f32 {
        self.scale * self.shape.at(nm)
    }
}

impl SigmoidIlluminant {
    /// Returns the light on a grid, where `white` is the light of the [`Viewing`](crate::upsample::Viewing)
    /// that was solved for.
    ///
    /// For RGB (1, 1, 1) the result is `white`.
    #[must_use]
    #[inline]
    pub fn on_grid<const N: usize, G: Grid>(self, white: &Spectrum<Power, N, G>) -> Spectrum<Power, N, G> {
        *white * self.factor.on_grid()
    }
}
