//! What a quantity counts: watts, lumens, scotopic lumens, or watts for each nanometer.

use crate::geometry::Integrand;
use crate::grid::{Bands, Kind};
use crate::math::linear_operators;
use crate::spectrum::Light;
use core::fmt;
use core::ops::{Neg, Sub};

/// What [`Flux`](crate::radiometry::Flux) and its relatives can carry: [`Radiant`], [`Luminous`] or
/// [`Scotopic`] numbers, or a whole spectrum, [`Light`].
#[diagnostic::on_unimplemented(
    message = "`{Self}` is nothing that a flux carries",
    note = "use `Radiant`, `Luminous`, `Scotopic`, or `Light<N, G>` for a spectrum or an RGB"
)]
pub trait Carried: Integrand + Sub<Output = Self> + Neg<Output = Self> + sealed::Sealed {
    /// The column of the table of units.
    #[doc(hidden)]
    const UNITS: Units;
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
            const UNITS: Units = Units::$name;
        }

        impl Integrand for $name {
            const ZERO: Self = $name(0.0);

            fn accumulate(&mut self, lost: &mut Self, value: &Self) {
                self.0.accumulate(&mut lost.0, &value.0);
            }

            fn map(self, f: impl Fn(f32) -> f32) -> Self {
                $name(f(self.0))
            }

            fn peak(&self) -> f32 {
                self.0
            }

            fn distance(&self, other: &Self) -> f32 {
                self.0.distance(&other.0)
            }
        }

        linear_operators! {
            [] $name, $name(0.0);
            |a, b| { $name(a.0 + b.0) } { $name(a.0 - b.0) } { $name(a.0 * b) } { $name(a.0 / b) } { $name(-a.0) }
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

impl<const N: usize, G: Bands> sealed::Sealed for Light<N, G> {}

impl<const N: usize, G: Bands> Carried for Light<N, G> {
    const UNITS: Units = match G::KIND {
        Kind::Wavelengths { .. } => Units::Spectral,
        Kind::Colors(_) => Units::Radiant,
    };
}

/// The largest f32 for what is larger; NaN stays.
#[inline]
pub(super) fn finite(x: f32) -> f32 {
    if x.is_infinite() { f32::MAX.copysign(x) } else { x }
}

/// A quotient that is always finite: nothing over anything is nothing.
#[inline]
pub(super) fn ratio(part: f32, whole: f32) -> f32 {
    if part == 0.0 && whole == 0.0 { 0.0 } else { finite(part / whole) }
}

/// A quantity over a number.
#[inline]
pub(super) fn over<V: Carried>(value: V, whole: f32) -> V {
    value.map(|part| ratio(part, whole))
}
