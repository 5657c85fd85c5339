//! How well a colour could be met.

#[cfg(feature = "libm")]
use crate::color::ciede2000;
use crate::color::{Xyz, cie76};

/// A spectrum and how near it is to what was asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Solved<T> {
    /// The spectrum.
    pub spectrum: T,
    /// Has it the colour?
    pub status: Status,
}

/// Has the spectrum the colour that was asked for?
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Status {
    /// Yes: within 0.002 CIEDE2000 from 31 bands on, 0.005 on 16.
    Exact,
    /// No sigmoid has it; this one has its luminance and part of its distance from grey.
    Desaturated {
        /// How much of the way from grey to the colour, 0..1.
        kept: f32,
    },
    /// No sigmoid has it, or none was found; this one comes near. (At the very limit of what sigmoids have f32
    /// decides, and a colour in a few hundred is within 0.002 all the same.)
    Unreachable(Miss),
    /// A component is NaN or infinite; the spectrum is NaN.
    NotFinite,
}

/// Two colours: the one asked for and the one the spectrum has; Y = 1 for white.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Miss {
    /// Asked for.
    pub asked: Xyz,
    /// What the spectrum has.
    pub given: Xyz,
    /// The white both are seen against.
    pub white: Xyz,
}

impl Miss {
    /// CIEDE2000 between the two.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn delta_e(&self) -> f32 {
        match (self.asked.lab(self.white), self.given.lab(self.white)) {
            (Some(asked), Some(given)) => ciede2000(asked, given),
            _ => f32::NAN,
        }
    }

    /// The CIE 1976 difference between the two, which needs no more than roots.
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
