//! How near a solved spectrum comes to the color that was asked for.

use crate::color::{Cie94Weights, Xyz, cie76, cie94};

/// A spectrum together with a status that says how near its color is to the one that was asked for.
///
/// The functions of [`Sigmoid`](crate::upsample::Sigmoid) return it; see the
/// [example](crate::upsample#example).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Solved<T> {
    /// The spectrum that was found, as the numbers that describe its curve.
    pub spectrum: T,
    /// Whether the spectrum has the color that was asked for, and if not, how near it is.
    pub status: Status,
}

/// How near the color of a solved spectrum is to the one that was asked for.
///
/// See the [example](crate::upsample::Sigmoid::new) for colors out of reach.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Status {
    /// The spectrum has the color, within 0.002 CIEDE2000.
    ///
    /// Colors whose X, Y and Z are all below a thousandth of those of white are compared as if they were
    /// brighter, since any two of them would look alike.
    Exact,
    /// No sigmoid was found for the color, and the spectrum has a less saturated color of the same luminance
    /// instead.
    ///
    /// Its color lies on the straight line from the gray of that luminance to the color that was asked for.
    /// If there is no such gray, it is black or white.
    /// [`Sigmoid::desaturated`](crate::upsample::Sigmoid::desaturated) returns it.
    Desaturated {
        /// How far from the gray towards the color the spectrum's color lies, within 0..1.
        kept: f32,
        /// The color that was asked for and the one that the spectrum has.
        miss: Miss,
    },
    /// No sigmoid was found within 0.002 CIEDE2000 of the color, and the spectrum is the nearest that was
    /// found in this sense.
    ///
    /// The search covers sigmoids with a scale, as bright and dark colors use them, and all without. Its
    /// accuracy and how rarely it fails are told by
    /// [`Sigmoid`](crate::upsample::Sigmoid#colors-out-of-reach).
    Unreachable(Miss),
    /// A component is NaN or infinite, or so large that the spectrum would be infinite; the spectrum is NaN.
    NotFinite,
}

/// The color that was asked for and the one that the spectrum has, with Y = 100 for white.
///
/// # Example
/// ```
/// use nanospectra::color::Xyz;
/// use nanospectra::upsample::Miss;
/// let white = Xyz::new(95.047, 100.0, 108.883);
/// let miss = Miss { asked: white, given: white.scaled(0.5), white };
/// // The two differ in lightness alone: L* is 100 and 116 * cbrt(0.5) - 16 = 76.07.
/// assert!((miss.delta_e76() - 23.93).abs() < 0.01);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Miss {
    /// The color that was asked for.
    pub asked: Xyz,
    /// The color that the spectrum has.
    pub given: Xyz,
    /// The color of white, against which both are seen.
    pub white: Xyz,
}

impl Miss {
    /// Returns the CIEDE2000 difference between the color that was asked for and the one that the spectrum
    /// has.
    ///
    /// It is NaN for components of 1e16 and beyond, for which f32 cannot compute it.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn delta_e(&self) -> f32 {
        self.asked.delta_e(self.given, self.white)
    }

    /// Returns whether the two are within 0.002 CIEDE2000. It is decided by a formula (CIE94) that needs no
    /// functions but roots, and whose value is at least half of CIEDE2000 here.
    pub(super) fn is_nothing(&self) -> bool {
        match (self.asked.lab(self.white), self.given.lab(self.white)) {
            (Some(asked), Some(given)) => cie94(asked, given, Cie94Weights::GraphicArts) < 0.001,
            _ => false,
        }
    }

    /// Returns the CIE 1976 color difference between the two colors, which is computed without a math
    /// backend.
    ///
    /// It is infinite or NaN for components of 1e16 and beyond. See the [example](#example).
    #[must_use]
    pub fn delta_e76(&self) -> f32 {
        match (self.asked.lab(self.white), self.given.lab(self.white)) {
            (Some(asked), Some(given)) => cie76(asked, given),
            _ => f32::NAN,
        }
    }
}

impl<T> Solved<T> {
    pub(super) fn map<U>(self, f: impl FnOnce(T) -> U) -> Solved<U> {
        Solved { spectrum: f(self.spectrum), status: self.status }
    }
}
