//! The CIEDE2000 color difference.

use crate::color::Lab;
#[cfg(feature = "libm")]
use crate::color::Xyz;
use crate::color::difference::{Polar, counted, polar, unit_for};
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::math::{Math, cos_turns, length, sin_turns, sqrt};

/// The parametric factors of CIEDE2000, which adapt the formula to the viewing conditions.
///
/// Lightness, chroma and hue differences are divided by them. All are 1 under reference conditions, which is
/// the default; kL = 2 is used for textiles. They must be above zero. See the
/// [example](ciede2000_with#example).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ParametricFactors {
    /// The factor kL, which divides the lightness difference.
    ///
    /// See the [example](ciede2000_with#example).
    pub k_l: f32,
    /// The factor kC, which divides the chroma difference.
    pub k_c: f32,
    /// The factor kH, which divides the hue difference.
    pub k_h: f32,
}

impl Default for ParametricFactors {
    fn default() -> Self {
        ParametricFactors { k_l: 1.0, k_c: 1.0, k_h: 1.0 }
    }
}

/// Computes the CIEDE2000 color difference under reference conditions (kL = kC = kH = 1).
///
/// A difference of about 1 is just noticeable. Swapping the colors gives the same bits. Use
/// [`Xyz::delta_e`] for colors that are still tristimulus values.
///
/// # Accuracy
/// 1.5e-6 relative, for differences from 1e-15 on; within the rounding of all 34 published pairs
/// (`tests/color/differences.rs`). Smaller differences may come out as 0. Every finite color has a
/// difference, which is infinite only if it is beyond f32.
///
/// # Reference
/// ISO/CIE 11664-6:2022; G. Sharma, W. Wu, E. N. Dalal, "The CIEDE2000 color-difference
/// formula", Color Res. Appl. 30 (2005), with its conventions for opposite hues and grays.
///
/// # Example
/// ```
/// use nanospectra::color::{Lab, ciede2000};
/// // The first pair of the paper's table.
/// let pair = [Lab::new(50.0, 2.6772, -79.7751), Lab::new(50.0, 0.0, -82.7485)];
/// assert!((ciede2000(pair[0], pair[1]) - 2.0425).abs() < 5e-5);
/// ```
#[cfg(feature = "libm")]
#[must_use]
pub fn ciede2000(x: Lab, y: Lab) -> f32 {
    ciede2000_with::<Portable>(x, y, ParametricFactors::default())
}

#[cfg(feature = "libm")]
impl Xyz {
    /// Computes the [`ciede2000`] difference from another color that is seen beside the same `white`.
    ///
    /// The result is NaN if a component of the white is not above zero.
    ///
    /// # Example
    /// ```
    /// # use nanospectra::color::Xyz;
    /// let d65 = Xyz::new(95.047, 100.0, 108.883);
    /// // The whole way from black to white, and none at all.
    /// assert!((d65.delta_e(Xyz::new(0.0, 0.0, 0.0), d65) - 100.0).abs() < 1e-3);
    /// assert_eq!(d65.scaled(0.5).delta_e(d65.scaled(0.5), d65), 0.0);
    /// assert!(d65.delta_e(d65, Xyz::new(0.0, 0.0, 0.0)).is_nan());
    /// ```
    #[must_use]
    pub fn delta_e(self, other: Xyz, white: Xyz) -> f32 {
        match (self.lab(white), other.lab(white)) {
            (Some(one), Some(other)) => ciede2000(one, other),
            _ => f32::NAN,
        }
    }
}

/// Computes the CIEDE2000 difference with parametric factors, by the elementary functions of backend `M`.
///
/// # Example
/// ```
/// use nanospectra::color::{Lab, ParametricFactors, ciede2000_with};
/// use nanospectra::math::Fast;
/// // Two grays: the lightness difference of 10 is divided by S_L = 1 + 0.015 25 / sqrt(20 + 25).
/// let (dark, light) = (Lab::new(50.0, 0.0, 0.0), Lab::new(60.0, 0.0, 0.0));
/// let reference = ciede2000_with::<Fast>(dark, light, ParametricFactors::default());
/// assert!((reference - 9.4706).abs() < 1e-3);
///
/// let textiles = ParametricFactors { k_l: 2.0, ..ParametricFactors::default() };
/// let difference = ciede2000_with::<Fast>(dark, light, textiles);
/// assert!((difference - reference / 2.0).abs() < 1e-5);
/// ```
#[must_use]
pub fn ciede2000_with<M: Math>(x: Lab, y: Lab, k: ParametricFactors) -> f32 {
    // Near grays, differences in a are stretched: a' = (1 + G) a.
    let chroma = |of: Lab| sqrt(of.a * of.a + of.b * of.b);
    let mean = 0.5 * (chroma(x) + chroma(y));
    let (stretch, unit) = (1.5 - 0.5 * saturation(mean), unit_for(mean));
    let from_gray = (0.5 * x.l + 0.5 * y.l - 50.0).abs();
    let (x, y) = (counted(x, unit), counted(y, unit));
    let difference = polar(x, y, stretch);
    let Polar { c1, c2, dc, .. } = difference;

    let (toward, dh) = mean_hue([stretch * x.a, x.b], [stretch * y.a, y.b], &difference);
    // The mean hue from -1/2 to 1/2 turn, which is a digit more exact than from 0 to 1. All that follows is the
    // same at both ends.
    let h = M::atan2(toward[1], toward[0]) * (0.5 * core::f32::consts::FRAC_1_PI);

    let t = 1.0 - 0.17 * cos_turns(h - 30.0 / 360.0)
        + 0.24 * cos_turns(2.0 * h)
        + 0.32 * cos_turns(3.0 * h + 6.0 / 360.0)
        - 0.20 * cos_turns(4.0 * h - 63.0 / 360.0);
    let c = 0.5 * (c1 + c2);
    let s_l = 1.0 + 0.015 * from_gray / sqrt(1.0 + 20.0 / (from_gray * from_gray));
    // These two are in the unit of the chromas and differences.
    let s_c = unit + 0.045 * c;
    let s_h = unit + 0.015 * c * t;
    // The rotation of the ellipses in the blue, by 2 * 30 degrees at most. The formula takes the distance
    // from 275 degrees with hues from 0 to 360, not the shorter way round.
    let from_blue = (h - if h < 0.0 { -85.0 / 360.0 } else { 275.0 / 360.0 }) * (360.0 / 25.0);
    let r_t = -2.0 * saturation(c / unit) * sin_turns(M::exp(-from_blue * from_blue) / 6.0);

    let l = (y.l - x.l) / (k.k_l * s_l);
    let c = dc / (k.k_c * s_c);
    let h = dh / (k.k_h * s_h);
    let square = l * l + c * c + h * h + r_t * (c * h);
    // Only a difference of lightness is so large, and beside it the rotation is nothing.
    if square == f32::INFINITY { length([l, c, h]) } else { M::sqrt(square) }
}

/// Computes sqrt(C^7 / (C^7 + 25^7)) in a form that neither overflows nor divides zero by zero.
fn saturation(chroma: f32) -> f32 {
    let q = 25.0 / chroma;
    let q2 = q * q;
    1.0 / sqrt(1.0 + q2 * q2 * q2 * q)
}

/// Returns a vector in the direction of the mean hue, and the hue difference with its final sign.
///
/// The vector bisects the smaller angle between the hues. So no case distinction by angles is needed, and
/// hues that are opposite are found to be so in f32 too, as the published pairs 9 to 14 demand. Of exactly
/// opposite hues the mean is the one between them on the way from 0 to 360 degrees; with a gray it is the
/// hue of the other color.
fn mean_hue([a1, b1]: [f32; 2], [a2, b2]: [f32; 2], difference: &Polar) -> ([f32; 2], f32) {
    let &Polar { c1, c2, dh, cross, far, .. } = difference;
    if c1 == 0.0 || c2 == 0.0 {
        return ([a1 + a2, b1 + b2], dh);
    }
    if !far {
        return ([c2 * a1 + c1 * a2, c2 * b1 + c1 * b2], dh);
    }
    // For nearly opposite hues the sum of the directions cancels. Their difference does not, and it is at a
    // right angle to the bisector.
    let (a, b) = (c2 * a1 - c1 * a2, c2 * b1 - c1 * b2);
    let first_is_later = b < 0.0 || (b == 0.0 && a < 0.0);
    let clockwise = if cross == 0.0 { first_is_later } else { cross < 0.0 };
    let dh = if cross == 0.0 && first_is_later { -dh } else { dh };
    (if clockwise { [b, -a] } else { [-b, a] }, dh)
}
