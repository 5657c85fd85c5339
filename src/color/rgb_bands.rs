//! Light and surfaces as three numbers, red, green and blue, in place of spectra.

use crate::color::{Rgb, RgbSpace};
use crate::grid::{Bands, Kind};
use crate::math::const_for;
use crate::observer::StandardObserver;
use crate::spectrum::Spectrum;
use core::marker::PhantomData;

/// Three bands, red, green and blue of the space `S`, which a renderer may use in place of a wavelength
/// [`Grid`](crate::Grid).
///
/// Light of the type `Light<3, RgbBands<S>>` and surfaces of the type `Reflectance<3, RgbBands<S>>` go
/// through the same arithmetic, BRDFs, radiometry and paths as spectra. Make them by
/// [`from_rgb`](crate::Spectrum::from_rgb) and look at them with
/// [`Observer::standard`](crate::Observer::standard). Both exist under the same names for spectra, so that
/// one type alias decides whether a program computes in RGB or in spectra.
///
/// `RgbBands` are [`Bands`] but not a grid: no wavelengths belong to the three numbers. Therefore measured
/// samples, spectral lines, glass, films and dyes are not available for them.
///
/// # Accuracy
/// The product of two colors is not the color of the product of two spectra. The 99 samples of CIE 224 under
/// FL1 to FL12, each sample as its color under D65 and each lamp as its color, are off by 4.6 CIEDE2000 in
/// the mean and by up to 18.8 in sRGB, by 3.8 and up to 12.3 in ACEScg (`tests/path/chain.rs`).
///
/// # Example
/// ```
/// use nanospectra::color::{Rgb, RgbBands, Srgb};
/// use nanospectra::{Light, Observer, Power, Reflectance};
///
/// static EYE: Observer<3, 3, Power, RgbBands<Srgb>> = Observer::standard();
/// let lamp = Light::<3, RgbBands<Srgb>>::from_rgb(Rgb::new(1.0, 1.0, 1.0));
/// let red = Reflectance::from_rgb(Rgb::new(0.5, 0.0, 0.0));
/// assert_eq!(red.to_rgb(), Rgb::new(0.5, 0.0, 0.0));
/// // Red has 21.26 % of the luminance of white in sRGB, and half of it is reflected.
/// let [_, y, _] = EYE.sees(lamp.onto(&red));
/// assert!((y - 50.0 * 0.2126).abs() < 1e-2);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct RgbBands<S>(PhantomData<S>);

impl<S: RgbSpace> Bands for RgbBands<S> {
    const KIND: Kind = Kind::Colors(3);
}

impl<S: RgbSpace> StandardObserver<3> for RgbBands<S> {
    const STANDARD: [[f32; 3]; 3] = {
        let mut rows = S::TO_XYZ;
        const_for!(0..3, |row| {
            const_for!(0..3, |k| rows[row][k] *= 100.0);
        });
        rows
    };
}

impl<Q, S: RgbSpace> Spectrum<Q, 3, RgbBands<S>> {
    /// Returns the three numbers as a linear RGB color.
    ///
    /// See the [example](crate::color::RgbBands#example).
    #[must_use]
    #[inline]
    pub const fn to_rgb(&self) -> Rgb<S> {
        let [r, g, b] = self.0;
        Rgb::new(r, g, b)
    }
}
