//! How the quantities follow from each other: time, area, solid angle, distance and the cosine.
//!
//! A cosine is that between the normal of a surface and the direction to or from it: at or below zero the
//! light is behind the surface and counts nothing. One rule holds for every quotient, by a relation or by
//! `/`: what a division by zero would make infinite is the largest f32 instead, so that no light stays no
//! light wherever it is multiplied, and nothing over nothing is nothing.

use crate::geometry::{Direction, Hemisphere};
use crate::math::operator;
use crate::matter::Brdf;
use crate::matter::scattering::{self, Quadrature};
use crate::radiometry::carried::{finite, over};
use crate::radiometry::{Carried, Energy, Exitance, Flux, Intensity, Irradiance, Radiance};
use core::f32::consts::{FRAC_1_PI, PI};
use core::ops::Mul;

/// A cosine where it is positive; 0 behind the surface; NaN stays.
pub(super) fn in_front(cos_theta: f32) -> f32 {
    if cos_theta <= 0.0 { 0.0 } else { cos_theta }
}

impl<V: Carried> Energy<V> {
    /// The mean flux, when this energy comes in `seconds`.
    #[must_use]
    pub fn over(self, seconds: f32) -> Flux<V> {
        Flux::new(over(self.value(), seconds))
    }
}

impl<V: Carried> Flux<V> {
    /// The energy that comes in `seconds`: Q = Phi t.
    #[must_use]
    pub fn during(self, seconds: f32) -> Energy<V> {
        Energy::new(self.value() * seconds)
    }

    /// The mean irradiance of an area in m2 on which this flux falls: E = dPhi / dA. (No cosine: it is in the
    /// flux that the area catches.)
    #[must_use]
    pub fn irradiance(self, area_m2: f32) -> Irradiance<V> {
        Irradiance::new(over(self.value(), area_m2))
    }

    /// The mean exitance of an area in m2 from which this flux leaves: M = dPhi / dA.
    #[must_use]
    pub fn exitance(self, area_m2: f32) -> Exitance<V> {
        Exitance::new(over(self.value(), area_m2))
    }

    /// The mean intensity, when this flux leaves into a solid angle in sr: I = dPhi / dw.
    ///
    /// ```
    /// # use nanospectra::radiometry::{Candela, Lumen};
    /// // A bulb of 800 lm that shines equally to all sides.
    /// let bulb: Candela = Lumen::from(800.0).intensity(4.0 * core::f32::consts::PI);
    /// assert_eq!(format!("{bulb:.2}"), "63.66 cd");
    /// assert_eq!(format!("{:.2}", bulb.at_distance(2.0, 1.0)), "15.92 lx");
    /// ```
    #[must_use]
    pub fn intensity(self, solid_angle_sr: f32) -> Intensity<V> {
        Intensity::new(over(self.value(), solid_angle_sr))
    }
}

impl<V: Carried> Intensity<V> {
    /// The flux into a solid angle in sr, over which this is the mean intensity.
    #[must_use]
    pub fn flux(self, solid_angle_sr: f32) -> Flux<V> {
        Flux::new(self.value() * solid_angle_sr)
    }

    /// The irradiance at a distance in m, on a surface whose normal makes an angle of cosine `cos_theta` with
    /// the direction to the source: E = I cos / r^2, the inverse square and the cosine law.
    ///
    /// ```
    /// # use nanospectra::radiometry::{Candela, Lux};
    /// let candle = Candela::from(1.0);
    /// assert_eq!(candle.at_distance(1.0, 1.0), Lux::from(1.0)); // what a lux is
    /// assert_eq!(candle.at_distance(2.0, 0.5), Lux::from(0.125));
    /// assert_eq!(candle.at_distance(2.0, -0.5), Lux::NONE); // from behind
    /// ```
    #[must_use]
    pub fn at_distance(self, distance_m: f32, cos_theta: f32) -> Irradiance<V> {
        // Twice, for the square may overflow where the quotient does not.
        Irradiance::new(over(over(self.value() * in_front(cos_theta), distance_m), distance_m))
    }

    /// The radiance of a flat source of `area_m2` that has this intensity in a direction of cosine
    /// `cos_theta` from its normal: L = I / (A cos). Nothing from behind.
    #[must_use]
    pub fn radiance(self, area_m2: f32, cos_theta: f32) -> Radiance<V> {
        if cos_theta <= 0.0 {
            return Radiance::new(self.value() * 0.0);
        }
        Radiance::new(over(self.value(), area_m2 * cos_theta))
    }
}

impl<V: Carried> Irradiance<V> {
    /// All that arrives from the hemisphere above a surface: the integral of the radiance from each direction
    /// times the cosine, by a rule of fixed nodes.
    ///
    /// ```
    /// # use nanospectra::geometry::GaussLegendre;
    /// # use nanospectra::radiometry::{Lux, Nit};
    /// // An even sky of luminance L: pi L, and not 2 pi L.
    /// let lux = Lux::gathered(&GaussLegendre::<8, 4>, |_wi| Nit::from(5000.0));
    /// assert!((lux.value().0 / (5000.0 * core::f32::consts::PI) - 1.0).abs() < 3e-7);
    /// ```
    pub fn gathered(rule: &impl Hemisphere, mut radiance: impl FnMut(Direction) -> Radiance<V>) -> Self {
        Irradiance::new(rule.integrate_projected(|wi| radiance(wi).value()))
    }

    /// The flux on an area in m2, over which this is the mean irradiance. The total over a larger area is the
    /// sum over its parts:
    ///
    /// ```
    /// # use nanospectra::radiometry::{Lumen, Lux};
    /// let desk = [(500.0, 0.5), (300.0, 0.25)];
    /// let flux: Lumen = desk.map(|(lux, m2)| Lux::from(lux).flux(m2)).into_iter().sum();
    /// assert_eq!(flux, Lumen::from(325.0));
    /// ```
    #[must_use]
    pub fn flux(self, area_m2: f32) -> Flux<V> {
        Flux::new(self.value() * area_m2)
    }

    /// The mean radiance of what lights the surface from a small solid angle in sr, in a direction of cosine
    /// `cos_theta` from its normal: L = E / (w cos). Nothing from behind.
    #[must_use]
    pub fn radiance(self, solid_angle_sr: f32, cos_theta: f32) -> Radiance<V> {
        if cos_theta <= 0.0 {
            return Radiance::new(self.value() * 0.0);
        }
        Radiance::new(over(self.value(), solid_angle_sr * cos_theta))
    }

    /// What leaves when all of it does: a perfect diffuser. (Times a reflectance before, any diffuser.)
    ///
    /// ```
    /// # use nanospectra::radiometry::Lux;
    /// // White paper in an office.
    /// assert_eq!(format!("{:.0}", (Lux::from(500.0) * 0.9).as_exitance().lambertian()), "143 cd/m2");
    /// ```
    #[must_use]
    pub fn as_exitance(self) -> Exitance<V> {
        Exitance::new(self.value())
    }
}

impl<V: Carried> Exitance<V> {
    /// The flux that leaves an area in m2, over which this is the mean exitance.
    #[must_use]
    pub fn flux(self, area_m2: f32) -> Flux<V> {
        Flux::new(self.value() * area_m2)
    }

    /// The radiance of a Lambertian emitter, equal in all directions: L = M / pi.
    #[must_use]
    pub fn lambertian(self) -> Radiance<V> {
        Radiance::new(self.value() * FRAC_1_PI)
    }
}

/// For each steradian: the value of a [`Brdf`], which makes radiance of irradiance. (A reflectance is a share
/// without a unit, and a BRDF's value is not; their types are one, so it is said here.)
///
/// ```
/// use nanospectra::geometry::Direction;
/// use nanospectra::matter::{Brdf, Lambert};
/// use nanospectra::radiometry::{Irradiance, PerSr, Radiance};
/// use nanospectra::{Light, Reflectance};
/// let f = Lambert(Reflectance::<16>::flat(0.5)).f(Direction::NORMAL, Direction::NORMAL);
/// let leaving: Radiance<Light<16>> = Irradiance::new(Light::flat(2.0)) * PerSr(f);
/// assert_eq!(leaving.value(), Light::flat(core::f32::consts::FRAC_1_PI));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
#[repr(transparent)]
pub struct PerSr<V>(pub V);

operator! {
    [V: Carried + Mul<F, Output = V>, F: Copy] Mul mul
    |e: Irradiance<V>, f: PerSr<F>| -> Radiance<V> { Radiance::new(e.value() * f.0) }
}

operator! {
    [V: Carried + Mul<F, Output = V>, F: Copy] Mul mul
    |f: PerSr<F>, e: Irradiance<V>| -> Radiance<V> { Radiance::new(e.value() * f.0) }
}

impl<V: Carried> Radiance<V> {
    /// The scattering equation: what leaves a surface towards `wo`, where `arriving` comes from the
    /// hemisphere above it ([`scattered`](crate::matter::scattering::scattered), with units).
    ///
    /// ```
    /// use nanospectra::geometry::{Direction, GaussLegendre};
    /// use nanospectra::matter::Lambert;
    /// use nanospectra::radiometry::Radiance;
    /// use nanospectra::{Light, Reflectance};
    /// // Gray paper under an even sky is half as bright as that.
    /// let (sky, paper) = (Radiance::new(Light::<16>::flat(3.0)), Lambert(Reflectance::flat(0.5)));
    /// let leaving = Radiance::scattered(&paper, Direction::NORMAL, &GaussLegendre::<4, 1>, |_wi| sky);
    /// assert!((leaving.value()[0] - 1.5).abs() < 1e-6);
    /// ```
    pub fn scattered<B: Brdf>(
        brdf: &B,
        wo: Direction,
        quadrature: &impl Quadrature<B>,
        mut arriving: impl FnMut(Direction) -> Radiance<V>,
    ) -> Self
    where
        V: Mul<B::Value, Output = V>,
    {
        Radiance::new(scattering::scattered(brdf, wo, quadrature, |wi| arriving(wi).value()))
    }

    /// The exitance of a Lambertian emitter: M = pi L (and not 2 pi L: of each direction only the cosine
    /// leaves).
    #[must_use]
    pub fn exitance(self) -> Exitance<V> {
        Exitance::new(self.value() * PI)
    }

    /// The irradiance by this radiance from a small solid angle in sr, in a direction of cosine `cos_theta`
    /// from the surface's normal: dE = L cos dw.
    ///
    /// ```
    /// # use nanospectra::radiometry::{Nit, solid_angle};
    /// // The sun in the zenith: 1.6e9 cd/m2, as wide as 4.65 mrad to each side.
    /// let sun = Nit::from(1.6e9).irradiance(solid_angle::cone(4.65e-3), 1.0);
    /// assert!((sun.value().0 / 108_686.0 - 1.0).abs() < 1e-5);
    /// ```
    #[must_use]
    pub fn irradiance(self, solid_angle_sr: f32, cos_theta: f32) -> Irradiance<V> {
        Irradiance::new(self.value() * finite(solid_angle_sr * in_front(cos_theta)))
    }

    /// The irradiance by a Lambertian source of this radiance that has this
    /// [form factor](crate::radiometry::form_factor) from the point: E = pi L F.
    #[must_use]
    pub fn through_form_factor(self, form_factor: f32) -> Irradiance<V> {
        Irradiance::new(self.value() * finite(PI * form_factor))
    }

    /// The intensity of a flat source of `area_m2` in a direction of cosine `cos_theta` from its normal:
    /// I = L A cos, Lambert's cosine law.
    #[must_use]
    pub fn intensity(self, area_m2: f32, cos_theta: f32) -> Intensity<V> {
        Intensity::new(self.value() * finite(area_m2 * in_front(cos_theta)))
    }
}
