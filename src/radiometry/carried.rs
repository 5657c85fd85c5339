//! What a quantity counts: watts, lumens, scotopic lumens, or watts for each nanometer.

use crate::grid::Grid;
use crate::spectrum::{Light, Spectrum};
use core::fmt;
use core::ops::{Add, Mul, Sub};

/// What [`Flux`](crate::radiometry::Flux) and its relatives can carry: [`Radiant`], [`Luminous`] or [`Scotopic`]
/// numbers, or a whole spectrum, [`Light`].
#[diagnostic::on_unimplemented(
    message = "`{Self}` is nothing that a flux carries",
    note = "use `Radiant`, `Luminous`, `Scotopic`, or `Light<N, G>` for a spectrum"
)]
pub trait Carried:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<f32, Output = Self> + sealed::Sealed
{
    /// No light at all.
    const NONE: Self;
    /// The column of the table of units.
    #[doc(hidden)]
    const UNITS: Units;
    /// Every number of it by a function.
    #[doc(hidden)]
    #[must_use]
    fn map(self, f: impl Fn(f32) -> f32) -> Self;
}

/// A column of the table of units.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub enum Units {
    Radiant,
    Luminous,
    Scotopic,
    Spectral,
}

mod sealed {
    pub trait Sealed {}
}

macro_rules! number {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[repr(transparent)]
        pub struct $name(pub f32);

        impl sealed::Sealed for $name {}

        impl Carried for $name {
            const NONE: Self = $name(0.0);
            const UNITS: Units = Units::$name;
            fn map(self, f: impl Fn(f32) -> f32) -> Self {
                $name(f(self.0))
            }
        }

        impl Add for $name {
            type Output = Self;
            fn add(self, other: Self) -> Self {
                $name(self.0 + other.0)
            }
        }

        impl Sub for $name {
            type Output = Self;
            fn sub(self, other: Self) -> Self {
                $name(self.0 - other.0)
            }
        }

        impl Mul<f32> for $name {
            type Output = Self;
            fn mul(self, k: f32) -> Self {
                $name(self.0 * k)
            }
        }

        impl fmt::Display for $name {
            /// The number alone: the unit comes with the quantity.
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                self.0.fmt(f)
            }
        }
    };
}

number! {
    /// Power as physics counts it: W, W/m2, W/sr, W/(m2 sr), J.
    Radiant
}

number! {
    /// Power as the eye counts it by day, weighted by 683.002 lm/W and V(lambda): lm, lx, cd, cd/m2.
    Luminous
}

number! {
    /// Power as the eye counts it in the dark, weighted by 1700 lm/W and V'(lambda).
    Scotopic
}

impl<const N: usize, G: Grid> sealed::Sealed for Light<N, G> {}

impl<const N: usize, G: Grid> Carried for Light<N, G> {
    const NONE: Self = Spectrum::flat(0.0);
    const UNITS: Units = Units::Spectral;
    fn map(mut self, f: impl Fn(f32) -> f32) -> Self {
        for value in self.values_mut() {
            *value = f(*value);
        }
        self
    }
}
