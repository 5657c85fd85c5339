//! CIELAB and its polar form.

#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::math::{Math, cbrt, cos_turns, length, sin_turns};

use crate::color::Xyz;
use crate::tristimulus::shown_by_name;

/// The ratio to the white above which CIELAB uses the cube root and below which the straight line: (6/29)^3.
const KNEE: f32 = 216.0 / 24389.0;
/// The slope of lightness below the knee: (29/3)^3.
const KAPPA: f32 = 24389.0 / 27.0;

/// The largest sum of the sizes of the three ratios to the white for which nothing overflows. (On the
/// straight part they are multiplied by 500 (29/3)^3 / 116.)
const MOST: f32 = 8e34;

/// The compressed ratio of black.
const OFFSET: f32 = 16.0 / 116.0;

/// A color in CIE 1976 L\*a\*b\* (CIELAB), the space in which color differences are measured.
///
/// [`Xyz::lab`] computes it, [`Lab::xyz`] leads back, and [`ciede2000`](crate::color::ciede2000()) gives the
/// difference of two colors. The reference white is not stored; keep it with the color.
///
/// # Example
/// ```
/// use nanospectra::color::{Lab, Xyz};
/// let d65 = Xyz::new(95.047, 100.0, 108.883);
/// let red = Xyz::new(41.2456, 21.2673, 1.9334).lab(d65).ok_or("no white")?; // the red of sRGB
/// assert!((red.l - 53.24).abs() < 0.01 && (red.a - 80.09).abs() < 0.01 && (red.b - 67.20).abs() < 0.01);
/// assert_eq!(format!("{red:.1}"), "L* 53.2 a* 80.1 b* 67.2");
/// assert!((red.xyz(d65).x - 41.2456).abs() < 1e-3);
///
/// // Chroma and hue angle: a triangle with the sides 3, 4, 5.
/// let color = Lab::new(60.0, 3.0, 4.0);
/// assert_eq!(color.chroma(), 5.0);
/// # #[cfg(feature = "libm")] {
/// let polar = color.lch();
/// assert!((polar.c - 5.0).abs() < 1e-6 && (polar.h_deg - 53.1301).abs() < 1e-4);
/// assert!((polar.lab().a - 3.0).abs() < 1e-5);
/// # }
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Lab {
    /// The lightness L\*, which is 0 for black and 100 for the white.
    ///
    /// See the [example](Lab#example).
    pub l: f32,
    /// The coordinate a\*, which goes from green (negative) to red.
    ///
    /// See the [example](Lab#example).
    pub a: f32,
    /// The coordinate b\*, which goes from blue (negative) to yellow.
    ///
    /// See the [example](Lab#example).
    pub b: f32,
}

/// CIELAB in polar form, which separates lightness, chroma and hue angle.
///
/// [`Lab::lch`] computes it. See the [example](Lab#example).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Lch {
    /// The lightness L\*, which is the same as in [`Lab`].
    pub l: f32,
    /// The chroma C\*ab, which is the distance from the gray of the same lightness.
    ///
    /// See the [example](Lab#example).
    pub c: f32,
    /// The hue angle hab, which is given in degrees, `0.0 <= h_deg < 360.0`, and is 0 for a gray.
    ///
    /// See the [example](Lab#example).
    pub h_deg: f32,
}

shown_by_name!(Lab: "L*" l, "a*" a, "b*" b);
shown_by_name!(Lch: "L*" l, "C*" c, "h" h_deg);

impl Xyz {
    /// Converts the color to CIELAB relative to `white`.
    ///
    /// The white must be on the same scale as the color: both with Y = 100 for a perfect white surface, or
    /// both in cd/m2.
    ///
    /// Negative tristimulus values are on the straight part of the curve and stay finite. The result is
    /// `None` if a component of the white is not above zero, as Z of a red laser beyond 650 nm, where z-bar
    /// is zero in the CIE table, or if it is so small that the color is 8e34 times as large. NaN stays NaN.
    ///
    /// # Accuracy
    /// 9e-5 for all colors of surfaces, the most saturated included, and 4e-5 for usual ones; L\* is exactly
    /// 0 for Y = 0 and 100 for the white.
    ///
    /// # Reference
    /// ISO/CIE 11664-4:2019, with the exact 216/24389 and 24389/27.
    ///
    /// # Example
    /// ```
    /// # use nanospectra::color::Xyz;
    /// let d65 = Xyz::new(95.047, 100.0, 108.883);
    /// let gray = d65.scaled(0.184_187).lab(d65).ok_or("no white")?;
    /// assert!((gray.l - 50.0).abs() < 1e-3 && gray.a.abs() < 1e-4 && gray.b.abs() < 1e-4);
    /// # Ok::<(), &str>(())
    /// ```
    #[must_use]
    pub fn lab(self, white: Xyz) -> Option<Lab> {
        self.lab_by(white, cbrt)
    }

    /// Computes [`Xyz::lab`] by the elementary functions of the math backend `M`.
    ///
    /// # Accuracy
    /// By [`Fast`](crate::math::Fast) as accurate as [`Xyz::lab`]; the cube root of
    /// [`Micromath`](crate::math) makes errors of up to 8 units.
    #[must_use]
    pub fn lab_with<M: Math>(self, white: Xyz) -> Option<Lab> {
        self.lab_by(white, M::cbrt)
    }

    #[inline]
    fn lab_by(self, white: Xyz, cbrt: impl Fn(f32) -> f32) -> Option<Lab> {
        if white.x <= 0.0 || white.y <= 0.0 || white.z <= 0.0 {
            return None;
        }
        let [x, y, z] = [self.x / white.x, self.y / white.y, self.z / white.z];
        if x.abs() + y.abs() + z.abs() > MOST {
            return None;
        }
        // The compressed ratios are taken less 16/116. Then the straight part goes through zero, and dark
        // colors keep their digits.
        let compressed = |t| if t > KNEE { cbrt(t) - OFFSET } else { KAPPA / 116.0 * t };
        let [fx, fy, fz] = [x, y, z].map(compressed);
        // A difference of cube roots, p - q, is computed as (p^3 - q^3) / (p^2 + p q + q^2), so that nothing
        // cancels near gray. If a ratio is on the straight part, the plain difference is taken.
        let (a, b) = if x > KNEE && y > KNEE && z > KNEE {
            let [x3, y3, z3] = [fx + OFFSET, fy + OFFSET, fz + OFFSET];
            let squares = |s: f32, t: f32| s * s + s * t + t * t;
            ((x - y) / squares(x3, y3), (y - z) / squares(y3, z3))
        } else {
            (fx - fy, fy - fz)
        };
        Some(Lab { l: 116.0 * fy, a: 500.0 * a, b: 200.0 * b })
    }
}

impl Lab {
    /// Makes a color from L\*, a\* and b\*.
    ///
    /// See the [example](Lab#example).
    #[must_use]
    pub const fn new(l: f32, a: f32, b: f32) -> Self {
        Lab { l, a, b }
    }

    /// Converts the color back to tristimulus values, on the scale of `white`.
    ///
    /// Components beyond 1e37 in size overflow. See the [example](Lab#example).
    #[must_use]
    pub fn xyz(self, white: Xyz) -> Xyz {
        // 116 f - 16 is L* for Y. For X and Z it is the L* that a luminance of this ratio would have.
        Xyz {
            x: luminance(self.l + 0.232 * self.a, white.x),
            y: luminance(self.l, white.y),
            z: luminance(self.l - 0.58 * self.b, white.z),
        }
    }

    /// Computes the chroma C\*ab, the distance from the gray of the same lightness.
    ///
    /// See the [example](Lab#example).
    #[must_use]
    pub fn chroma(self) -> f32 {
        length([self.a, self.b])
    }

    /// Converts the color to lightness, chroma and hue angle.
    ///
    /// A gray (a = b = 0) has hue 0. See the [example](Lab#example).
    ///
    /// # Accuracy
    /// 5e-5 degrees (the last place near 360 is 3e-5), chroma 1.2e-7 relative.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn lch(self) -> Lch {
        self.lch_with::<Portable>()
    }

    /// Computes [`Lab::lch`] by the elementary functions of the math backend `M`.
    #[must_use]
    pub fn lch_with<M: Math>(self) -> Lch {
        Lch { l: self.l, c: self.chroma(), h_deg: 360.0 * hue_turns::<M>(self.a, self.b) }
    }
}

impl Lch {
    /// Converts the color to the coordinates L\*, a\*, b\*.
    ///
    /// Any finite hue angle is accepted. See the [example](Lab#example).
    ///
    /// # Accuracy
    /// 3.5e-7 of the chroma, for hues within a turn.
    #[must_use]
    pub fn lab(self) -> Lab {
        let turns = self.h_deg / 360.0;
        Lab { l: self.l, a: self.c * cos_turns(turns), b: self.c * sin_turns(turns) }
    }
}

/// Returns the angle of (a, b) in turns, at least 0 and below 1; it is 0 for a gray.
pub(in crate::color) fn hue_turns<M: Math>(a: f32, b: f32) -> f32 {
    if a == 0.0 && b == 0.0 {
        return 0.0; // atan2 would distinguish +0 and -0
    }
    let turns = M::atan2(b, a) * (0.5 * core::f32::consts::FRAC_1_PI);
    let turns = if turns < 0.0 { turns + 1.0 } else { turns };
    // An angle just below zero rounds to a whole turn.
    if turns >= 1.0 { 0.0 } else { turns }
}

/// Computes L\* from the ratio of a luminance to that of the white.
pub(super) fn lightness(y: f32) -> f32 {
    if y > KNEE { 116.0 * cbrt(y) - 16.0 } else { KAPPA * y }
}

/// Returns the luminance that has lightness `l`, if the luminance of the white is `white`.
pub(super) fn luminance(l: f32, white: f32) -> f32 {
    if l > 8.0 {
        let f = (l + 16.0) / 116.0;
        white * f * f * f
    } else {
        white * (l / KAPPA)
    }
}
