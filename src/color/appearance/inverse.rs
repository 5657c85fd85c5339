//! From what is seen back to tristimulus values.

use crate::color::appearance::conditions::eccentricity;
use crate::color::appearance::{Appearance, AppearanceModel, CamUcs, ViewingConditions};
use crate::color::matrix::{apply, inverse64, product64, rounded};
use crate::color::{ConeResponses, Xyz};
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::math::{Math, cos_turns, sin_turns, sqrt};

impl<A: AppearanceModel> ViewingConditions<A> {
    /// Computes the color that has this lightness, chroma and hue; the other attributes are not read.
    ///
    /// The color is on the scale of the white. The result is `None` if no color has these attributes: if J or
    /// C is below zero, if a black has chroma, or if a response would have to be beyond the largest that
    /// there is. NaN stays NaN.
    ///
    /// # Accuracy
    /// XYZ comes back within 3e-4 of 100 (`tests/color/appearance.rs`).
    ///
    /// # Cost
    /// On a Cortex-M4F it takes 1460 instructions by CAM16 and 1480 by CIECAM02.
    ///
    /// # Example
    /// ```
    /// # #[cfg(feature = "libm")] {
    /// use nanospectra::color::{Appearance, Cam16, Surround, ViewingConditions, Xyz};
    /// let white = Xyz::new(95.05, 100.0, 108.88);
    /// let seen = ViewingConditions::<Cam16>::new(white, 318.31, 20.0, Surround::Average).unwrap();
    /// // The example of colour-science 0.4.7, backward.
    /// let color = Appearance { j: 41.731_207, c: 0.103_355_74, h_deg: 217.067_96, ..Appearance::default() };
    /// let xyz = seen.xyz(color).unwrap();
    /// assert!((xyz.x - 19.01).abs() < 1e-3 && (xyz.y - 20.0).abs() < 1e-3 && (xyz.z - 21.78).abs() < 1e-3);
    /// # }
    /// ```
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn xyz(&self, seen: Appearance) -> Option<Xyz> {
        self.xyz_with::<Portable>(seen)
    }

    /// Computes [`xyz`](Self::xyz) by the elementary functions of the math backend `M`.
    #[must_use]
    pub fn xyz_with<M: Math>(&self, seen: Appearance) -> Option<Xyz> {
        let turns = seen.h_deg / 360.0;
        self.unseen::<M>(seen.j, seen.c, [cos_turns(turns), sin_turns(turns)])
    }

    /// Computes the color that has this place in the uniform space of the model.
    ///
    /// The result is `None` as in [`xyz`](Self::xyz), and from J' = 242.8 on, which no lightness has. See the
    /// [example](CamUcs#example).
    ///
    /// # Accuracy
    /// As [`xyz`](Self::xyz).
    ///
    /// # Cost
    /// On a Cortex-M4F it takes 1500 instructions by CAM16 and 1520 by CIECAM02.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn xyz_of_ucs(&self, color: CamUcs) -> Option<Xyz> {
        self.xyz_of_ucs_with::<Portable>(color)
    }

    /// Computes [`xyz_of_ucs`](Self::xyz_of_ucs) by the elementary functions of the math backend `M`.
    #[must_use]
    pub fn xyz_of_ucs_with<M: Math>(&self, color: CamUcs) -> Option<Xyz> {
        let left = 1.7 - 0.007 * color.j;
        if left <= 0.0 {
            return None;
        }
        let m = sqrt(color.a * color.a + color.b * color.b);
        let chroma = M::expm1(0.0228 * m) / 0.0228 / self.colorfulness;
        let direction = if m == 0.0 { [1.0, 0.0] } else { [color.a / m, color.b / m] };
        self.unseen::<M>(color.j / left, chroma, direction)
    }

    fn unseen<M: Math>(&self, lightness: f32, chroma: f32, [cos, sin]: [f32; 2]) -> Option<Xyz> {
        if lightness < 0.0 || chroma < 0.0 || (lightness == 0.0 && chroma > 0.0) {
            return None;
        }
        if lightness == 0.0 {
            return Some(Xyz::default());
        }
        let share = lightness / 100.0;
        let t = M::powf(chroma / (sqrt(share) * self.chroma), 1.0 / 0.9);
        // 2 r + g + b / 20 without the 0.305 that the responses to black add up to.
        let achromatic = self.achromatic_white * M::powf(share, 1.0 / self.exponent) / self.contrast;
        let below = 23.0 * self.induction * eccentricity(cos, sin) / t + (11.0 * cos + 108.0 * sin);
        let size = 23.0 * (achromatic + 0.305) / below;
        // Responses within 400 cannot add up to more.
        if achromatic > 1220.0 || below <= 0.0 {
            return None;
        }
        let (a, b) = (size * cos, size * sin);
        let responses = [
            (460.0 * achromatic + 451.0 * a + 288.0 * b) / 1403.0,
            (460.0 * achromatic - 891.0 * a - 261.0 * b) / 1403.0,
            (460.0 * achromatic - 220.0 * a - 6300.0 * b) / 1403.0,
        ];
        if responses.iter().any(|response| response.abs() >= 400.0) {
            return None;
        }
        let cones = responses.map(|response| {
            let size = response.abs();
            let power = 27.13 * size / (400.0 - size);
            (100.0 / self.luminance * M::powf(power, 1.0 / 0.42)).copysign(response)
        });
        let expanded = const {
            match A::COMPRESSED {
                Some(cones) => Some(rounded(&product64(&A::Cones::FROM_XYZ, &inverse64(&cones)))),
                None => None,
            }
        };
        let [r, g, b] = match &expanded {
            Some(matrix) => apply(matrix, cones),
            None => cones,
        };
        let sharp = [r / self.gain[0], g / self.gain[1], b / self.gain[2]];
        Some(Xyz::from(apply(const { &rounded(&inverse64(&A::Cones::FROM_XYZ)) }, sharp)))
    }
}
