//! How well a color could be met.

use crate::color::{Cie94Weights, Xyz, cie76, cie94};

/// A spectrum and how near it is to what was asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Solved<T> {
    /// The spectrum.
    pub spectrum: T,
    /// Whether it has the color, and if not, how near it is.
    pub status: Status,
}

/// How near the color of a solved spectrum is to the one that was asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Status {
    /// The spectrum has the color, within 0.002 CIEDE2000.
    Exact,
    /// No sigmoid has the color. This one lies on the way to it from the gray of its luminance, or is black
    /// or white where there is no such gray.
    Desaturated {
        /// How much of the way from gray to the color, 0..1.
        kept: f32,
        /// The color of this spectrum, beside the one that was asked for.
        miss: Miss,
    },
    /// No sigmoid has the color; this one is near, by least squares. (Next to the limit of what sigmoids have
    /// f32 cannot tell: this may then be as near as 0.0005, or as far as 0.2 where f64 finds an exact one.)
    Unreachable(Miss),
    /// A component is NaN or infinite, or so large that the spectrum would be; the spectrum is NaN.
    NotFinite,
}

/// Two colors: the one asked for and the one the spectrum has; Y = 100 for white.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Miss {
    /// The color that was asked for.
    pub asked: Xyz,
    /// The color that the spectrum has.
    pub given: Xyz,
    /// The white that both are seen against.
    pub white: Xyz,
}

impl Miss {
    /// CIEDE2000 between the two; NaN for components so large that f32 cannot say (1e16 and beyond).
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn delta_e(&self) -> f32 {
        self.asked.delta_e(self.given, self.white)
    }

    /// Are the two within 0.002 CIEDE2000? By a formula that needs no more than roots, and comes to half of
    /// that or more.
    pub(super) fn is_nothing(&self) -> bool {
        match (self.asked.lab(self.white), self.given.lab(self.white)) {
            (Some(asked), Some(given)) => cie94(asked, given, Cie94Weights::GraphicArts) < 0.001,
            _ => false,
        }
    }

    /// The CIE 1976 difference between the two, which needs no more than roots; infinite, or NaN, for
    /// components of 1e16 and beyond.
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
