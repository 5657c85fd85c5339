//! Oklab, a perceptual color space for image processing.

use crate::color::Xyz;
use crate::color::matrix::{Matrix, Matrix64, apply, inverse64, rounded};
use crate::math::cbrt;
use crate::tristimulus::shown_by_name;

/// From X, Y, Z, with Y = 1 for the white D65, to the cone responses of Oklab.
const TO_CONES: Matrix64 = [
    [0.818_933_010_1, 0.361_866_742_4, -0.128_859_713_7],
    [0.032_984_543_6, 0.929_311_871_5, 0.036_145_638_7],
    [0.048_200_301_8, 0.264_366_269_1, 0.633_851_707_0],
];
/// From the cube roots of the cone responses to L, a, b.
const TO_OKLAB: Matrix64 = [
    [0.210_454_255_3, 0.793_617_785_0, -0.004_072_046_8],
    [1.977_998_495_1, -2.428_592_205_0, 0.450_593_709_9],
    [0.025_904_037_1, 0.782_771_766_2, -0.808_675_766_0],
];
const CONES: Matrix = rounded(&TO_CONES);
const FROM_CONES: Matrix = rounded(&inverse64(&TO_CONES));
const OKLAB: Matrix = rounded(&TO_OKLAB);
const FROM_OKLAB: Matrix = rounded(&inverse64(&TO_OKLAB));

/// A color in Oklab, a perceptual space that image processing uses and whose white is D65.
///
/// [`Xyz::oklab`] computes it, and [`Oklab::xyz`] leads back.
///
/// # Example
/// ```
/// use nanospectra::color::{Oklab, Xyz};
/// let red = Xyz::new(41.2456, 21.2673, 1.9334).oklab(); // the red of sRGB
/// assert!((red.l - 0.628).abs() < 1e-3 && (red.a - 0.225).abs() < 1e-3 && (red.b - 0.126).abs() < 1e-3);
///
/// let back = Oklab::new(red.l, red.a, red.b).xyz();
/// assert!((back.x - 41.2456).abs() < 1e-3 && (back.y - 21.2673).abs() < 1e-3);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Oklab {
    /// The lightness L, which is 0 for black and 1 for the white.
    ///
    /// See the [example](Oklab#example).
    pub l: f32,
    /// The coordinate a, which goes from green (negative) to red, and is within 0.4 for real colors.
    ///
    /// See the [example](Oklab#example).
    pub a: f32,
    /// The coordinate b, which goes from blue (negative) to yellow.
    ///
    /// See the [example](Oklab#example).
    pub b: f32,
}

shown_by_name!(Oklab: "L" l, "a" a, "b" b);

impl Xyz {
    /// Converts a color that is seen under D65, with Y = 100 for the white, to Oklab.
    ///
    /// Adapt a color that is seen under another white first (see [`Adaptation`](crate::color::Adaptation)).
    /// NaN stays NaN. Components beyond 1e37 in size overflow.
    ///
    /// # Accuracy
    /// 1.1e-6, and 2e-4 in XYZ for the conversion there and back (searched in
    /// `tests/color/worst_conversions.rs`).
    ///
    /// # Reference
    /// B. Ottosson, "A perceptual color space for image processing", 2020.
    ///
    /// # Example
    /// ```
    /// # use nanospectra::color::Xyz;
    /// let white = Xyz::new(95.0, 100.0, 108.9).oklab(); // the author's table: 1.000, 0.000, 0.000
    /// assert!((white.l - 1.0).abs() < 5e-4 && white.a.abs() < 5e-4 && white.b.abs() < 5e-4);
    /// ```
    #[must_use]
    pub fn oklab(self) -> Oklab {
        let [l, m, s] = apply(&CONES, self.scaled(0.01).to_array());
        let [l, a, b] = apply(&OKLAB, [cbrt(l), cbrt(m), cbrt(s)]);
        Oklab { l, a, b }
    }
}

impl Oklab {
    /// Makes a color from L, a and b.
    ///
    /// See the [example](Oklab#example).
    #[must_use]
    pub const fn new(l: f32, a: f32, b: f32) -> Self {
        Oklab { l, a, b }
    }

    /// Converts the color back to tristimulus values under D65, with Y = 100 for the white.
    ///
    /// Components beyond 1e12 in size overflow. See the [example](Oklab#example).
    #[must_use]
    pub fn xyz(self) -> Xyz {
        let [l, m, s] = apply(&FROM_OKLAB, [self.l, self.a, self.b]);
        Xyz::from(apply(&FROM_CONES, [l * l * l, m * m * m, s * s * s])).scaled(100.0)
    }
}
