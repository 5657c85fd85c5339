//! CIELUV.

use super::Xyz;
use super::lab::{lightness, luminance};

/// A colour in CIE 1976 L\*u\*v\* (CIELUV), relative to a white that goes without saying.
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

impl Xyz {
    /// CIELUV relative to `white`, which is on the same scale as the colour.
    ///
    /// Black, and anything else without luminance, is (0, 0, 0). `None` when the white has no
    /// luminance or no chromaticity (a component sum of zero or less), or the colour has none
    /// and is not black. NaN stays NaN. Unlike CIELAB it has no trouble with a white whose Z
    /// is zero.
    ///
    /// # Accuracy
    /// 1e-4 on real colours (`tests/color_spaces.rs`).
    ///
    /// # Reference
    /// ISO/CIE 11664-5:2016, with the exact 216/24389 and 24389/27.
    #[must_use]
    pub fn luv(self, white: Xyz) -> Option<Luv> {
        let [un, vn] = chromaticity(white)?;
        if white.y <= 0.0 {
            return None;
        }
        let y = self.y / white.y;
        if y == 0.0 {
            return Some(Luv::default());
        }
        let [u, v] = chromaticity(self)?;
        if y.is_infinite() {
            return None;
        }
        let l = lightness(y);
        Some(Luv { l, u: 13.0 * l * (u - un), v: 13.0 * l * (v - vn) })
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
    /// light.
    #[must_use]
    pub fn xyz(self, white: Xyz) -> Option<Xyz> {
        let [un, vn] = chromaticity(white)?;
        if self.l == 0.0 {
            return Some(Xyz::default());
        }
        let u = self.u / (13.0 * self.l) + un;
        let v = self.v / (13.0 * self.l) + vn;
        if v <= 0.0 || v.is_infinite() || u.is_infinite() {
            return None;
        }
        let y = luminance(self.l, white.y);
        let part = y / (4.0 * v);
        Some(Xyz { x: 9.0 * u * part, y, z: (12.0 - 3.0 * u - 20.0 * v) * part })
    }
}

/// u', v', or `None` where X + 15 Y + 3 Z is not above zero or overflows.
fn chromaticity(color: Xyz) -> Option<[f32; 2]> {
    let sum = color.x + 15.0 * color.y + 3.0 * color.z;
    if sum <= 0.0 || sum.is_infinite() {
        return None;
    }
    Some([4.0 * (color.x / sum), 9.0 * (color.y / sum)])
}
