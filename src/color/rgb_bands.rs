//! Light and surfaces as RGB: three bands, and what that costs in accuracy.

use crate::color::{Rgb, RgbSpace};
use crate::grid::{Bands, Kind};
use crate::math::const_for;
use crate::observer::StandardObserver;
use crate::spectrum::Spectrum;
use core::marker::PhantomData;

/// Red, green and blue of the space `S` in place of a [`Grid`](crate::Grid): light `Light<3, RgbBands<S>>`
/// and surfaces `Reflectance<3, RgbBands<S>>` go through the same arithmetic, BRDFs, radiometry and paths as
/// spectra.
///
/// They are [`Bands`], and no grid: no wavelengths belong to the three numbers, so samples, lines, glass,
/// films and dyes are not to be had. [`from_rgb`](crate::Spectrum::from_rgb) and
/// [`Observer::standard`](crate::Observer::standard) have the same names for spectra, so that one alias
/// decides what a program computes with.
///
/// # Accuracy
/// Products of colors are not colors of products. The 99 samples of CIE 224 under FL1 to FL12, each sample as
/// its color under D65 and each lamp as its color, are off by 4.6 CIEDE2000 in the mean and by up to 18.8 in
/// sRGB, by 3.8 and up to 12.3 in ACEScg (`tests/path/chain.rs`).
///
/// ```
/// use nanospectra::color::{Rgb, RgbBands, Srgb};
/// use nanospectra::{Light, Observer, Power, Reflectance};
///
/// static EYE: Observer<3, 3, Power, RgbBands<Srgb>> = Observer::standard();
/// let lamp = Light::<3, RgbBands<Srgb>>::from_rgb(Rgb::new(1.0, 1.0, 1.0));
/// let red = Reflectance::from_rgb(Rgb::new(0.5, 0.0, 0.0));
/// let [_, y, _] = EYE.sees(lamp.onto(&red));
/// assert!((y - 50.0 * 0.2126).abs() < 1e-2); // half of what sRGB's red has of white's luminance
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
    /// The three numbers as a linear color.
    #[must_use]
    #[inline]
    pub const fn to_rgb(&self) -> Rgb<S> {
        let [r, g, b] = self.0;
        Rgb::new(r, g, b)
    }
}
