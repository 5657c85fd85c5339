//! Tristimulus values, and the chromaticity coordinates that are computed from them.

use crate::math::linear_operators;
use core::fmt;

/// CIE tristimulus values X, Y, Z, from which every other description of a color is computed.
///
/// They come from an observer, by `Xyz::from(CIE_1931.sees(&light))`, or from a table, by [`Xyz::new`]. What
/// one asks for next is the chromaticity ([`Xyz::xy`]), the color temperature of a light ([`Xyz::cct`]),
/// CIELAB for a surface ([`Xyz::lab`]), or the pixel of a display
/// ([`Rgb::from_xyz`](crate::color::Rgb::from_xyz)).
///
/// Y is 100 for a perfect white surface, and for a light whose absolute power does not matter
/// ([`Xyz::with_y`]). All conversions to and from RGB, Oklab and displays expect this scale. Absolute values
/// are in lm, lx or cd/m2; an observer scaled by [`KM`](crate::observer::KM) reports these.
///
/// # Example
/// ```
/// use nanospectra::color::Xyz;
/// let d65 = Xyz::new(95.047, 100.0, 108.883);
/// assert_eq!(d65.y, 100.0);
/// assert_eq!(format!("{d65:.1}"), "X 95.0 Y 100.0 Z 108.9");
///
/// // A gray card that reflects half of this light.
/// let card = d65.scaled(0.5);
/// assert_eq!(card.to_array(), [d65.x / 2.0, 50.0, d65.z / 2.0]);
/// assert_eq!(card.with_y(100.0).map(|light| light.x), Some(d65.x));
///
/// // The chromaticity of D65, as CIE 15 tabulates it.
/// let uv = d65.uv1976().ok_or("black")?;
/// assert!((uv.u - 0.1978).abs() < 5e-5 && (uv.v - 0.4683).abs() < 5e-5);
/// assert_eq!(Xyz::new(0.0, 0.0, 0.0).xy(), None); // black has no chromaticity
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Xyz {
    /// The X value, which is the light weighted by the color-matching function x-bar.
    ///
    /// See the [example](Xyz#example).
    pub x: f32,
    /// The Y value, which is the light weighted by y-bar: the luminance of a light, or the luminous
    /// reflectance of a surface in percent.
    ///
    /// See the [example](Xyz#example).
    pub y: f32,
    /// The Z value, which is the light weighted by the color-matching function z-bar.
    ///
    /// See the [example](Xyz#example).
    pub z: f32,
}

/// Chromaticity coordinates x, y, which describe a color without its luminance.
///
/// They belong to the observer that gave the tristimulus values: the CIE 1931 observer, if nothing else is
/// said. [`Xyz::xy`] computes them, and [`Xy::xyz`] leads back.
///
/// # Example
/// ```
/// use nanospectra::color::Xy;
/// let a = Xy::new(0.44758, 0.40745); // illuminant A, CIE 15
/// let xyz = a.xyz(100.0).ok_or("no luminance")?;
/// assert!((xyz.x - 109.85).abs() < 0.01 && (xyz.z - 35.58).abs() < 0.01);
///
/// let (uv, uv_1976) = (a.uv1960(), a.uv1976());
/// assert!((uv.u - 0.2560).abs() < 5e-5 && (uv.v - 0.3495).abs() < 5e-5);
/// assert!((uv_1976.u - 0.2560).abs() < 5e-5 && (uv_1976.v - 0.5243).abs() < 5e-5);
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Xy {
    /// The coordinate x, which is X / (X + Y + Z).
    pub x: f32,
    /// The coordinate y, which is Y / (X + Y + Z).
    pub y: f32,
}

/// CIE 1960 UCS coordinates u, v, the plane in which CCT and Duv are defined.
///
/// [`Uv1960::cct`] finds the correlated color temperature of this chromaticity.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Uv1960 {
    /// The coordinate u, which is 4 X / (X + 15 Y + 3 Z).
    ///
    /// See the [example](Xy#example).
    pub u: f32,
    /// The coordinate v, which is 6 Y / (X + 15 Y + 3 Z).
    ///
    /// See the [example](Xy#example).
    pub v: f32,
}

/// CIE 1976 UCS coordinates u', v', in which equal distances look more nearly alike than in x, y.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Uv1976 {
    /// The coordinate u', which is 4 X / (X + 15 Y + 3 Z).
    ///
    /// See the [example](Xy#example).
    pub u: f32,
    /// The coordinate v', which is 9 Y / (X + 15 Y + 3 Z).
    ///
    /// See the [example](Xy#example).
    pub v: f32,
}

impl From<[f32; 3]> for Xyz {
    /// Takes the three numbers that an observer of X, Y, Z reports.
    fn from([x, y, z]: [f32; 3]) -> Self {
        Xyz { x, y, z }
    }
}

impl Xyz {
    /// Makes tristimulus values from X, Y and Z.
    ///
    /// See the [example](Xyz#example).
    #[must_use]
    pub const fn new(x: f32, y: f32, z: f32) -> Self {
        Xyz { x, y, z }
    }

    /// Returns the three values as the array `[X, Y, Z]`.
    ///
    /// See the [example](Xyz#example).
    #[must_use]
    pub const fn to_array(self) -> [f32; 3] {
        [self.x, self.y, self.z]
    }

    /// Multiplies X, Y and Z by `k`, which keeps the chromaticity.
    ///
    /// See the [example](Xyz#example).
    #[must_use]
    pub const fn scaled(self, k: f32) -> Self {
        Xyz { x: self.x * k, y: self.y * k, z: self.z * k }
    }

    /// Returns a sum over X, Y and Z, and the color that it was taken of: this one, or a part of it if the
    /// sum would overflow.
    #[inline(always)]
    pub(crate) fn in_range(self, sum: impl Fn(Self) -> f32) -> (Self, f32) {
        let whole = sum(self);
        if whole <= f32::MAX {
            return (self, whole);
        }
        let part = self.scaled(1.0 / 32.0);
        (part, sum(part))
    }

    /// Returns the color that has the same chromaticity and whose Y is `y`.
    ///
    /// `with_y(100.0)` brings a light to the scale on which it is its own white. The result is `None` when
    /// Y cannot be scaled because it is zero or negative. See the [example](Xyz#example).
    #[must_use]
    pub fn with_y(self, y: f32) -> Option<Self> {
        if self.y <= 0.0 {
            return None;
        }
        let kept = if self.y.is_nan() { self.y } else { y };
        Some(Xyz { x: y * (self.x / self.y), y: kept, z: y * (self.z / self.y) })
    }

    /// Computes the chromaticity coordinates x, y.
    ///
    /// The result is `None` for black, where X + Y + Z is not above zero. NaN stays NaN.
    ///
    /// # Example
    /// ```
    /// # use nanospectra::color::Xyz;
    /// let d65 = Xyz::new(95.047, 100.0, 108.883).xy().ok_or("black")?;
    /// assert!((d65.x - 0.3127).abs() < 5e-5 && (d65.y - 0.3290).abs() < 5e-5); // CIE 15
    /// # Ok::<(), &str>(())
    /// ```
    #[must_use]
    pub fn xy(self) -> Option<Xy> {
        let sum = |Xyz { x, y, z }| x + y + z;
        let (Xyz { x, y, .. }, sum) = self.in_range(sum);
        if sum <= 0.0 {
            return None;
        }
        Some(Xy { x: x / sum, y: y / sum })
    }

    /// Computes the coordinates u, v of the CIE 1960 diagram, in which color temperatures are found.
    ///
    /// The result is `None` for black. NaN stays NaN.
    #[must_use]
    pub fn uv1960(self) -> Option<Uv1960> {
        let sum = |Xyz { x, y, z }| x + 15.0 * y + 3.0 * z;
        let (Xyz { x, y, .. }, sum) = self.in_range(sum);
        if sum <= 0.0 {
            return None;
        }
        Some(Uv1960 { u: 4.0 * (x / sum), v: 6.0 * y / sum })
    }

    /// Computes the coordinates u', v' of the CIE 1976 diagram.
    ///
    /// The result is `None` for black. NaN stays NaN. See the [example](Xyz#example).
    #[must_use]
    pub fn uv1976(self) -> Option<Uv1976> {
        self.uv1960().map(|p| Uv1976 { u: p.u, v: 1.5 * p.v })
    }
}

// The tristimulus values of lights that shine together add up.
linear_operators! {
    [] Xyz, Xyz::default();
    |a, b| { Xyz { x: a.x + b.x, y: a.y + b.y, z: a.z + b.z } } { Xyz { x: a.x - b.x, y: a.y - b.y, z: a.z - b.z } }
    { a.scaled(*b) } { Xyz { x: a.x / b, y: a.y / b, z: a.z / b } } { Xyz { x: -a.x, y: -a.y, z: -a.z } }
}

impl Xy {
    /// Makes a chromaticity from its coordinates x and y.
    ///
    /// See the [example](Xy#example).
    #[must_use]
    pub const fn new(x: f32, y: f32) -> Self {
        Xy { x, y }
    }

    /// Returns the tristimulus values that have this chromaticity and the luminance `y`.
    ///
    /// The result is `None` on the alychne, the line y = 0, where no color has luminance. See the
    /// [example](Xy#example).
    #[must_use]
    pub fn xyz(self, y: f32) -> Option<Xyz> {
        if self.y == 0.0 {
            return None;
        }
        Some(Xyz { x: y * (self.x / self.y), y, z: y * ((1.0 - self.x - self.y) / self.y) })
    }

    /// Converts the chromaticity to the coordinates u, v of the CIE 1960 diagram.
    ///
    /// See the [example](Xy#example).
    #[must_use]
    pub fn uv1960(self) -> Uv1960 {
        let d = 12.0 * self.y - 2.0 * self.x + 3.0;
        Uv1960 { u: 4.0 * self.x / d, v: 6.0 * self.y / d }
    }

    /// Converts the chromaticity to the coordinates u', v' of the CIE 1976 diagram.
    ///
    /// See the [example](Xy#example).
    #[must_use]
    pub fn uv1976(self) -> Uv1976 {
        let Uv1960 { u, v } = self.uv1960();
        Uv1976 { u, v: 1.5 * v }
    }
}

impl Uv1960 {
    /// Converts the chromaticity to the coordinates x, y of the CIE 1931 diagram.
    ///
    /// See the [example](crate::color::Uv1960::planckian).
    #[must_use]
    pub fn xy(self) -> Xy {
        let d = 2.0 * self.u - 8.0 * self.v + 4.0;
        Xy { x: 3.0 * self.u / d, y: 2.0 * self.v / d }
    }

    /// Converts the chromaticity to the coordinates u', v' of the CIE 1976 diagram, which has v' = 1.5 v.
    #[must_use]
    pub fn uv1976(self) -> Uv1976 {
        Uv1976 { u: self.u, v: 1.5 * self.v }
    }
}

/// Implements `Display` as in `X 95.047 Y 100 Z 108.883`: each number follows its name, and the format's
/// width and precision apply to each number.
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
