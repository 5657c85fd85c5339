//! Light and surfaces as RGB: three bands, and what that costs in accuracy.

use crate::color::{Rgb, RgbSpace};
use crate::observer::Observer;
use crate::spectrum::{Power, Spectrum};
use core::marker::PhantomData;

/// Red, green and blue of the space `S` in place of a [`Grid`](crate::Grid): light `Light<3, RgbBands<S>>` and
/// surfaces `Reflectance<3, RgbBands<S>>` go through the same paths as spectra.
///
/// It is no grid: no wavelengths belong to the three numbers, so samples, lines and resampling are not to be had.
///
/// # Accuracy
/// Products of colors are not colors of products. The 99 samples of CIE 224 under FL1 to FL12, each sample as its
/// color under D65 and each lamp as its color, are off by 4.6 CIEDE2000 in the mean and by up to 18.8 in sRGB, by 3.8
/// and up to 12.3 in ACEScg (`tests/path/chain.rs`).
///
/// ```
/// use nanospectra::color::{Rgb, Srgb};
/// use nanospectra::path::RgbBands;
/// use nanospectra::{Light, Observer, Power, Reflectance};
///
/// static EYE: Observer<3, 3, Power, RgbBands<Srgb>> = Observer::of_rgb();
/// let lamp = Light::<3, RgbBands<Srgb>>::from_rgb(Rgb::new(1.0, 1.0, 1.0));
/// let red = Reflectance::from_rgb(Rgb::new(0.5, 0.0, 0.0));
/// let [_, y, _] = EYE.sees(lamp.onto(&red));
/// assert!((y - 50.0 * 0.2126).abs() < 1e-2); // half of what sRGB's red has of white's luminance
/// ```
#[derive(Clone, Copy, Debug)]
pub struct RgbBands<S>(PhantomData<S>);

impl<Q, S: RgbSpace> Spectrum<Q, 3, RgbBands<S>> {
    /// The color of a light, or that of a surface under the white of the space; linear.
    #[must_use]
    pub const fn from_rgb(rgb: Rgb<S>) -> Self {
        Spectrum::unchecked(rgb.to_array())
    }

    /// As a color; linear.
    #[must_use]
    pub const fn to_rgb(&self) -> Rgb<S> {
        let [r, g, b] = self.0;
        Rgb::new(r, g, b)
    }
}

impl<S: RgbSpace> Observer<3, 3, Power, RgbBands<S>> {
    /// The eye that reads RGB as XYZ, Y = 100 for (1, 1, 1): the matrix of the space.
    #[must_use]
    pub const fn of_rgb() -> Self {
        let mut rows = S::TO_XYZ;
        let mut row = 0;
        while row < 3 {
            let mut k = 0;
            while k < 3 {
                rows[row][k] *= 100.0;
                k += 1;
            }
            row += 1;
        }
        Observer::unchecked(rows)
    }
}
