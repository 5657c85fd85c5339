//! The observer and the white light that give RGB a meaning.

use crate::color::matrix::{apply, inverse64, rounded};
use crate::color::{Rgb, RgbSpace, Srgb, Xyz, to_xyz64};
use crate::grid::{Bins, Grid};
use crate::observer::Observer;
use crate::spectrum::{Factor, Spectrum};
use core::marker::PhantomData;

/// An observer under the white light of an RGB space, which converts reflectances to RGB.
///
/// Make it by [`new`](Self::new) while compiling, and make a [`Sigmoid`](crate::upsample::Sigmoid) or a
/// [`Basis`](crate::upsample::Basis) from it. Call [`rgb`](Self::rgb) to get the RGB of a surface.
///
/// For sRGB, Display P3, BT.2020 and Adobe RGB put the observer under D65, for ProPhoto RGB under D50, for
/// ACEScg and ACES2065-1 under daylight of 6000 K. The light is not checked: RGB (1, 1, 1) is the perfect
/// white surface under the light that you choose. This holds exactly, since the matrix is made from the
/// primaries of the space and from the sums of the observer's own weights on this grid, and not from the
/// white point that the standard rounds to four digits.
///
/// Fold the observer with [`Curve::Step`](crate::Curve::Step), whose weights are not negative, unless another
/// one looks at the spectra: a color is exact for the observer that it was solved for.
///
/// # Example
/// ```
/// use nanospectra::color::{DisplayP3, Rgb};
/// use nanospectra::{Bins, Curve, Reflectance, light::D65, observer::CIE_1931};
/// use nanospectra::upsample::Viewing;
/// static VIEWING: Viewing<60, Bins<400, 700>, DisplayP3> = Viewing::new(
///     &CIE_1931.under(&D65.fine()).fold(Curve::Step),
/// );
/// let gray = VIEWING.rgb(&Reflectance::flat(0.25));
/// assert!((gray.r - 0.25).abs() < 1e-6 && (gray.g - 0.25).abs() < 1e-6 && (gray.b - 0.25).abs() < 1e-6);
/// // White has Y = 100, and back.
/// let white = VIEWING.xyz(Rgb::new(1.0, 1.0, 1.0));
/// assert!((white.y - 100.0).abs() < 1e-4 && (VIEWING.rgb_of_xyz(white).g - 1.0).abs() < 1e-6);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewing<const N: usize, G = Bins<380, 730>, S = Srgb> {
    /// The observer, scaled to Y = 1 for white as RGB is. So are the matrices.
    pub(super) eye: Observer<3, N, Factor, G>,
    pub(super) to_xyz: [[f32; 3]; 3],
    pub(super) from_xyz: [[f32; 3]; 3],
    space: PhantomData<S>,
}

impl<const N: usize, G: Grid, S: RgbSpace> Viewing<N, G, S> {
    /// Makes it from an XYZ observer that has the light folded in, at any scale.
    ///
    /// It computes in f64 and is meant for constants. See the [example](#example).
    #[must_use]
    pub const fn new(eye: &Observer<3, N, Factor, G>) -> Self {
        let eye = eye.with_white_y(1.0);
        let [x, y, z] = eye.row_sums();
        let sum = x + y + z;
        let matrix = to_xyz64(&S::PRIMARIES, [x / sum, y / sum]);
        Viewing { eye, to_xyz: rounded(&matrix), from_xyz: rounded(&inverse64(&matrix)), space: PhantomData }
    }

    /// Returns the linear RGB of a surface under this light. See the [example](#example).
    ///
    /// # Accuracy
    /// Each component is within 1e-6, which is the rounding of the sums of `N` products and of the matrix.
    #[must_use]
    pub fn rgb(&self, surface: &Spectrum<Factor, N, G>) -> Rgb<S> {
        let [r, g, b] = apply(&self.from_xyz, self.eye.sees(surface));
        Rgb::new(r, g, b)
    }

    /// Returns the tristimulus values of a linear RGB, with Y = 100 for white. See the [example](#example).
    #[must_use]
    pub const fn xyz(&self, rgb: Rgb<S>) -> Xyz {
        let [x, y, z] = apply(&self.to_xyz, rgb.to_array());
        Xyz { x, y, z }.scaled(100.0)
    }

    /// Returns the linear RGB of a color that is given with Y = 100 for white.
    ///
    /// Use it to find a spectrum for an XYZ: every method of this module takes an RGB. See the
    /// [example](#example).
    #[must_use]
    pub const fn rgb_of_xyz(&self, xyz: Xyz) -> Rgb<S> {
        let [r, g, b] = apply(&self.from_xyz, xyz.scaled(0.01).to_array());
        Rgb::new(r, g, b)
    }

    /// Returns the color difference CIEDE2000 between a color that was asked for and a surface that should
    /// have it.
    ///
    /// If the RGB is NaN, so is the difference.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn delta_e(&self, asked: Rgb<S>, surface: &Spectrum<Factor, N, G>) -> f32 {
        // Both have Y = 1 for white, since a difference does not depend on the scale.
        let xyz = |rgb: Rgb<S>| Xyz::from(apply(&self.to_xyz, rgb.to_array()));
        xyz(asked).delta_e(Xyz::from(self.eye.sees(surface)), xyz(Rgb::new(1.0, 1.0, 1.0)))
    }
}
