//! Who looks, under which white, and what RGB means there.

use crate::color::matrix::{apply, inverse64, rounded};
use crate::color::{Rgb, RgbSpace, Srgb, Xyz, to_xyz64};
use crate::grid::{Bins, Grid};
use crate::observer::Observer;
use crate::spectrum::{Factor, Spectrum};
use core::marker::PhantomData;

/// An eye under the white light of an RGB space: what turns reflectances into RGB.
///
/// (1, 1, 1) is the perfect white surface under exactly this light on exactly this grid: the matrix is made
/// from the primaries of the space and from the sums of the eye's own weights, not from the white point that
/// the standard rounds to four digits. For sRGB, Display P3, BT.2020 and Adobe RGB put the eye under D65,
/// for ACEScg under daylight of 6000 K. What light it is is not checked: under any other one (1, 1, 1) is
/// the white surface there.
///
/// Fold with [`Curve::Step`](crate::Curve::Step), whose weights are not negative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewing<const N: usize, G = Bins<380, 730>, S = Srgb> {
    /// Scaled to Y = 1 for white, as RGB is; so are the matrices.
    pub(super) eye: Observer<3, N, Factor, G>,
    pub(super) to_xyz: [[f32; 3]; 3],
    pub(super) from_xyz: [[f32; 3]; 3],
    space: PhantomData<S>,
}

impl<const N: usize, G: Grid, S: RgbSpace> Viewing<N, G, S> {
    /// From an XYZ observer that has the light folded in (of any scale); for `const` use.
    ///
    /// ```
    /// use nanospectra::color::{DisplayP3, Rgb};
    /// use nanospectra::{Bins, Curve, Reflectance, light::D65, observer::CIE_1931};
    /// use nanospectra::upsample::Viewing;
    /// static VIEWING: Viewing<60, Bins<400, 700>, DisplayP3> = Viewing::new(
    ///     &CIE_1931.under(&D65.fine()).fold(Curve::Step),
    /// );
    /// let gray = VIEWING.rgb(&Reflectance::flat(0.25));
    /// assert!((gray.r - 0.25).abs() < 1e-6 && (gray.g - 0.25).abs() < 1e-6 && (gray.b - 0.25).abs() < 1e-6);
    /// ```
    #[must_use]
    pub const fn new(eye: &Observer<3, N, Factor, G>) -> Self {
        let eye = eye.with_white_y(1.0);
        let [x, y, z] = eye.row_sums();
        let sum = x + y + z;
        let matrix = to_xyz64(&S::PRIMARIES, [x / sum, y / sum]);
        Viewing { eye, to_xyz: rounded(&matrix), from_xyz: rounded(&inverse64(&matrix)), space: PhantomData }
    }

    /// The RGB of a surface; linear.
    ///
    /// # Accuracy
    /// 1e-6 (the sums of `N` products, through the matrix).
    #[must_use]
    pub fn rgb(&self, surface: &Spectrum<Factor, N, G>) -> Rgb<S> {
        let [r, g, b] = apply(&self.from_xyz, self.eye.sees(surface));
        Rgb::new(r, g, b)
    }

    /// The tristimulus values of an RGB, Y = 100 for white.
    #[must_use]
    pub const fn xyz(&self, rgb: Rgb<S>) -> Xyz {
        let [x, y, z] = apply(&self.to_xyz, rgb.to_array());
        Xyz { x, y, z }.scaled(100.0)
    }

    /// The RGB of a color with Y = 100 for white: every method of this module that takes an RGB can upsample
    /// it.
    #[must_use]
    pub const fn rgb_of_xyz(&self, xyz: Xyz) -> Rgb<S> {
        let [r, g, b] = apply(&self.from_xyz, xyz.scaled(0.01).to_array());
        Rgb::new(r, g, b)
    }

    /// CIEDE2000 between a color that was asked for and a surface that should have it.
    ///
    /// NaN if the RGB is.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn delta_e(&self, asked: Rgb<S>, surface: &Spectrum<Factor, N, G>) -> f32 {
        // Both with Y = 1 for white: a difference does not depend on the scale.
        let xyz = |rgb: Rgb<S>| Xyz::from(apply(&self.to_xyz, rgb.to_array()));
        xyz(asked).delta_e(Xyz::from(self.eye.sees(surface)), xyz(Rgb::new(1.0, 1.0, 1.0)))
    }
}
