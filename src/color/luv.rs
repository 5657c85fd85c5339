//! The CIELUV color space.

use crate::color::Xyz;
use crate::color::lab::{lightness, luminance};
use crate::tristimulus::shown_by_name;

/// A color in CIE 1976 L\*u\*v\* (CIELUV), a space that is derived from the u', v' diagram.
///
/// [`Xyz::luv`] computes it, and [`Luv::xyz`] leads back. The reference white is not stored; keep it with the
/// color.
///
/// # Example
/// ```
/// use nanospectra::color::{Luv, Xyz};
/// let d65 = Xyz::new(95.047, 100.0, 108.883);
/// let red = Xyz::new(41.2456, 21.2673, 1.9334); // the red of sRGB
/// let luv = red.luv(d65).ok_or("no white")?;
/// assert!((luv.l - 53.24).abs() < 0.01 && (luv.u - 175.01).abs() < 0.01 && (luv.v - 37.76).abs() < 0.01);
///
/// let back = Luv::new(luv.l, luv.u, luv.v).xyz(d65).ok_or("no such light")?;
/// assert!((back.x - red.x).abs() < 1e-3 && (back.z - red.z).abs() < 1e-3);
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Luv {
    /// The lightness L\*, which is the same as in CIELAB.
    ///
    /// See the [example](Luv#example).
    pub l: f32,
    /// The coordinate u\*, which is 13 L\* (u' - u'n), with u'n of the white.
    ///
    /// See the [example](Luv#example).
    pub u: f32,
    /// The coordinate v\*, which is 13 L\* (v' - v'n), with v'n of the white.
    ///
    /// See the [example](Luv#example).
    pub v: f32,
}

/// The largest chromaticity that leads to tristimulus values.
const MOST: f32 = 1e30;

shown_by_name!(Luv: "L*" l, "u*" u, "v*" v);

impl Xyz {
    /// Converts the color to CIELUV relative to `white`.
    ///
    /// The white must be on the same scale as the color. Unlike CIELAB, CIELUV accepts a white whose Z is
    /// zero.
    ///
    /// Black, and anything else without luminance, is (0, 0, 0). The result is `None` if the white has no
    /// luminance or no chromaticity (a component sum of zero or less), if the color has no chromaticity and
    /// is not black, or if L\* is beyond 2e37 in size. NaN stays NaN. See the [example](Luv#example).
    ///
    /// # Accuracy
    /// 9e-5 for all colors of surfaces, the most saturated included.
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
            let none = 0.0 * self.x.abs() + 0.0 * self.z.abs(); // 0, or NaN
            return Some(Luv { l: 0.0, u: none, v: none });
        }
        let [x, y, z] = fractions(self)?;
        let l = lightness(relative);
        let scale = 13.0 * l;
        if scale.is_infinite() {
            return None;
        }
        // u' - u'n and v' - v'n, without the terms that would cancel.
        let du = 60.0 * (x * yn - xn * y) + 12.0 * (x * zn - xn * z);
        let dv = 9.0 * (xn * y - x * yn) + 27.0 * (y * zn - yn * z);
        Some(Luv { l, u: scale * du, v: scale * dv })
    }
}

impl Luv {
    /// Makes a color from L\*, u\* and v\*.
    ///
    /// See the [example](Luv#example).
    #[must_use]
    pub const fn new(l: f32, u: f32, v: f32) -> Self {
        Luv { l, u, v }
    }

    /// Converts the color back to tristimulus values, on the scale of `white`.
    ///
    /// L\* = 0 is black. The result is `None` if the white has no chromaticity, or if v' of the color is not
    /// above zero, or u' or v' is beyond 1e30, which no light has. L\* beyond 1e12 in size overflows. See the
    /// [example](Luv#example).
    #[must_use]
    pub fn xyz(self, white: Xyz) -> Option<Xyz> {
        let [xn, yn, _] = fractions(white)?;
        if self.l == 0.0 {
            let none = 0.0 * self.u.abs() + 0.0 * self.v.abs(); // 0, or NaN
            return Some(Xyz { x: none, y: none, z: none });
        }
        let u = self.u / (13.0 * self.l) + 4.0 * xn;
        let v = self.v / (13.0 * self.l) + 9.0 * yn;
        if v <= 0.0 || v > MOST || u.abs() > MOST {
            return None;
        }
        let y = luminance(self.l, white.y);
        let part = y / (4.0 * v);
        Some(Xyz { x: 9.0 * u * part, y, z: (12.0 - 3.0 * u - 20.0 * v) * part })
    }
}

/// Divides X, Y, Z by X + 15 Y + 3 Z; the first of these is a quarter of u', the second a ninth of v'.
///
/// The result is `None` if the sum is not above zero, or is tiny because its terms cancel. No light is like
/// that.
fn fractions(color: Xyz) -> Option<[f32; 3]> {
    let (part, sum) = color.in_range(|Xyz { x, y, z }| x + 15.0 * y + 3.0 * z);
    if sum <= 0.0 {
        return None;
    }
    let parts = part.to_array().map(|v| v / sum);
    if parts.iter().any(|part| part.abs() > 1e6) { None } else { Some(parts) }
}
