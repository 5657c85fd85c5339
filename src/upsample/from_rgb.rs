//! From a color to a spectrum by one call, under the name that red, green and blue have it by too.

use crate::color::matrix::{Matrix64, apply64, inverse64};
use crate::color::{Rgb, RgbBands, RgbSpace};
use crate::grid::{Bands, Grid};
use crate::light::{S0, S1, S2};
use crate::math::const_for;
use crate::observer::Observer;
use crate::spectrum::{Factor, Interpolation, Outside, Power, Spectrum};
use crate::upsample::{Sigmoid, Viewing};
use core::marker::PhantomData;

/// What the compiler works out for a grid and an RGB space.
struct Made<const N: usize, G, S>(PhantomData<(G, S)>);

impl<const N: usize, G: Grid, S: RgbSpace> Made<N, G, S> {
    const EYE: Observer<3, N, Power, G> = Observer::<3, N, Power, G>::standard();

    /// The white of the space, Y = 100: the sum of the CIE's three components of daylight that has its
    /// chromaticity for this eye on this grid. For the whites that are daylight it is that phase of daylight.
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

/// What can be made from a color of the space `S`: surfaces and lights in [`RgbBands`] of that space, or on
/// any [`Grid`].
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not made from a color of `{S}`",
    note = "a `Light` or a `Reflectance` on a grid is made from any RGB, one in `RgbBands<S>` from `Rgb<S>`"
)]
pub trait FromRgb<S> {
    /// See [`Spectrum::from_rgb`].
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
    /// A light of this color, or a surface of this color under the white of the space; linear RGB. One name
    /// for spectra and for RGB: code behind one alias compiles for both.
    ///
    /// * In [`RgbBands`] these are the three numbers.
    /// * A reflectance on a grid is what [`Sigmoid::reflectance`] finds: smooth, within 0..=1, and of this
    ///   color for [`Observer::standard`] on this grid.
    /// * A light on a grid is [`Sigmoid::illuminant`] times the white of the space, which is (1, 1, 1) and
    ///   has Y = 100: the daylight (a sum of the CIE's three components) of the chromaticity of the space.
    ///   Components may be above 1.
    ///
    /// # Accuracy
    /// The color is the same for both, within 3e-4 CIEDE2000 for every color that a sigmoid can have (all of
    /// sRGB are), on grids of 6 bands or more that cover 400..=700 nm. What none has becomes the nearest by
    /// least squares, and a surface brighter than white becomes white: [`Sigmoid`] by itself says so, by a
    /// [`Status`](crate::upsample::Status). On a grid NaN, infinities and a light above 1.7e38 give NaN.
    /// After further surfaces and under other lights the spectrum is what a smooth paint can be, and RGB is
    /// off by what [`RgbBands`] says.
    ///
    /// # Cost
    /// Nothing for RGB. On a grid about 0.5 us on x86-64 at N = 31, and `20 N + 48` bytes of constants for
    /// each grid and space: for the colors of a scene, when it is built.
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
