//! CIELUV.

use crate::color::Xyz;
use crate::color::lab::{lightness, luminance};
use crate::tristimulus::shown_by_name;

/// A color in CIE 1976 L\*u\*v\* (CIELUV). The reference white is not stored; keep it with the color.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Luv {
    /// L\*, lightness, the same as in CIELAB.
    pub l: f32,
    /// u\* = 13 L\* (u' - u'n)
    pub u: f32,
    /// v\* = 13 L\* (v' - v'n)
    pub v: f32,
}

shown_by_name!(Luv: "L*" l, "u*" u, "v*" v);

impl Xyz {
    /// CIELUV relative to `white`, which is on the same scale as the color.
    ///
    /// Black, and anything else without luminance, is (0, 0, 0). `None` when the white has no
    /// luminance or no chromaticity (a component sum of zero or less), or the color has none
    /// and is not black. NaN stays NaN. Unlike CIELAB it accepts a white whose Z is
    /// zero.
    ///
    /// # Accuracy
    /// 7e-5 on real colors (`tests/color/spaces.rs`).
    ///
    /// # Reference
    /// ISO/CIE 11664-5:2016, with the exact 216/24389 and 24389/27.
    #[must_use]
    pub fn luv(self, white: Xyz) -> Option<Luv> {
        let [xn, yn, zn] = fractions(white)?;
        if white.y <= 0.0 {
            return None;
        }
        let relative = self.y / white.y;
        if relative == 0.0 {
            return Some(Luv::default());
        }
        let [x, y, z] = fractions(self)?;
        let l = lightness(relative);
        if l.is_infinite() {
            return None;
        }
        // u' - u'n and v' - v'n with the terms left out that are the same in both.
        let du = 60.0 * (x * yn - xn * y) + 12.0 * (x * zn - xn * z);
        let dv = 9.0 * (xn * y - x * yn) + 27.0 * (y * zn - yn * z);
        Some(Luv { l, u: 13.0 * l * du, v: 13.0 * l * dv })
    }
}

impl Luv {
    /// L\*, u\*, v\*.
    #[must_use]
    pub const fn new(l: f32, u: f32, v: f32) -> Self {
        Luv { l, u, v }
    }

    /// The tristimulus values, on the scale of `white`; L\* = 0 is black.
    ///
    /// `None` when the white has no chromaticity, or v' is not above zero: there is no such
    /// light. L\* beyond 1e12 in size overflows.
    #[must_use]
    pub fn xyz(self, white: Xyz) -> Option<Xyz> {
        let [xn, yn, _] = fractions(white)?;
        if self.l == 0.0 {
            return Some(Xyz::default());
        }
        let u = self.u / (13.0 * self.l) + 4.0 * xn;
        let v = self.v / (13.0 * self.l) + 9.0 * yn;
        if v <= 0.0 || v.is_infinite() || u.is_infinite() {
            return None;
        }
        let y = luminance(self.l, white.y);
        let part = y / (4.0 * v);
        Some(Xyz { x: 9.0 * u * part, y, z: (12.0 - 3.0 * u - 20.0 * v) * part })
    }
}

/// X, Y, Z over X + 15 Y + 3 Z: a quarter of u' is the first, a ninth of v' the second.
///
/// `None` where the sum is not above zero, overflows, or has canceled: no light is like that.
fn fractions(color: Xyz) -> Option<[f32; 3]> {
    let sum = color.x + 15.0 * color.y + 3.0 * color.z;
    if sum <= 0.0 || sum.is_infinite() {
        return None;
    }
    let parts = color.to_array().map(|v| v / sum);
    if parts.iter().any(|part| part.abs() > 1e6) { None } else { Some(parts) }
}
