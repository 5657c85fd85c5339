//! What a color looks like: its attributes, and its place in a uniform space.

use crate::math::sqrt;
use crate::tristimulus::shown_by_name;

/// The attributes of a color as it is seen, as a color appearance model gives them.
///
/// [`ViewingConditions::appearance`](crate::color::ViewingConditions::appearance) computes it. Lightness and
/// chroma are judged beside the white of the scene, brightness and colorfulness on their own.
///
/// # Example
/// ```
/// # #[cfg(feature = "libm")] {
/// use nanospectra::color::{Ciecam02, Surround, ViewingConditions, Xyz};
/// // The worked example of CIE 159:2004.
/// let white = Xyz::new(98.88, 90.0, 32.03);
/// let seen = ViewingConditions::<Ciecam02>::new(white, 200.0, 18.0, Surround::Average).unwrap();
/// let color = seen.appearance(Xyz::new(19.31, 23.93, 10.14)).unwrap();
/// assert!((color.j - 48.0314).abs() < 1e-4 && (color.c - 38.7789).abs() < 1e-4);
/// assert!((color.h_deg - 191.0452).abs() < 1e-4 && (color.q - 183.1240).abs() < 4e-4);
/// assert!((color.m - 38.7789).abs() < 1e-4 && (color.s - 46.0177).abs() < 1e-4);
/// # }
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Appearance {
    /// The lightness J, which is 0 for black and 100 for the white.
    ///
    /// See the [example](Appearance#example).
    pub j: f32,
    /// The chroma C, which is the colorfulness in proportion to the brightness of the white.
    ///
    /// See the [example](Appearance#example).
    pub c: f32,
    /// The hue angle h, which is given in degrees, `0.0 <= h_deg < 360.0`, and is 0 for a gray.
    ///
    /// See the [example](Appearance#example).
    pub h_deg: f32,
    /// The brightness Q, which is 0 for black and grows with the luminance of the scene.
    ///
    /// See the [example](Appearance#example).
    pub q: f32,
    /// The colorfulness M, which is 0 for a gray and grows with the luminance of the scene.
    ///
    /// See the [example](Appearance#example).
    pub m: f32,
    /// The saturation s, which is the colorfulness in proportion to the color's own brightness.
    ///
    /// See the [example](Appearance#example).
    pub s: f32,
}

shown_by_name!(Appearance: "J" j, "C" c, "h" h_deg);

/// A color that is given in the uniform space of an appearance model, CAM02-UCS or CAM16-UCS.
///
/// [`ViewingConditions::ucs`](crate::color::ViewingConditions::ucs) computes it, and
/// [`ViewingConditions::xyz_of_ucs`](crate::color::ViewingConditions::xyz_of_ucs) leads back.
///
/// # Reference
/// M. R. Luo, G. Cui, C. Li, "Uniform colour spaces based on CIECAM02 colour appearance model", 2006.
///
/// # Example
/// ```
/// # #[cfg(feature = "libm")] {
/// use nanospectra::color::{Cam16, CamUcs, Surround, ViewingConditions, Xyz};
/// let white = Xyz::new(95.05, 100.0, 108.88);
/// let seen = ViewingConditions::<Cam16>::new(white, 318.31, 20.0, Surround::Average).unwrap();
/// let color = seen.ucs(Xyz::new(57.06, 43.06, 31.96)).unwrap();
/// assert!((color.distance(CamUcs::new(color.j, color.a + 3.0, color.b - 4.0)) - 5.0).abs() < 1e-5);
/// let back = seen.xyz_of_ucs(color).unwrap();
/// assert!((back.x - 57.06).abs() < 1e-3 && (back.y - 43.06).abs() < 1e-3 && (back.z - 31.96).abs() < 1e-3);
/// # }
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CamUcs {
    /// The lightness J', which is 0 for black and 100 for the white.
    ///
    /// See the [example](CamUcs#example).
    pub j: f32,
    /// The coordinate a', which goes from green (negative) to red.
    ///
    /// See the [example](CamUcs#example).
    pub a: f32,
    /// The coordinate b', which goes from blue (negative) to yellow.
    ///
    /// See the [example](CamUcs#example).
    pub b: f32,
}

shown_by_name!(CamUcs: "J'" j, "a'" a, "b'" b);

impl CamUcs {
    /// Makes a color from J', a' and b'.
    ///
    /// See the [example](CamUcs#example).
    #[must_use]
    pub const fn new(j: f32, a: f32, b: f32) -> Self {
        CamUcs { j, a, b }
    }

    /// Computes the color difference to another color, which is the distance of both in this space.
    ///
    /// See the [example](CamUcs#example).
    #[must_use]
    pub fn distance(self, other: Self) -> f32 {
        let d = [self.j - other.j, self.a - other.a, self.b - other.b];
        sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2])
    }
}
