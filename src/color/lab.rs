//! CIELAB and its polar form.

#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::math::{Math, cbrt, cos_turns, sin_turns, sqrt};

use crate::color::Xyz;
use crate::tristimulus::shown_by_name;

/// Where the cube root takes over from the straight line: (6/29)^3.
const KNEE: f32 = 216.0 / 24389.0;
/// The slope of lightness below the knee: (29/3)^3.
const KAPPA: f32 = 24389.0 / 27.0;

/// Ratios to the white whose sum of sizes is beyond this overflow on the straight part: 500 (29/3)^3 / 116
/// times it.
const MOST: f32 = 8e34;

/// What the compressed ratio of black is.
const OFFSET: f32 = 16.0 / 116.0;

/// A color in CIE 1976 L\*a\*b\* (CIELAB). The reference white is not stored; keep it with the color.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Lab {
    /// L\*, lightness: 0 black, 100 the white.
    pub l: f32,
    /// a\*, from green (negative) to red.
    pub a: f32,
    /// b\*, from blue (negative) to yellow.
    pub b: f32,
}

/// CIELAB in polar form: lightness, chroma and hue angle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Lch {
    /// L\*, lightness.
    pub l: f32,
    /// C\*ab, chroma: the distance from gray.
    pub c: f32,
    /// hab, the hue angle in degrees, `0.0 <= h_deg < 360.0`; 0 for a gray.
    pub h_deg: f32,
}

shown_by_name!(Lab: "L*" l, "a*" a, "b*" b);
shown_by_name!(Lch: "L*" l, "C*" c, "h" h_deg);

impl Xyz {
    /// CIELAB relative to `white`, which is on the same scale as the color: both with Y = 100 for a perfect
    /// white surface, or both in cd/m2.
    ///
    /// Negative tristimulus values are on the straight part of the curve and stay finite. `None` if a
    /// component of the white is not above zero, as Z of a red laser beyond 650 nm, where z-bar is zero in
    /// the CIE table, or so small that the color is 8e34 times as large. NaN stays NaN.
    ///
    /// # Accuracy
    /// 4e-5 on real colors, whether near gray or not (`tests/color/spaces.rs`); L\* is exactly
    /// 0 for Y = 0 and 100 for the white.
    ///
    /// # Reference
    /// ISO/CIE 11664-4:2019, with the exact 216/24389 and 24389/27.
    ///
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

    /// [`Xyz::lab`] by the functions of `M`.
    ///
    /// # Accuracy
    /// As [`Xyz::lab`] by [`Fast`](crate::math::Fast), 8 units by [`Micromath`](crate::math)'s cube root.
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
        // The compressed ratios less 16/116: then the straight part goes through zero and keeps its digits.
        let compressed = |t| if t > KNEE { cbrt(t) - OFFSET } else { KAPPA / 116.0 * t };
        let [fx, fy, fz] = [x, y, z].map(compressed);
        // A difference of cube roots is the difference of the numbers over the sum of squares of the roots:
        // without the cancellation that makes near grays uncertain. With one on the straight part, they are
        // far apart.
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
    /// L\*, a\*, b\*.
    #[must_use]
    pub const fn new(l: f32, a: f32, b: f32) -> Self {
        Lab { l, a, b }
    }

    /// The tristimulus values, on the scale of `white`. Components beyond 1e37 in size overflow.
    #[must_use]
    pub fn xyz(self, white: Xyz) -> Xyz {
        // 116 f - 16 is L* for Y, and what L* would be for X and Z.
        Xyz {
            x: luminance(self.l + 0.232 * self.a, white.x),
            y: luminance(self.l, white.y),
            z: luminance(self.l - 0.58 * self.b, white.z),
        }
    }

    /// C\*ab, the distance from gray.
    #[must_use]
    pub fn chroma(self) -> f32 {
        sqrt(self.a * self.a + self.b * self.b)
    }

    /// The polar form. A gray (a = b = 0) has hue 0.
    ///
    /// # Accuracy
    /// 4e-5 degrees (half a unit in the last place near 360), chroma 1.2e-7 relative.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn lch(self) -> Lch {
        self.lch_with::<Portable>()
    }

    /// [`Lab::lch`] by the functions of `M`.
    #[must_use]
    pub fn lch_with<M: Math>(self) -> Lch {
        let c = M::sqrt(self.a * self.a + self.b * self.b);
        Lch { l: self.l, c, h_deg: 360.0 * hue_turns::<M>(self.a, self.b) }
    }
}

impl Lch {
    /// The rectangular coordinates; any finite hue angle is accepted.
    ///
    /// # Accuracy
    /// 6e-7 of the chroma, for hues within a turn.
    #[must_use]
    pub fn lab(self) -> Lab {
        let turns = self.h_deg / 360.0;
        Lab { l: self.l, a: self.c * cos_turns(turns), b: self.c * sin_turns(turns) }
    }
}

/// The angle of (a, b) in turns, 0 to just below 1, and 0 for a gray.
fn hue_turns<M: Math>(a: f32, b: f32) -> f32 {
    if a == 0.0 && b == 0.0 {
        return 0.0; // atan2 tells +0 from -0, a hue must not
    }
    let turns = M::atan2(b, a) * (0.5 * core::f32::consts::FRAC_1_PI);
    let turns = if turns < 0.0 { turns + 1.0 } else { turns };
    // A hair below the positive axis rounds to a whole turn.
    if turns >= 1.0 { 0.0 } else { turns }
}

/// L\* of a luminance factor relative to the white's.
pub(super) fn lightness(y: f32) -> f32 {
    if y > KNEE { 116.0 * cbrt(y) - 16.0 } else { KAPPA * y }
}

/// The luminance that has lightness `l` where the white's is `white`.
pub(super) fn luminance(l: f32, white: f32) -> f32 {
    if l > 8.0 {
        let f = (l + 16.0) / 116.0;
        white * f * f * f
    } else {
        white * (l / KAPPA)
    }
}
