//! The quantities of radiometry as types: what is added must be of one kind.

use crate::grid::{Bands, Grid};
use crate::math::{assigning_operator, linear_operators, operator};
use crate::observer::{KM, KM_SCOTOPIC, Observer, V_PHOTOPIC, V_SCOTOPIC};
use crate::radiometry::carried::{Units, over};
use crate::radiometry::{Carried, Luminous, Radiant, Scotopic};
use crate::spectrum::{Factor, Fine, Light, Power, Spectrum};
use core::fmt;

macro_rules! quantity {
    ($(#[$doc:meta])* $name:ident: $radiant:literal, $luminous:literal, $scotopic:literal, $spectral:literal) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[repr(transparent)]
        pub struct $name<V>(V);

        impl<V: Carried> $name<V> {
            /// No light: the value 0, in every bin of a spectrum.
            pub const NONE: Self = $name(V::ZERO);

            /// The symbol of the unit: `"W/m2"`, `"lx"`, `"W/(m2 nm)"`.
            pub const UNIT: &'static str = match V::UNITS {
                Units::Radiant => $radiant,
                Units::Luminous => $luminous,
                Units::Scotopic => $scotopic,
                Units::Spectral => $spectral,
            };

            /// A quantity of this value (`Luminous(800.0)`, a `Light`), in the unit [`UNIT`](Self::UNIT).
            #[must_use]
            pub const fn new(value: V) -> Self {
                $name(value)
            }

            /// The value that it carries, in the unit [`UNIT`](Self::UNIT).
            #[must_use]
            pub const fn value(self) -> V {
                self.0
            }
        }

        linear_operators! {
            [V: Carried] $name<V>, Self::NONE;
            |a, b| { $name(a.0 + b.0) } { $name(a.0 - b.0) } { $name(a.0 * *b) } { $name(over(a.0, *b)) } { $name(-a.0) }
        }

        // What a filter lets through, what a surface sends back.
        assigning_operator! {
            [const N: usize, G: Bands] Mul mul MulAssign mul_assign
            |a: $name<Light<N, G>>, b: Spectrum<Factor, N, G>| { $name(a.0 * b) }
        }
        operator! {
            [const N: usize, G: Bands] Mul mul
            |a: Spectrum<Factor, N, G>, b: $name<Light<N, G>>| -> $name<Light<N, G>> { $name(b.0 * a) }
        }

        impl<V: Carried + fmt::Display> fmt::Display for $name<V> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                self.0.fmt(f)?;
                f.write_str(" ")?;
                f.write_str(Self::UNIT)
            }
        }

        impl From<f32> for $name<Radiant> {
            fn from(value: f32) -> Self {
                $name(Radiant(value))
            }
        }

        impl From<f32> for $name<Luminous> {
            fn from(value: f32) -> Self {
                $name(Luminous(value))
            }
        }

        impl From<f32> for $name<Scotopic> {
            fn from(value: f32) -> Self {
                $name(Scotopic(value))
            }
        }

        impl<const N: usize, G: Grid> $name<Light<N, G>> {
            /// All the power on the grid: the integral over the wavelength.
            ///
            /// # Accuracy
            /// 4 units of 2^-24, relative.
            #[must_use]
            pub fn radiant(&self) -> $name<Radiant> {
                $name(Radiant(self.0.power()))
            }

            /// This quantity as the eye counts it, by V(lambda) folded to this grid: 683.002 lm/W times what
            /// `v` reads.
            ///
            /// `v` has to be V(lambda), `V_PHOTOPIC.fold(..)`: any observer of one row on this grid has its
            /// type, and with another one the number is no lumen.
            #[must_use]
            pub fn luminous_by(&self, v: &Observer<1, N, Power, G>) -> $name<Luminous> {
                let [sum] = v.sees(&self.0);
                $name(Luminous(KM * sum))
            }

            /// This quantity as the dark-adapted eye counts it, by V'(lambda) folded to this grid: 1700 lm/W
            /// times what it reads.
            ///
            /// `v_scotopic` has to be V'(lambda), `V_SCOTOPIC.fold(..)`, which its type does not say.
            #[must_use]
            pub fn scotopic_by(&self, v_scotopic: &Observer<1, N, Power, G>) -> $name<Scotopic> {
                let [sum] = v_scotopic.sees(&self.0);
                $name(Scotopic(KM_SCOTOPIC * sum))
            }
        }

        impl $name<Fine<Power>> {
            /// This quantity as the eye counts it: 683.002 lm/W times the 1 nm sum with V(lambda).
            ///
            /// # Reference
            /// CIE 18:2019.
            #[must_use]
            pub fn luminous(&self) -> $name<Luminous> {
                self.luminous_by(&V_PHOTOPIC)
            }

            /// This quantity as the dark-adapted eye counts it: 1700 lm/W times the 1 nm sum with V'(lambda).
            #[must_use]
            pub fn scotopic(&self) -> $name<Scotopic> {
                self.scotopic_by(&V_SCOTOPIC)
            }
        }
    };
}

quantity! {
    /// Energy Q: what a flux brings in a time.
    Energy: "J", "lm s", "scotopic lm s", "J/nm"
}

quantity! {
    /// Flux Phi: energy for each second, of a lamp in all or through an area.
    ///
    /// ```
    /// # use nanospectra::{Fine, radiometry::{Flux, Lumen}};
    /// let mut laser = Fine::flat(0.0);
    /// let _ = laser.add_line(555.0, 0.005); // a pointer of 5 mW at the peak of vision
    /// let beam: Lumen = Flux::new(laser).luminous();
    /// assert_eq!(format!("{beam:.2}"), "3.42 lm");
    /// ```
    Flux: "W", "lm", "scotopic lm", "W/nm"
}

quantity! {
    /// Intensity I: flux for each unit of solid angle, of a source small enough to be a point.
    Intensity: "W/sr", "cd", "scotopic cd", "W/(sr nm)"
}

quantity! {
    /// Irradiance E (photometric: illuminance): the flux that arrives on each unit of area.
    ///
    /// It is not an intensity, and the compiler knows:
    ///
    /// ```compile_fail
    /// # use nanospectra::radiometry::{Candela, Lux};
    /// let sum = Lux::from(300.0) + Candela::from(100.0);
    /// ```
    ///
    /// nor are watts lumens:
    ///
    /// ```compile_fail
    /// # use nanospectra::radiometry::{Irradiance, Lux, Radiant};
    /// let sum = Lux::from(300.0) + Irradiance::new(Radiant(1.0));
    /// ```
    Irradiance: "W/m2", "lx", "scotopic lx", "W/(m2 nm)"
}

quantity! {
    /// Exitance M: the flux that leaves each unit of area. What arrives and what leaves is
    /// not one thing:
    ///
    /// ```compile_fail
    /// # use nanospectra::radiometry::{Exitance, Irradiance, Radiant};
    /// let sum = Irradiance::new(Radiant(1.0)) + Exitance::new(Radiant(1.0));
    /// ```
    Exitance: "W/m2", "lm/m2", "scotopic lm/m2", "W/(m2 nm)"
}

quantity! {
    /// Radiance L (photometric: luminance): flux for each unit of solid angle and of area across the ray.
    /// What an eye and a camera see, the same all along a ray through empty space.
    Radiance: "W/(m2 sr)", "cd/m2", "scotopic cd/m2", "W/(m2 sr nm)"
}

/// Luminous energy, in lm s.
pub type Talbot = Energy<Luminous>;

/// Luminous flux, in lm.
pub type Lumen = Flux<Luminous>;

/// Luminous intensity, in cd.
pub type Candela = Intensity<Luminous>;

/// Illuminance, in lx.
pub type Lux = Irradiance<Luminous>;

/// Luminance, in cd/m2.
pub type Nit = Radiance<Luminous>;
