//! Oklab, the perceptual space of image processing.

use crate::color::Xyz;
use crate::color::matrix::{Matrix, Matrix64, apply, inverse64, rounded};
use crate::math::cbrt;
use crate::tristimulus::shown_by_name;

/// X, Y, Z with Y = 1 for the white, D65, to the cone responses of Oklab.
const TO_CONES: Matrix64 = [
    [0.818_933_010_1, 0.361_866_742_4, -0.128_859_713_7],
    [0.032_984_543_6, 0.929_311_871_5, 0.036_145_638_7],
    [0.048_200_301_8, 0.264_366_269_1, 0.633_851_707_0],
];
/// The cube roots of those to L, a, b.
const TO_OKLAB: Matrix64 = [
    [0.210_454_255_3, 0.793_617_785_0, -0.004_072_046_8],
    [1.977_998_495_1, -2.428_592_205_0, 0.450_593_709_9],
    [0.025_904_037_1, 0.782_771_766_2, -0.808_675_766_0],
];
const CONES: Matrix = rounded(&TO_CONES);
const FROM_CONES: Matrix = rounded(&inverse64(&TO_CONES));
const OKLAB: Matrix = rounded(&TO_OKLAB);
const FROM_OKLAB: Matrix = rounded(&inverse64(&TO_OKLAB));

/// A color in Oklab, whose white is D65.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Oklab {
    /// L, lightness: 0 black, 1 the white.
    pub l: f32,
    /// a, from green (negative) to red; within 0.4 for real colors.
    pub a: f32,
    /// b, from blue (negative) to yellow.
    pub b: f32,
}

shown_by_name!(Oklab: "L" l, "a" a, "b" b);

impl Xyz {
    /// Oklab of a color seen under D65, with Y = 100 for the white.
    ///
    /// NaN stays NaN; components beyond 1e37 in size overflow.
    ///
    /// # Accuracy
    /// 6e-7, and 2e-4 in XYZ for the way there and back (`tests/color/spaces.rs`).
    ///
    /// # Reference
    /// B. Ottosson, "A perceptual color space for image processing", 2020.
    ///
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
    /// L, a, b.
    #[must_use]
    pub const fn new(l: f32, a: f32, b: f32) -> Self {
        Oklab { l, a, b }
    }

    /// The tristimulus values under D65, Y = 100 for the white; components beyond 1e12 in size
    /// overflow.
    #[must_use]
    pub fn xyz(self) -> Xyz {
        let [l, m, s] = apply(&FROM_OKLAB, [self.l, self.a, self.b]);
        Xyz::from(apply(&FROM_CONES, [l * l * l, m * m * m, s * s * s])).scaled(100.0)
    }
}
