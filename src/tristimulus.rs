//! Tristimulus values and the chromaticities made from them.

use crate::math::linear_operators;
use core::fmt;

/// CIE tristimulus values.
///
/// Y is 100 for a perfect white surface and for a light that is given relative to itself ([`Xyz::with_y`]):
/// all conversions to and from RGB, Oklab and displays are on this scale. Absolute values are in lm, lx or
/// cd/m2 (through [`KM`](crate::observer::KM)).
///
/// ```
/// use nanospectra::color::Xyz;
/// let d65 = Xyz::new(95.047, 100.0, 108.883);
/// assert_eq!(format!("{d65:.1}"), "X 95.0 Y 100.0 Z 108.9");
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Xyz {
    /// X
    pub x: f32,
    /// Y, the luminance or luminous reflectance.
    pub y: f32,
    /// Z
    pub z: f32,
}

/// CIE 1931 (or 1964, ..) chromaticity coordinates x, y.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Xy {
    /// x = X / (X + Y + Z)
    pub x: f32,
    /// y = Y / (X + Y + Z)
    pub y: f32,
}

/// CIE 1960 UCS coordinates u, v: the plane in which CCT and Duv are defined.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Uv1960 {
    /// u = 4 X / (X + 15 Y + 3 Z)
    pub u: f32,
    /// v = 6 Y / (X + 15 Y + 3 Z)
    pub v: f32,
}

/// CIE 1976 UCS coordinates u', v'.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Uv1976 {
    /// u' = 4 X / (X + 15 Y + 3 Z)
    pub u: f32,
    /// v' = 9 Y / (X + 15 Y + 3 Z)
    pub v: f32,
}

impl From<[f32; 3]> for Xyz {
    /// The three numbers an XYZ observer returns.
    fn from([x, y, z]: [f32; 3]) -> Self {
        Xyz { x, y, z }
    }
}

impl Xyz {
    /// X, Y, Z.
    #[must_use]
    pub const fn new(x: f32, y: f32, z: f32) -> Self {
        Xyz { x, y, z }
    }

    /// `[X, Y, Z]`.
    #[must_use]
    pub const fn to_array(self) -> [f32; 3] {
        [self.x, self.y, self.z]
    }

    /// All three times `k`.
    #[must_use]
    pub const fn scaled(self, k: f32) -> Self {
        Xyz { x: self.x * k, y: self.y * k, z: self.z * k }
    }

    /// The same chromaticity with luminance `y`: a relative light has `with_y(100.0)`.
    ///
    /// `None` when there is no luminance to scale (Y is zero or negative).
    #[must_use]
    pub fn with_y(self, y: f32) -> Option<Self> {
        if self.y <= 0.0 {
            return None;
        }
        let kept = if self.y.is_nan() { self.y } else { y };
        Some(Xyz { x: y * (self.x / self.y), y: kept, z: y * (self.z / self.y) })
    }

    /// Chromaticity x, y; `None` for black (X + Y + Z not above zero). NaN stays NaN.
    ///
    /// ```
    /// # use nanospectra::color::Xyz;
    /// let d65 = Xyz::new(95.047, 100.0, 108.883).xy().ok_or("black")?;
    /// assert!((d65.x - 0.3127).abs() < 5e-5 && (d65.y - 0.3290).abs() < 5e-5); // CIE 15
    /// # Ok::<(), &str>(())
    /// ```
    #[must_use]
    pub fn xy(self) -> Option<Xy> {
        let sum = self.x + self.y + self.z;
        if sum <= 0.0 {
            return None;
        }
        Some(Xy { x: self.x / sum, y: self.y / sum })
    }

    /// CIE 1960 u, v; `None` for black. NaN stays NaN.
    #[must_use]
    pub fn uv1960(self) -> Option<Uv1960> {
        let sum = self.x + 15.0 * self.y + 3.0 * self.z;
        if sum <= 0.0 {
            return None;
        }
        Some(Uv1960 { u: 4.0 * self.x / sum, v: 6.0 * self.y / sum })
    }

    /// CIE 1976 u', v'; `None` for black. NaN stays NaN.
    #[must_use]
    pub fn uv1976(self) -> Option<Uv1976> {
        self.uv1960().map(|p| Uv1976 { u: p.u, v: 1.5 * p.v })
    }
}

// Lights that shine together.
linear_operators! {
    [] Xyz, Xyz::default();
    |a, b| { Xyz { x: a.x + b.x, y: a.y + b.y, z: a.z + b.z } } { Xyz { x: a.x - b.x, y: a.y - b.y, z: a.z - b.z } }
    { a.scaled(*b) } { Xyz { x: a.x / b, y: a.y / b, z: a.z / b } } { Xyz { x: -a.x, y: -a.y, z: -a.z } }
}

impl Xy {
    /// x, y.
    #[must_use]
    pub const fn new(x: f32, y: f32) -> Self {
        Xy { x, y }
    }

    /// The color of this chromaticity with luminance `y`; `None` on the alychne (y = 0).
    #[must_use]
    pub fn xyz(self, y: f32) -> Option<Xyz> {
        if self.y == 0.0 {
            return None;
        }
        Some(Xyz { x: y * (self.x / self.y), y, z: y * ((1.0 - self.x - self.y) / self.y) })
    }

    /// The same point in the CIE 1960 diagram.
    #[must_use]
    pub fn uv1960(self) -> Uv1960 {
        let d = 12.0 * self.y - 2.0 * self.x + 3.0;
        Uv1960 { u: 4.0 * self.x / d, v: 6.0 * self.y / d }
    }

    /// The same point in the CIE 1976 diagram.
    #[must_use]
    pub fn uv1976(self) -> Uv1976 {
        let Uv1960 { u, v } = self.uv1960();
        Uv1976 { u, v: 1.5 * v }
    }
}

/// `X 95.047 Y 100 Z 108.883`: each number with its name, in the format that is asked for.
macro_rules! shown_by_name {
    ($type:ty: $($name:literal $part:ident),+) => {
        impl core::fmt::Display for $type {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                $crate::tristimulus::by_name(f, &[$(($name, self.$part)),+])
            }
        }
    };
}
pub(crate) use shown_by_name;

pub(crate) fn by_name(f: &mut fmt::Formatter<'_>, numbers: &[(&str, f32)]) -> fmt::Result {
    for (k, (name, number)) in numbers.iter().enumerate() {
        f.write_str(if k == 0 { "" } else { " " })?;
        f.write_str(name)?;
        f.write_str(" ")?;
        fmt::Display::fmt(number, f)?;
    }
    Ok(())
}

shown_by_name!(Xyz: "X" x, "Y" y, "Z" z);
shown_by_name!(Xy: "x" x, "y" y);
shown_by_name!(Uv1960: "u" u, "v" v);
shown_by_name!(Uv1976: "u'" u, "v'" v);
