//! The conditions in which colors are seen, and from tristimulus values to what is seen there.

use core::marker::PhantomData;

use crate::color::appearance::{Appearance, AppearanceModel, CamUcs, Surround};
use crate::color::lab::hue_turns;
use crate::color::matrix::{Matrix, apply, inverse64, product64, rounded};
use crate::color::{ConeResponses, Xyz};
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::math::{Math, at_least, cbrt, sqrt};

/// The conditions in which colors are seen, made ready for appearance model `A`, [`Cam16`] or [`Ciecam02`].
///
/// They are told by four things: the white, X, Y, Z of the adopted white on the scale on which a perfect
/// white surface has Y = 100; the adapting luminance L_A in cd/m2, which is often a fifth of the luminance of
/// the white; Y of the background, 20 for a gray one; and the [`Surround`]. Make them once and use them for
/// every color of the scene.
///
/// [`appearance`](Self::appearance) gives the attributes of a color, and [`xyz`](Self::xyz) leads back.
/// [`ucs`](Self::ucs) gives its place in the uniform space, where the distance of two colors is their
/// difference, and [`xyz_of_ucs`](Self::xyz_of_ucs) leads back from there.
///
/// # Colors without an appearance
/// The models take roots of numbers that are above zero for the colors for which they were made. The color of
/// a narrow band or outside the spectral locus may have negative responses; where a number below a root is
/// negative for that reason, textbook code yields NaN, and the result here is `None`. Under D65 by
/// [`Ciecam02`] that is so for the blue primary of ProPhoto, by [`Cam16`] for no light of the visible
/// spectrum from 390 to 700 nm.
///
/// # Accuracy
/// Over the gamut of BT.2020 and scenes with L_A from 4 to 2000 cd/m2, searched for the worst color: J, C and
/// M within 5e-4, h by as little along its circle, CAM02-UCS and CAM16-UCS within 6e-4
/// (`tests/color/appearance.rs`). A gray may have a chroma of that size, and then a hue and a saturation that
/// mean nothing.
///
/// # Reference
/// CIE 159:2004; C. Li et al., "Comprehensive color solutions: CAM16, CAT16, and CAM16-UCS", Color Research
/// and Application 42, 2017; M. R. Luo, G. Cui, C. Li, "Uniform colour spaces based on CIECAM02", 2006.
///
/// # Example
/// ```
/// # #[cfg(feature = "libm")] {
/// use nanospectra::color::{Cam16, Ciecam02, Surround, ViewingConditions, Xyz};
/// // A gray under D65 and 1000 lx, by both models, as colour-science 0.4.7 prints it.
/// let (white, gray) = (Xyz::new(95.05, 100.0, 108.88), Xyz::new(19.01, 20.0, 21.78));
/// let seen = ViewingConditions::<Cam16>::new(white, 318.31, 20.0, Surround::Average).unwrap();
/// let color = seen.appearance(gray).unwrap();
/// assert!((color.j - 41.7312).abs() < 1e-4 && (color.c - 0.1034).abs() < 2e-4);
/// assert!((color.q - 195.3717).abs() < 1e-3 && (color.s - 2.3450).abs() < 1e-3);
/// // A red under a tenth of that light, as M. D. Fairchild's book has it: h 19.6, J 65.96, C 48.57.
/// let seen = ViewingConditions::<Ciecam02>::new(white, 31.83, 20.0, Surround::Average).unwrap();
/// let red = seen.appearance(Xyz::new(57.06, 43.06, 31.96)).unwrap();
/// assert!((red.h_deg - 19.6).abs() < 0.05 && (red.j - 65.96).abs() < 5e-3 && (red.c - 48.57).abs() < 5e-3);
/// # }
/// ```
///
/// [`Cam16`]: crate::color::Cam16
/// [`Ciecam02`]: crate::color::Ciecam02
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ViewingConditions<A> {
    /// The factor of each response by the adaptation to the white.
    pub(in crate::color::appearance) gain: [f32; 3],
    /// F_L, the factor of the adapting luminance.
    pub(in crate::color::appearance) luminance: f32,
    /// N_bb, which is equal to N_cb.
    pub(in crate::color::appearance) contrast: f32,
    /// c z, the exponent of lightness.
    pub(in crate::color::appearance) exponent: f32,
    /// A_w, the achromatic response to the white.
    pub(in crate::color::appearance) achromatic_white: f32,
    /// 50000/13 N_c N_cb, the factor of chromatic induction.
    pub(in crate::color::appearance) induction: f32,
    /// (1.64 - 0.29^n)^0.73, a factor of chroma.
    pub(in crate::color::appearance) chroma: f32,
    /// F_L^(1/4), the factor from chroma to colorfulness.
    pub(in crate::color::appearance) colorfulness: f32,
    /// c, the impact of the surround.
    impact: f32,
    model: PhantomData<A>,
}

/// What is common to all attributes of one color.
struct Sight {
    /// J, 0 where the achromatic response is below zero.
    lightness: f32,
    /// t^0.9, which is C of a color with J = 100 but for the factor of chroma.
    strength: f32,
    /// The opponent responses a and b, and their length.
    opponents: [f32; 2],
    size: f32,
    /// Whether no number below a root is negative; NaN counts as real, and stays NaN.
    is_real: bool,
}

impl<A: AppearanceModel> ViewingConditions<A> {
    const SHARP: Matrix = rounded(&A::Cones::FROM_XYZ);

    /// Makes the conditions, with the degree of adaptation to the white that the models compute from the
    /// surround and the adapting luminance.
    ///
    /// The result is `None` if the adapting luminance, the background or a response to the white is not above
    /// zero. NaN stays NaN. Luminances beyond 1e30 overflow. See the [example](ViewingConditions#example).
    ///
    /// # Cost
    /// On a Cortex-M4F it takes 1620 instructions for CAM16 and 1700 for CIECAM02.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn new(white: Xyz, adapting_cd_m2: f32, background_y: f32, surround: Surround) -> Option<Self> {
        Self::new_with::<Portable>(white, adapting_cd_m2, background_y, surround)
    }

    /// Makes the conditions as [`new`](Self::new) does, with complete adaptation to the white: D = 1.
    ///
    /// This is what "discounting the illuminant" means: an object seen as such, whose viewer knows the light.
    ///
    /// # Example
    /// ```
    /// use nanospectra::color::{Ciecam02, Surround, ViewingConditions, Xyz};
    /// // The condition of TM-30. Under complete adaptation the white of any lamp is a gray without chroma.
    /// let white = Xyz::new(109.85, 100.0, 35.58);
    /// let seen = ViewingConditions::<Ciecam02>::discounting(white, 100.0, 20.0, Surround::Average).unwrap();
    /// let color = seen.appearance(white).unwrap();
    /// assert!((color.j - 100.0).abs() < 1e-4 && color.c < 0.01);
    /// ```
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn discounting(
        white: Xyz,
        adapting_cd_m2: f32,
        background_y: f32,
        surround: Surround,
    ) -> Option<Self> {
        Self::discounting_with::<Portable>(white, adapting_cd_m2, background_y, surround)
    }

    /// Makes the conditions as [`new`](Self::new) does, by the elementary functions of the math backend `M`.
    #[must_use]
    pub fn new_with<M: Math>(
        white: Xyz,
        adapting_cd_m2: f32,
        background_y: f32,
        surround: Surround,
    ) -> Option<Self> {
        let degree = surround.degree() * (1.0 - M::exp(-(adapting_cd_m2 + 42.0) / 92.0) / 3.6);
        Self::checked::<M>(white, adapting_cd_m2, background_y, surround, degree)
    }

    /// Makes the conditions as [`discounting`](Self::discounting) does, by the elementary functions of the
    /// math backend `M`.
    #[must_use]
    pub fn discounting_with<M: Math>(
        white: Xyz,
        adapting_cd_m2: f32,
        background_y: f32,
        surround: Surround,
    ) -> Option<Self> {
        Self::checked::<M>(white, adapting_cd_m2, background_y, surround, 1.0)
    }

    fn checked<M: Math>(
        white: Xyz,
        adapting: f32,
        background_y: f32,
        surround: Surround,
        degree: f32,
    ) -> Option<Self> {
        let cones = apply(&Self::SHARP, white.to_array());
        if adapting <= 0.0 || background_y <= 0.0 || white.y <= 0.0 || cones.iter().any(|cone| *cone <= 0.0) {
            return None;
        }
        let made = Self::of::<M>(white, white.y, adapting, background_y / white.y, surround, degree);
        if made.achromatic_white <= 0.0 { None } else { Some(made) }
    }

    /// Makes the conditions for a white whose Y is `white_y` and a background of `background` times that.
    pub(in crate::color) fn of<M: Math>(
        white: Xyz,
        white_y: f32,
        adapting: f32,
        background: f32,
        surround: Surround,
        degree: f32,
    ) -> Self {
        let five = 5.0 * adapting;
        let k = 1.0 / (five + 1.0);
        let k4 = k * k * k * k;
        let luminance = 0.2 * k4 * five + 0.1 * (1.0 - k4) * (1.0 - k4) * cbrt(five);
        let contrast = 0.725 * M::powf(1.0 / background, 0.2);
        let mut conditions = ViewingConditions {
            gain: apply(&Self::SHARP, white.to_array())
                .map(|cone| degree * (white_y / cone) + (1.0 - degree)),
            luminance,
            contrast,
            exponent: surround.impact() * (1.48 + sqrt(background)),
            achromatic_white: 1.0,
            induction: 50_000.0 / 13.0 * surround.induction() * contrast,
            chroma: M::powf(1.64 - M::powf(0.29, background), 0.73),
            colorfulness: sqrt(sqrt(luminance)),
            impact: surround.impact(),
            model: PhantomData,
        };
        conditions.achromatic_white = conditions.achromatic(conditions.cones::<M>(white));
        conditions
    }

    /// Computes the attributes of a color.
    ///
    /// The color is on the scale of the white. The result is `None` if the model gives it
    /// [no appearance](ViewingConditions#colors-without-an-appearance). Black has J = 0, and so has h = 0
    /// each gray. NaN stays NaN. Components beyond 1e36 overflow. See the
    /// [example](ViewingConditions#example).
    ///
    /// # Cost
    /// On a Cortex-M4F it takes 1540 instructions by CAM16 and 1580 by CIECAM02.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn appearance(&self, color: Xyz) -> Option<Appearance> {
        self.appearance_with::<Portable>(color)
    }

    /// Computes [`appearance`](Self::appearance) by the elementary functions of the math backend `M`.
    ///
    /// # Cost
    /// By CAM16 and [`Fast`](crate::math::Fast) it takes 666 instructions on a Cortex-M4F.
    #[must_use]
    pub fn appearance_with<M: Math>(&self, color: Xyz) -> Option<Appearance> {
        let sight = self.looks_at::<M>(color);
        if !sight.is_real {
            return None;
        }
        if sight.lightness == 0.0 {
            return Some(Appearance::default());
        }
        let root = sqrt(sight.lightness / 100.0);
        let [red_green, yellow_blue] = sight.opponents;
        // Both M and Q have the factor sqrt(J), and so s has none.
        let white = (self.achromatic_white + 4.0) / self.impact;
        let c = sight.strength * root * self.chroma;
        Some(Appearance {
            j: sight.lightness,
            c,
            h_deg: 360.0 * hue_turns::<M>(red_green, yellow_blue),
            q: 4.0 * root * white * self.colorfulness,
            m: c * self.colorfulness,
            s: 50.0 * sqrt(sight.strength * self.chroma / white),
        })
    }

    /// Computes the place of a color in the uniform space of the model, CAM02-UCS or CAM16-UCS.
    ///
    /// The result is `None` as in [`appearance`](Self::appearance). See the
    /// [example](crate::color::CamUcs#example).
    ///
    /// # Cost
    /// On a Cortex-M4F it takes 1470 instructions by CAM16 and 1500 by CIECAM02.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn ucs(&self, color: Xyz) -> Option<CamUcs> {
        self.ucs_with::<Portable>(color)
    }

    /// Computes [`ucs`](Self::ucs) by the elementary functions of the math backend `M`.
    ///
    /// # Accuracy
    /// By [`Fast`](crate::math::Fast) within 2e-4 of [`ucs`](Self::ucs), for the colors of sRGB.
    ///
    /// # Cost
    /// By CAM16 and [`Fast`](crate::math::Fast) it takes 604 instructions on a Cortex-M4F.
    #[must_use]
    pub fn ucs_with<M: Math>(&self, color: Xyz) -> Option<CamUcs> {
        let sight = self.looks_at::<M>(color);
        if sight.is_real { Some(self.uniform::<M>(&sight)) } else { None }
    }

    /// As [`ucs_with`](Self::ucs_with), but a color whose achromatic response is below zero has J' = 0, and
    /// one that has no chroma has a' and b' of NaN.
    #[cfg(feature = "libm")]
    pub(in crate::color) fn ucs_or_nan<M: Math>(&self, color: Xyz) -> CamUcs {
        self.uniform::<M>(&self.looks_at::<M>(color))
    }

    fn uniform<M: Math>(&self, sight: &Sight) -> CamUcs {
        let j = 1.7 * sight.lightness / (1.0 + 0.007 * sight.lightness);
        if sight.size == 0.0 {
            return CamUcs { j, a: 0.0, b: 0.0 };
        }
        let chroma = sight.strength * sqrt(sight.lightness / 100.0) * self.chroma;
        let m = M::ln(1.0 + 0.0228 * chroma * self.colorfulness) / 0.0228;
        let [red_green, yellow_blue] = sight.opponents;
        CamUcs { j, a: m * (red_green / sight.size), b: m * (yellow_blue / sight.size) }
    }

    fn looks_at<M: Math>(&self, color: Xyz) -> Sight {
        let [r, g, b] = self.cones::<M>(color);
        let (red_green, yellow_blue) = (r - 12.0 * g / 11.0 + b / 11.0, (r + g - 2.0 * b) / 9.0);
        let size = sqrt(red_green * red_green + yellow_blue * yellow_blue);
        let share = self.achromatic([r, g, b]) / self.achromatic_white;
        let lightness = 100.0 * M::powf(at_least(share, 0.0), self.exponent);
        let (sum, strength) = if size == 0.0 {
            (1.0, 0.0)
        } else {
            let eccentricity = eccentricity(red_green / size, yellow_blue / size);
            let sum = r + g + 1.05 * b;
            (sum, M::powf(self.induction * eccentricity * size / sum, 0.9))
        };
        Sight {
            lightness,
            strength,
            opponents: [red_green, yellow_blue],
            size,
            // By rounding alone the share of a color that is as good as black may be below zero, too.
            is_real: !(share < -1e-6 || sum <= 0.0),
        }
    }

    /// Returns the responses after adaptation and compression.
    fn cones<M: Math>(&self, xyz: Xyz) -> [f32; 3] {
        let sharp = apply(&Self::SHARP, xyz.to_array());
        let adapted = [sharp[0] * self.gain[0], sharp[1] * self.gain[1], sharp[2] * self.gain[2]];
        let compressed = const {
            match A::COMPRESSED {
                Some(cones) => Some(rounded(&product64(&cones, &inverse64(&A::Cones::FROM_XYZ)))),
                None => None,
            }
        };
        let cones = match &compressed {
            Some(matrix) => apply(matrix, adapted),
            None => adapted,
        };
        cones.map(|cone| {
            let power = M::powf(self.luminance * cone.abs() / 100.0, 0.42);
            let response = 400.0 * power / (power + 27.13);
            if cone < 0.0 { 0.1 - response } else { 0.1 + response }
        })
    }

    fn achromatic(&self, [r, g, b]: [f32; 3]) -> f32 {
        (2.0 * r + g + b / 20.0 - 0.305) * self.contrast
    }
}

/// Returns a quarter of cos(h + 2) + 3.8, with angles in radians.
pub(in crate::color::appearance) fn eccentricity(cos: f32, sin: f32) -> f32 {
    0.25 * (cos * -0.416_146_84 - sin * 0.909_297_4 + 3.8)
}
