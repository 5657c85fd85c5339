//! Jzazbz, a uniform space for high dynamic range and wide gamut.

use crate::color::Xyz;
use crate::color::matrix::{Matrix, Matrix64, apply, inverse64, product64, rounded};
use crate::color::transfer::Pq;
use crate::math::Math;
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::tristimulus::shown_by_name;

/// From X, Y, Z to X', Y', Z', with b = 1.15 and g = 0.66, which straightens the hues of blue.
const STRAIGHT: Matrix64 = [[1.15, 0.0, -0.15], [0.34, 0.66, 0.0], [0.0, 0.0, 1.0]];
/// From X', Y', Z' to the cone responses.
const LMS: Matrix64 = [
    [0.414_789_72, 0.579_999, 0.014_648],
    [-0.201_51, 1.120_649, 0.053_100_8],
    [-0.016_600_8, 0.2648, 0.668_479_9],
];
/// From the encoded cone responses to Iz, az, bz.
const OPPONENTS: Matrix64 =
    [[0.5, 0.5, 0.0], [3.524, -4.066_708, 0.542_708], [0.199_076, 1.096_799, -1.295_875]];

const CONES: Matrix = rounded(&product64(&LMS, &STRAIGHT));
const FROM_CONES: Matrix = rounded(&inverse64(&product64(&LMS, &STRAIGHT)));
const JZ: Matrix = rounded(&OPPONENTS);
const FROM_JZ: Matrix = rounded(&inverse64(&OPPONENTS));

/// The exponent p, which is 1.7 times that of PQ.
const EXPONENT: f32 = 1.7 * Pq::M2;
/// The factor d of lightness.
const D: f32 = -0.56;
/// Jz of no light before it is subtracted.
const DARK: f32 = 1.629_55e-11;

/// A color that is given in Jzazbz, a uniform space for absolute luminances from starlight to 10 000 cd/m2.
///
/// [`Xyz::jzazbz`] computes it, and [`Jzazbz::xyz`] leads back.
///
/// # Example
/// ```
/// # #[cfg(feature = "libm")] {
/// use nanospectra::color::Xyz;
/// // The example of colour-science 0.4.7, a dark color of 0.122 cd/m2.
/// let color = Xyz::new(0.206_540_08, 0.121_972_25, 0.051_369_52).jzazbz();
/// assert!((color.jz - 0.005_350_5).abs() < 2e-7 && (color.az - 0.009_243_0).abs() < 2e-6);
/// assert!((color.bz - 0.005_260_1).abs() < 2e-6);
/// let back = color.xyz().unwrap();
/// assert!((back.x - 0.20654).abs() < 1e-5 && (back.y - 0.12197).abs() < 1e-5);
/// # }
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Jzazbz {
    /// The lightness Jz, which is 0 for black, 0.167 for a white of 100 and 0.989 for one of 10 000 cd/m2.
    ///
    /// See the [example](Jzazbz#example).
    pub jz: f32,
    /// The coordinate az, which goes from green (negative) to red.
    ///
    /// See the [example](Jzazbz#example).
    pub az: f32,
    /// The coordinate bz, which goes from blue (negative) to yellow.
    ///
    /// See the [example](Jzazbz#example).
    pub bz: f32,
}

shown_by_name!(Jzazbz: "Jz" jz, "az" az, "bz" bz);

impl Xyz {
    /// Converts a color that is seen under D65, in cd/m2, to Jzazbz.
    ///
    /// Y is the luminance in cd/m2, not a share of the white. A cone response below zero, of an imaginary
    /// color, counts as zero. NaN stays NaN. Components beyond 1e36 overflow.
    ///
    /// # Accuracy
    /// 3.5e-7 in Jz and 1.2e-6 in az and bz (searched in `tests/color/worst_conversions.rs`).
    ///
    /// # Cost
    /// On a Cortex-M4F it takes 1040 instructions.
    ///
    /// # Reference
    /// M. Safdar, G. Cui, Y. J. Kim, M. R. Luo, "Perceptually uniform color space for image signals including
    /// high dynamic range and wide gamut", Optics Express 25, 2017.
    ///
    /// # Example
    /// ```
    /// use nanospectra::color::Xyz;
    /// // A white of 100 cd/m2, as colour-science 0.4.7 has it.
    /// let white = Xyz::new(95.047, 100.0, 108.883).jzazbz();
    /// assert!((white.jz - 0.167_17).abs() < 1e-5 && white.az.abs() < 2e-4 && white.bz.abs() < 1e-4);
    /// ```
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn jzazbz(self) -> Jzazbz {
        self.jzazbz_with::<Portable>()
    }

    /// Computes [`Xyz::jzazbz`] by the elementary functions of the math backend `M`.
    #[must_use]
    pub fn jzazbz_with<M: Math>(self) -> Jzazbz {
        let encoded =
            apply(&CONES, self.scaled(1e-4).to_array()).map(|cone| Pq::encode_by::<M>(cone, EXPONENT));
        let [iz, az, bz] = apply(&JZ, encoded);
        Jzazbz { jz: (1.0 + D) * iz / (1.0 + D * iz) - DARK, az, bz }
    }
}

impl Jzazbz {
    /// Makes a color from Jz, az and bz.
    #[must_use]
    pub const fn new(jz: f32, az: f32, bz: f32) -> Self {
        Jzazbz { jz, az, bz }
    }

    /// Converts the color back to tristimulus values in cd/m2.
    ///
    /// The result is `None` where a cone response would have to be infinite. NaN stays NaN. See the
    /// [example](Jzazbz#example).
    ///
    /// # Accuracy
    /// 4e-6 of the luminance of the white there and back (searched in `tests/color/worst_conversions.rs`).
    ///
    /// # Cost
    /// On a Cortex-M4F it takes 1120 instructions.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn xyz(self) -> Option<Xyz> {
        self.xyz_with::<Portable>()
    }

    /// Computes [`Jzazbz::xyz`] by the elementary functions of the math backend `M`.
    #[must_use]
    pub fn xyz_with<M: Math>(self) -> Option<Xyz> {
        let jz = self.jz + DARK;
        let iz = jz / (1.0 + D - D * jz);
        let cones = apply(&FROM_JZ, [iz, self.az, self.bz]).map(|code| Pq::decode_by::<M>(code, EXPONENT));
        if iz.is_infinite() || cones.iter().any(|cone| cone.is_infinite()) {
            return None;
        }
        Some(Xyz::from(apply(&FROM_CONES, cones)).scaled(1e4))
    }
}
