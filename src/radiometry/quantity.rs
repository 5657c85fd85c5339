//! Defines the quantities of radiometry as types, so that only values of the same quantity and unit add up.

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
            /// Makes the quantity from a value such as `Luminous(800.0)` or a [`Light`].
            ///
            /// The value is in the unit [`UNIT`](Self::UNIT). See the [example](#example). For a single
            /// number `From<f32>` is shorter, where the type says what it counts.
            #[must_use]
            pub const fn new(value: V) -> Self {
                $name(value)
            }

            /// Returns the value that the quantity carries, in the unit [`UNIT`](Self::UNIT).
            ///
            /// The number of a [`Radiant`], [`Luminous`] or [`Scotopic`] value is its field `0`. See the
            /// [example](#example).
            #[must_use]
            pub const fn value(self) -> V {
                self.0
            }

            /// The quantity where there is no light: the number 0, or a spectrum with 0 in every bin.
            pub const NONE: Self = $name(V::ZERO);

            /// The symbol of the unit in which the value is counted, such as `"W"`, `"lx"` or `"W/(m2 nm)"`.
            ///
            /// `Display` writes it after the value. See the [example](#example).
            pub const UNIT: &'static str = match V::UNITS {
                Units::Radiant => $radiant,
                Units::Luminous => $luminous,
                Units::Scotopic => $scotopic,
                Units::Spectral => $spectral,
            };
        }

        linear_operators! {
            [V: Carried] $name<V>, Self::NONE;
            |a, b| { $name(a.0 + b.0) } { $name(a.0 - b.0) } { $name(a.0 * *b) } { $name(over(a.0, *b)) } { $name(-a.0) }
        }

        // A factor per bin, such as a transmittance or a reflectance, scales a spectral quantity.
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
            /// Returns the radiant quantity: the integral of the spectrum over the wavelengths of its grid.
            ///
            /// See the [example of `luminous_by`](Self::luminous_by).
            ///
            /// # Accuracy
            /// The relative error is at most 4 units of 2^-24.
            #[must_use]
            pub fn radiant(&self) -> $name<Radiant> {
                $name(Radiant(self.0.power()))
            }

            /// Converts the spectrum to the luminous quantity, with a V(lambda) that is folded to its grid.
            ///
            /// The result is 683.002 lm/W times what `v` sees. Make `v` once, by
            /// [`V_PHOTOPIC.fold(..)`](crate::Observer::fold). The compiler accepts every observer with one
            /// row on this grid: if `v` is another one, the result is not in lumens.
            ///
            /// # Example
            /// ```
            /// use nanospectra::observer::{V_PHOTOPIC, V_SCOTOPIC};
            /// use nanospectra::{Curve, Light, Observer, Power};
            #[doc = concat!("use nanospectra::radiometry::", stringify!($name), ";")]
            ///
            /// static V: Observer<1, 16, Power> = V_PHOTOPIC.fold(Curve::Spline);
            /// static V_DARK: Observer<1, 16, Power> = V_SCOTOPIC.fold(Curve::Spline);
            ///
            /// // Equal power at every wavelength, in 16 bins of 380..730 nm. The integral of V(lambda) is
            /// // 106.86 nm.
            #[doc = concat!("let light = ", stringify!($name), "::new(Light::<16>::flat(1.0));")]
            /// let [radiant, luminous] = [light.radiant().value().0, light.luminous_by(&V).value().0];
            /// assert!((radiant - 350.0).abs() < 1e-3);
            /// assert!((luminous / (683.002 * 106.86) - 1.0).abs() < 2e-3);
            /// assert!(light.scotopic_by(&V_DARK).value().0 > luminous);
            /// ```
            #[must_use]
            pub fn luminous_by(&self, v: &Observer<1, N, Power, G>) -> $name<Luminous> {
                let [sum] = v.sees(&self.0);
                $name(Luminous(KM * sum))
            }

            /// Converts the spectrum to the scotopic quantity, with a V'(lambda) that is folded to its grid.
            ///
            /// The result is 1700 lm/W times what `v_scotopic` sees. Make this observer once, by
            /// [`V_SCOTOPIC.fold(..)`](crate::Observer::fold). The compiler accepts every observer with one
            /// row on this grid: if it is another one, the result is not in scotopic units. See the [example
            /// of `luminous_by`](Self::luminous_by).
            #[must_use]
            pub fn scotopic_by(&self, v_scotopic: &Observer<1, N, Power, G>) -> $name<Scotopic> {
                let [sum] = v_scotopic.sees(&self.0);
                $name(Scotopic(KM_SCOTOPIC * sum))
            }
        }

        impl $name<Fine<Power>> {
            /// Returns the luminous quantity: 683.002 lm/W times the sum with V(lambda) in 1 nm steps.
            ///
            /// # Reference
            /// CIE 18:2019.
            ///
            /// # Example
            /// ```
            #[doc = concat!("use nanospectra::{Fine, radiometry::", stringify!($name), "};")]
            ///
            /// // All power at 507 nm, where V'(lambda) is 1 and V(lambda) 0.44431.
            /// let mut line = Fine::flat(0.0);
            /// let _ = line.add_line(507.0, 1.0);
            #[doc = concat!("let light = ", stringify!($name), "::new(line);")]
            /// assert!((light.luminous().value().0 - 683.002 * 0.44431).abs() < 0.1);
            /// assert!((light.scotopic().value().0 - 1700.0).abs() < 1.0);
            /// ```
            #[must_use]
            pub fn luminous(&self) -> $name<Luminous> {
                self.luminous_by(&V_PHOTOPIC)
            }

            /// Returns the scotopic quantity: 1700 lm/W times the sum with V'(lambda) in 1 nm steps.
            ///
            /// See the [example of `luminous`](Self::luminous).
            #[must_use]
            pub fn scotopic(&self) -> $name<Scotopic> {
                self.scotopic_by(&V_SCOTOPIC)
            }
        }
    };
}

quantity! {
    /// Energy Q, which a flux brings in a time and which a pulse of light contains.
    ///
    /// Make it with [`new`](Self::new) or from a flux by [`Flux::during`].
    ///
    /// # Example
    /// ```
    /// use nanospectra::radiometry::{Energy, Radiant};
    ///
    /// // A laser pulse of 2 mJ within 10 ns.
    /// let pulse = Energy::new(Radiant(0.002));
    /// assert_eq!(pulse.to_string(), "0.002 J");
    /// assert_eq!(pulse.value().0, 0.002);
    /// assert_eq!(Energy::<Radiant>::UNIT, "J");
    /// assert!((pulse.over(10e-9).value().0 - 200e3).abs() < 0.1); // its mean flux is 200 kW
    /// ```
    Energy: "J", "lm s", "scotopic lm s", "J/nm"
}

quantity! {
    /// Flux Phi, the energy per second that a lamp emits or that passes through an area.
    ///
    /// Make it with [`new`](Self::new). Then [`irradiance`](Self::irradiance), [`exitance`](Self::exitance)
    /// and [`intensity`](Self::intensity) spread it over an area or a solid angle.
    ///
    /// # Example
    /// ```
    /// use nanospectra::{Fine, radiometry::{Flux, Lumen}};
    ///
    /// let mut laser = Fine::flat(0.0);
    /// let _ = laser.add_line(555.0, 0.005); // a pointer of 5 mW at the peak of vision
    /// let beam: Lumen = Flux::new(laser).luminous();
    /// assert_eq!(format!("{beam:.2}"), "3.42 lm");
    /// assert!((beam.value().0 - 0.005 * 683.002).abs() < 1e-5);
    /// assert_eq!(Lumen::UNIT, "lm");
    /// ```
    Flux: "W", "lm", "scotopic lm", "W/nm"
}

quantity! {
    /// Intensity I, the flux per unit of solid angle that a small source emits in a direction.
    ///
    /// Make it with [`new`](Self::new), and find the irradiance that it causes with
    /// [`at_distance`](Self::at_distance).
    ///
    /// # Example
    /// ```
    /// use nanospectra::radiometry::{Candela, Intensity, Luminous};
    ///
    /// let spotlight = Intensity::new(Luminous(900.0));
    /// assert_eq!(spotlight, Candela::from(900.0));
    /// assert_eq!(spotlight.value().0, 900.0);
    /// assert_eq!(Candela::UNIT, "cd");
    /// assert_eq!(spotlight.at_distance(3.0, 1.0).to_string(), "100 lx"); // at right angles, 3 m away
    /// ```
    Intensity: "W/sr", "cd", "scotopic cd", "W/(sr nm)"
}

quantity! {
    /// Irradiance E, the flux that arrives at a surface per unit of area.
    ///
    /// In photometry it is called illuminance.
    ///
    /// Make it with [`new`](Self::new), with [`gathered`](Self::gathered) from the radiance of all
    /// directions, or from one of the sources of [`radiometry`](crate::radiometry). Multiply it by a BRDF
    /// ([`PerSr`]) to get the radiance that leaves.
    ///
    /// [`PerSr`]: crate::radiometry::PerSr
    ///
    /// # Example
    /// ```
    /// use nanospectra::{Reflectance, light};
    /// use nanospectra::radiometry::{Irradiance, Lux};
    ///
    /// // Daylight of 500 lx on gray paint of reflectance 0.2.
    /// let daylight = Irradiance::new(light::D65.fine());
    /// let daylight = daylight * (500.0 / daylight.luminous().value().0);
    /// let leaving = daylight * Reflectance::flat(0.2);
    /// assert!((leaving.luminous().value().0 - 100.0).abs() < 1e-3);
    /// assert_eq!(Lux::UNIT, "lx");
    /// ```
    Irradiance: "W/m2", "lx", "scotopic lx", "W/(m2 nm)"
}

quantity! {
    /// Exitance M, the flux that leaves a surface per unit of area into the whole hemisphere.
    ///
    /// Make it with [`new`](Self::new), from a flux by [`Flux::exitance`], or from what arrives at a diffuser
    /// by [`Irradiance::as_exitance`]. For a matt surface [`lambertian`](Self::lambertian) gives the
    /// radiance.
    ///
    /// # Example
    /// ```
    /// use nanospectra::radiometry::{Exitance, Luminous, Nit};
    ///
    /// // A matt panel that emits 3141.6 lm from each square meter looks equally bright from all sides.
    /// let panel = Exitance::new(Luminous(3141.593));
    /// assert!((panel.lambertian().value().0 - Nit::from(1000.0).value().0).abs() < 1e-3);
    /// assert_eq!(panel.flux(0.5).to_string(), "1570.7965 lm");
    /// assert_eq!(Exitance::<Luminous>::UNIT, "lm/m2");
    /// ```
    Exitance: "W/m2", "lm/m2", "scotopic lm/m2", "W/(m2 nm)"
}

quantity! {
    /// Radiance L, the flux that travels along a ray per unit of solid angle and of area across it.
    ///
    /// In photometry it is called luminance.
    ///
    /// It says how bright a surface looks to an eye or a camera, and does not change along a ray through
    /// empty space. Make it with [`new`](Self::new), with [`scattered`](Self::scattered) for a surface under
    /// light, or from an exitance by [`Exitance::lambertian`].
    ///
    /// # Example
    /// ```
    /// use nanospectra::radiometry::{Luminous, Nit, Radiance};
    ///
    /// let sky = Radiance::new(Luminous(5000.0));
    /// assert_eq!(sky, Nit::from(5000.0));
    /// assert_eq!((sky * 0.5).to_string(), "2500 cd/m2");
    /// assert_eq!(Nit::UNIT, "cd/m2");
    /// // Under an even sky there are pi L lx.
    /// assert!((sky.through_form_factor(1.0).value().0 - 15_708.0).abs() < 0.1);
    /// ```
    Radiance: "W/(m2 sr)", "cd/m2", "scotopic cd/m2", "W/(m2 sr nm)"
}

/// The luminous energy, which is measured in lm s.
///
/// # Example
/// ```
/// use nanospectra::radiometry::{Lumen, Talbot};
/// let flash: Talbot = Lumen::from(2e6).during(0.001);
/// assert_eq!(format!("{flash:.1}"), "2000.0 lm s");
/// ```
pub type Talbot = Energy<Luminous>;

/// The luminous flux, which is measured in lm. See the [example](Flux#example).
pub type Lumen = Flux<Luminous>;

/// The luminous intensity, which is measured in cd. See the [example](Intensity#example).
pub type Candela = Intensity<Luminous>;

/// The illuminance, which is measured in lx. See the [example](Irradiance#example).
pub type Lux = Irradiance<Luminous>;

/// The luminance, which is measured in cd/m2. See the [example](Radiance#example).
pub type Nit = Radiance<Luminous>;
