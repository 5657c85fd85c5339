//! `Spectrum::from_rgb`, which makes a spectrum of a color by one call, on a grid or in RGB bands.

use crate::color::matrix::{Matrix64, apply64, inverse64};
use crate::color::{Rgb, RgbBands, RgbSpace};
use crate::grid::{Bands, Grid};
use crate::light::{S0, S1, S2};
use crate::math::const_for;
use crate::observer::Observer;
use crate::spectrum::{Factor, Interpolation, Outside, Power, Spectrum};
use crate::upsample::{Sigmoid, Viewing};
use core::marker::PhantomData;

/// The constants that the compiler computes for a grid and an RGB space.
struct Made<const N: usize, G, S>(PhantomData<(G, S)>);

impl<const N: usize, G: Grid, S: RgbSpace> Made<N, G, S> {
    const EYE: Observer<3, N, Power, G> = Observer::<3, N, Power, G>::standard();

    /// The white of the space with Y = 100: the sum of the CIE's three components of daylight that has the
    /// chromaticity of the white for this observer on this grid. If the white of the space is a phase of
    /// daylight, it is that phase.
    const WHITE: Spectrum<Power, N, G> = {
        let parts: [Spectrum<Power, N, G>; 3] = [
            S0.interpolate_outside(Interpolation::Linear, Outside::Hold),
            S1.interpolate_outside(Interpolation::Linear, Outside::Hold),
            S2.interpolate_outside(Interpolation::Linear, Outside::Hold),
        ];
        let mut seen: Matrix64 = [[0.0; 3]; 3];
        const_for!(0..3, |part| {
            let xyz = Self::EYE.under(&parts[part]).row_sums();
            (seen[0][part], seen[1][part], seen[2][part]) = (xyz[0], xyz[1], xyz[2]);
        });
        let [x, y] = S::WHITE;
        let amounts = apply64(&inverse64(&seen), [100.0 * x / y, 100.0, 100.0 * (1.0 - x - y) / y]);
        let mut values = [0.0; N];
        const_for!(0..N, |k| {
            let [a, b, c] = [parts[0].0[k] as f64, parts[1].0[k] as f64, parts[2].0[k] as f64];
            values[k] = (amounts[0] * a + amounts[1] * b + amounts[2] * c) as f32;
        });
        Spectrum::from_bins(values)
    };

    const SIGMOID: Sigmoid<N, G, S> = Sigmoid::new(&Viewing::new(&Self::EYE.under(&Self::WHITE)));
}

/// Spectra that can be made from a color of the RGB space `S`.
///
/// These are surfaces and lights on any [`Grid`], and those in [`RgbBands`] of that space. Call
/// [`Spectrum::from_rgb`] rather than this trait's function; see its [example](Spectrum::from_rgb).
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not made from a color of `{S}`",
    note = "a `Light` or a `Reflectance` on a grid is made from any RGB, one in `RgbBands<S>` from `Rgb<S>`"
)]
pub trait FromRgb<S> {
    /// Returns a spectrum that has this color, as [`Spectrum::from_rgb`] describes.
    fn from_rgb(rgb: Rgb<S>) -> Self;
}

impl<Q, S: RgbSpace> FromRgb<S> for Spectrum<Q, 3, RgbBands<S>> {
    #[inline]
    fn from_rgb(rgb: Rgb<S>) -> Self {
        Spectrum::from_bins(rgb.to_array())
    }
}

impl<const N: usize, G: Grid, S: RgbSpace> FromRgb<S> for Spectrum<Factor, N, G> {
    fn from_rgb(rgb: Rgb<S>) -> Self {
        const { &Made::<N, G, S>::SIGMOID }.reflectance(rgb).spectrum.on_grid()
    }
}

impl<const N: usize, G: Grid, S: RgbSpace> FromRgb<S> for Spectrum<Power, N, G> {
    fn from_rgb(rgb: Rgb<S>) -> Self {
        let light = const { &Made::<N, G, S>::SIGMOID }.illuminant(rgb);
        light.spectrum.on_grid(const { &Made::<N, G, S>::WHITE })
    }
}

impl<Q, const N: usize, G: Bands> Spectrum<Q, N, G> {
    /// Makes a light that has this color, or a surface that has it under the white of the RGB space.
    ///
    /// `rgb` is linear. The function has the same name for a grid and for [`RgbBands`], so that code that is
    /// written for an alias compiles for both.
    ///
    /// * In [`RgbBands`] the values are the three components.
    /// * A reflectance on a grid is the one that [`Sigmoid::reflectance`] finds: smooth, within 0..=1, and of
    ///   this color for [`Observer::standard`] on this grid.
    /// * A light on a grid is [`Sigmoid::illuminant`] times the white of the space. That white stands for
    ///   RGB (1, 1, 1) and has Y = 100. It is daylight (a sum of the CIE's three components) with the
    ///   chromaticity that the space defines. Components of the light may be above 1.
    ///
    /// # Accuracy
    /// On grids of 31 bands or more that cover 400..=700 nm, the color is within 3e-4 CIEDE2000 of that in
    /// [`RgbBands`], for every color that a sigmoid can have; on fewer bands, but at least 6, it can be a few
    /// times as far off. From 16 bands on a sigmoid can have all colors of sRGB. Any other color is replaced
    /// by the nearest one in the sense of CIEDE2000, and a surface brighter than white becomes white.
    /// Call [`Sigmoid`] yourself to be told by a [`Status`](crate::upsample::Status). An observer that is
    /// folded by another curve than [`Observer::standard`] sees another color, most of all on few bands. On a
    /// grid NaN, infinities and a light above 1.7e38 give NaN. After further surfaces and under other lights
    /// the spectrum behaves as a smooth paint does, and [`RgbBands`] says by how much RGB is off.
    ///
    /// # Cost
    /// In RGB bands it costs nothing. On a grid it takes about 0.5 us on x86-64 at N = 31, and `20 N + 48`
    /// bytes of constants for each grid and space. Call it when a scene is built and not for each ray. On a
    /// Cortex-M4F a reflectance of 31 bands takes 1,380 bytes of stack at opt-level 3, and 1,950 at "s".
    ///
    /// ```
    /// use nanospectra::color::{Rgb, RgbBands, Srgb};
    /// use nanospectra::{Light, Observer, Power, Reflectance};
    /// static EYE: Observer<3, 31, Power> = Observer::standard();
    /// static EYE_OF_RGB: Observer<3, 3, Power, RgbBands<Srgb>> = Observer::standard();
    ///
    /// let (white, red) = (Rgb::<Srgb>::new(1.0, 1.0, 1.0), Rgb::new(0.5, 0.1, 0.1));
    /// let [x, y, z] = EYE.sees(Light::from_rgb(white).onto(&Reflectance::from_rgb(red)));
    /// let of_rgb = EYE_OF_RGB.sees(Light::from_rgb(white).onto(&Reflectance::from_rgb(red)));
    /// assert!((x - of_rgb[0]).abs() < 1e-2 && (y - of_rgb[1]).abs() < 1e-2 && (z - of_rgb[2]).abs() < 1e-2);
    /// ```
    #[must_use]
    #[inline]
    pub fn from_rgb<S>(rgb: Rgb<S>) -> Self
    where
        Self: FromRgb<S>,
    {
        FromRgb::from_rgb(rgb)
    }
}
