//! Defines what a quantity counts: watts, lumens, scotopic lumens, or watts per nanometer.

use crate::geometry::Integrand;
use crate::grid::{Bands, Kind};
use crate::math::linear_operators;
use crate::spectrum::Light;
use core::fmt;
use core::ops::{Neg, Sub};

/// A value that [`Flux`](crate::radiometry::Flux) and the other quantities can carry, which decides their
/// unit.
///
/// The library implements this trait for the numbers [`Radiant`], [`Luminous`] and [`Scotopic`], and for a
/// whole spectrum, [`Light`]. It cannot be implemented elsewhere. Write functions over it that shall accept
/// every unit.
///
/// # Example
/// ```
/// use nanospectra::radiometry::{Candela, Carried, Intensity, Irradiance, Radiant};
///
/// /// What one side of a desk receives from two lamps of the same kind, 2 m above it.
/// fn from_two<V: Carried>(lamp: Intensity<V>) -> Irradiance<V> {
///     lamp.at_distance(2.0, 1.0) * 2.0
/// }
/// assert_eq!(from_two(Candela::from(400.0)).to_string(), "200 lx");
/// assert_eq!(from_two(Intensity::new(Radiant(1.0))).to_string(), "0.5 W/m2");
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a value that a radiometric quantity can carry",
    note = "use `Radiant`, `Luminous`, `Scotopic`, or `Light<N, G>` for a spectrum or an RGB"
)]
pub trait Carried: Integrand + Sub<Output = Self> + Neg<Output = Self> + sealed::Sealed {
    /// The column of the table of units that holds the symbols for this value.
    #[doc(hidden)]
    const UNITS: Units;
}

/// A column of the table of units, for each kind of value that a quantity can carry.
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
            /// Writes the number alone, since the unit depends on the quantity that carries it.
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                self.0.fmt(f)
            }
        }
    };
}

number! {
    /// A number that counts watts, or another radiant unit such as W/m2, W/sr, W/(m2 sr) or J.
    ///
    /// The quantity that carries the number decides the unit.
    ///
    /// # Example
    /// ```
    /// use nanospectra::radiometry::{Irradiance, Radiant};
    /// let sun = Irradiance::new(Radiant(1000.0));
    /// assert_eq!(sun.to_string(), "1000 W/m2");
    /// assert_eq!(sun.flux(1.5).value(), Radiant(1500.0)); // in W, on 1.5 m2
    /// ```
    Radiant
}

number! {
    /// A number that counts lumens, or another photometric unit such as lx, cd or cd/m2.
    ///
    /// It counts power as the daylight-adapted eye weights it, by V(lambda) and 683.002 lm/W. The quantity
    /// that carries the number decides the unit.
    ///
    /// # Example
    /// ```
    /// use nanospectra::radiometry::{Flux, Luminous};
    /// let bulb = Flux::new(Luminous(800.0));
    /// assert_eq!(bulb.to_string(), "800 lm");
    /// assert_eq!(bulb.irradiance(4.0).to_string(), "200 lx"); // spread evenly over 4 m2
    /// ```
    Luminous
}

number! {
    /// A number that counts scotopic lumens, or another scotopic unit such as scotopic lx.
    ///
    /// It counts power as the dark-adapted eye weights it, by V'(lambda) and 1700 lm/W. The quantity that
    /// carries the number decides the unit.
    ///
    /// # Example
    /// ```
    /// use nanospectra::radiometry::{Irradiance, Scotopic};
    /// let moonlight = Irradiance::new(Scotopic(0.5));
    /// assert_eq!(moonlight.to_string(), "0.5 scotopic lx");
    /// ```
    Scotopic
}

impl<const N: usize, G: Bands> sealed::Sealed for Light<N, G> {}

impl<const N: usize, G: Bands> Carried for Light<N, G> {
    const UNITS: Units = match G::KIND {
        Kind::Wavelengths { .. } => Units::Spectral,
        Kind::Colors(_) => Units::Radiant,
    };
}

/// Returns the number itself, or the largest f32 of its sign if it is infinite. NaN stays NaN.
#[inline]
pub(super) fn finite(x: f32) -> f32 {
    if x.is_infinite() { f32::MAX.copysign(x) } else { x }
}

/// Returns a quotient that is never infinite, and 0 for zero over zero.
#[inline]
pub(super) fn ratio(part: f32, whole: f32) -> f32 {
    if part == 0.0 && whole == 0.0 { 0.0 } else { finite(part / whole) }
}

/// Returns a value divided by a number, by the rule of [`ratio`].
#[inline]
pub(super) fn over<V: Carried>(value: V, whole: f32) -> V {
    value.map(|part| ratio(part, whole))
}
