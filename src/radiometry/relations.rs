//! Relates the quantities to each other by time, area, solid angle, distance and the cosine.
//!
//! A cosine is that of the angle between the normal of a surface and the direction to or from it. At 0 or
//! below the light is behind the surface and does not count. One rule holds for every quotient, in a method
//! or by `/`: what a division by zero would make infinite is the largest f32 instead, and zero over zero is
//! zero. A product with zero light is therefore always zero and never NaN.

use crate::geometry::{Direction, Hemisphere};
use crate::math::operator;
use crate::matter::Brdf;
use crate::matter::scattering::{self, Quadrature};
use crate::radiometry::carried::{finite, over};
use crate::radiometry::{Carried, Energy, Exitance, Flux, Intensity, Irradiance, Radiance};
use core::f32::consts::{FRAC_1_PI, PI};
use core::ops::Mul;

/// Returns a cosine where it is positive, and 0 behind the surface. NaN stays NaN.
pub(super) fn in_front(cos_theta: f32) -> f32 {
    if cos_theta <= 0.0 { 0.0 } else { cos_theta }
}

impl<V: Carried> Energy<V> {
    /// Returns the mean flux if this energy arrives within `seconds`. See the [example](Self#example).
    #[must_use]
    pub fn over(self, seconds: f32) -> Flux<V> {
        Flux::new(over(self.value(), seconds))
    }
}

impl<V: Carried> Flux<V> {
    /// Returns the energy Q = Phi t that this flux brings in `seconds`.
    ///
    /// # Example
    /// ```
    /// # use nanospectra::radiometry::Lumen;
    /// assert_eq!(Lumen::from(800.0).during(10.0).to_string(), "8000 lm s");
    /// ```
    #[must_use]
    pub fn during(self, seconds: f32) -> Energy<V> {
        Energy::new(self.value() * seconds)
    }

    /// Returns the mean irradiance E = Phi / A of an area in m2 on which this flux falls.
    ///
    /// There is no cosine here, because the flux that the area catches already contains it.
    ///
    /// # Example
    /// ```
    /// # use nanospectra::radiometry::{Lumen, Lux};
    /// // 1000 lm, spread evenly over a table of 2 m2.
    /// assert_eq!(Lumen::from(1000.0).irradiance(2.0), Lux::from(500.0));
    /// ```
    #[must_use]
    pub fn irradiance(self, area_m2: f32) -> Irradiance<V> {
        Irradiance::new(over(self.value(), area_m2))
    }

    /// Returns the mean exitance M = Phi / A of an area in m2 from which this flux leaves.
    ///
    /// See the [example](crate::radiometry#example) of the module.
    #[must_use]
    pub fn exitance(self, area_m2: f32) -> Exitance<V> {
        Exitance::new(over(self.value(), area_m2))
    }

    /// Returns the mean intensity I = Phi / w if this flux leaves into a solid angle in sr.
    ///
    /// # Example
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
    /// Returns the flux into a solid angle in sr over which this is the mean intensity.
    ///
    /// # Example
    /// ```
    /// # use nanospectra::radiometry::{Candela, solid_angle};
    /// // A lamp of 100 cd to all sides emits 400 pi lm.
    /// let flux = Candela::from(100.0).flux(solid_angle::WHOLE_SPHERE);
    /// assert_eq!(format!("{flux:.1}"), "1256.6 lm");
    /// ```
    #[must_use]
    pub fn flux(self, solid_angle_sr: f32) -> Flux<V> {
        Flux::new(self.value() * solid_angle_sr)
    }

    /// Returns the irradiance E = I cos / r^2 on a surface at a distance in m from the source.
    ///
    /// `cos_theta` is the cosine of the angle between the surface's normal and the direction to the source.
    /// The formula combines the inverse square law and the cosine law.
    ///
    /// # Example
    /// ```
    /// # use nanospectra::radiometry::{Candela, Lux};
    /// let candle = Candela::from(1.0);
    /// assert_eq!(candle.at_distance(1.0, 1.0), Lux::from(1.0)); // the definition of the lux
    /// assert_eq!(candle.at_distance(2.0, 0.5), Lux::from(0.125));
    /// assert_eq!(candle.at_distance(2.0, -0.5), Lux::NONE); // from behind
    /// ```
    #[must_use]
    pub fn at_distance(self, distance_m: f32, cos_theta: f32) -> Irradiance<V> {
        // Divide twice, since the square of the distance may overflow where the quotient does not.
        Irradiance::new(over(over(self.value() * in_front(cos_theta), distance_m), distance_m))
    }

    /// Returns the radiance L = I / (A cos) of a flat source that has this intensity in a direction.
    ///
    /// `area_m2` is the area of the source, and `cos_theta` the cosine of the angle between its normal and
    /// the direction. From behind the radiance is 0.
    ///
    /// # Example
    /// ```
    /// # use nanospectra::radiometry::{Candela, Nit};
    /// // A lamp of 100 cd straight ahead, with an opening of 0.01 m2.
    /// assert_eq!(format!("{:.0}", Candela::from(100.0).radiance(0.01, 1.0)), "10000 cd/m2");
    /// assert_eq!(Candela::from(100.0).radiance(0.01, -1.0), Nit::NONE);
    /// ```
    #[must_use]
    pub fn radiance(self, area_m2: f32, cos_theta: f32) -> Radiance<V> {
        if cos_theta <= 0.0 {
            return Radiance::new(self.value() * 0.0);
        }
        Radiance::new(over(self.value(), area_m2 * cos_theta))
    }
}

impl<V: Carried> Irradiance<V> {
    /// Returns the irradiance on a surface that receives light from the whole hemisphere above it.
    ///
    /// It is the integral of the radiance from each direction times the cosine. `rule` is a
    /// [`Hemisphere`] such as [`GaussLegendre`](crate::geometry::GaussLegendre), and `radiance` returns the
    /// radiance that arrives from a direction.
    ///
    /// # Example
    /// ```
    /// # use nanospectra::geometry::GaussLegendre;
    /// # use nanospectra::radiometry::{Lux, Nit};
    /// // An even sky of luminance L gives pi L, and not 2 pi L.
    /// let lux = Lux::gathered(&GaussLegendre::<8, 4>, |_wi| Nit::from(5000.0));
    /// assert!((lux.value().0 / (5000.0 * core::f32::consts::PI) - 1.0).abs() < 3e-7);
    /// ```
    pub fn gathered(rule: &impl Hemisphere, mut radiance: impl FnMut(Direction) -> Radiance<V>) -> Self {
        Irradiance::new(rule.integrate_projected(|wi| radiance(wi).value()))
    }

    /// Returns the flux on an area in m2 over which this is the mean irradiance.
    ///
    /// # Example
    /// ```
    /// # use nanospectra::radiometry::{Lumen, Lux};
    /// // The total over a larger area is the sum over its parts.
    /// let desk = [(500.0, 0.5), (300.0, 0.25)];
    /// let flux: Lumen = desk.map(|(lux, m2)| Lux::from(lux).flux(m2)).into_iter().sum();
    /// assert_eq!(flux, Lumen::from(325.0));
    /// ```
    #[must_use]
    pub fn flux(self, area_m2: f32) -> Flux<V> {
        Flux::new(self.value() * area_m2)
    }

    /// Returns the mean radiance L = E / (w cos) of a source that covers a small solid angle in sr.
    ///
    /// `cos_theta` is the cosine of the angle between the surface's normal and the direction to the source.
    /// From behind the radiance is 0.
    ///
    /// # Example
    /// ```
    /// # use nanospectra::radiometry::{Lux, solid_angle};
    /// // The sun gives 100 000 lx at right angles, and covers 6.8e-5 sr.
    /// let sun = Lux::from(1e5).radiance(solid_angle::cone(4.65e-3), 1.0);
    /// assert!((sun.value().0 / 1.472e9 - 1.0).abs() < 1e-3); // cd/m2
    /// ```
    #[must_use]
    pub fn radiance(self, solid_angle_sr: f32, cos_theta: f32) -> Radiance<V> {
        if cos_theta <= 0.0 {
            return Radiance::new(self.value() * 0.0);
        }
        Radiance::new(over(self.value(), solid_angle_sr * cos_theta))
    }

    /// Returns the exitance of a perfect diffuser, from which all light leaves that arrives.
    ///
    /// For any other diffuser, multiply the irradiance by its reflectance first.
    ///
    /// # Example
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
    /// Returns the flux that leaves an area in m2 over which this is the mean exitance. See the
    /// [example](Self#example).
    #[must_use]
    pub fn flux(self, area_m2: f32) -> Flux<V> {
        Flux::new(self.value() * area_m2)
    }

    /// Returns the radiance L = M / pi of a Lambertian emitter, which is equal in all directions. See the
    /// [example](Self#example).
    #[must_use]
    pub fn lambertian(self) -> Radiance<V> {
        Radiance::new(self.value() * FRAC_1_PI)
    }
}

/// The value of a [`Brdf`], which is counted per steradian and makes radiance of irradiance.
///
/// [`Brdf::f`] returns a plain number or a [`Reflectance`](crate::Reflectance), which have no unit. Wrap the
/// value in this type to multiply an [`Irradiance`] by it.
///
/// # Example
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
    /// Returns the radiance that leaves a surface towards `wo`, by the scattering equation.
    ///
    /// `arriving` returns the radiance that arrives from a direction of the hemisphere above the surface. It
    /// is [`scattered`](crate::matter::scattering::scattered) with units.
    ///
    /// # Example
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

    /// Returns the exitance M = pi L of a Lambertian emitter that has this radiance in all directions.
    ///
    /// The factor is pi and not 2 pi because in each direction the emitter's area appears smaller by the
    /// cosine.
    ///
    /// # Example
    /// ```
    /// # use nanospectra::radiometry::Nit;
    /// assert_eq!(format!("{:.1}", Nit::from(1000.0).exitance()), "3141.6 lm/m2");
    /// ```
    #[must_use]
    pub fn exitance(self) -> Exitance<V> {
        Exitance::new(self.value() * PI)
    }

    /// Returns the irradiance E = L w cos that this radiance causes from a small solid angle in sr.
    ///
    /// `cos_theta` is the cosine of the angle between the receiving surface's normal and the direction to the
    /// source.
    ///
    /// # Example
    /// ```
    /// # use nanospectra::radiometry::{Nit, solid_angle};
    /// // The sun at the zenith has 1.6e9 cd/m2 and a radius of 4.65 mrad.
    /// let sun = Nit::from(1.6e9).irradiance(solid_angle::cone(4.65e-3), 1.0);
    /// assert!((sun.value().0 / 108_686.0 - 1.0).abs() < 1e-5);
    /// ```
    #[must_use]
    pub fn irradiance(self, solid_angle_sr: f32, cos_theta: f32) -> Irradiance<V> {
        Irradiance::new(self.value() * finite(solid_angle_sr * in_front(cos_theta)))
    }

    /// Returns the irradiance E = pi L F that a Lambertian source of this radiance causes at a point.
    ///
    /// `form_factor` is the source's [form factor](crate::radiometry::form_factor) F seen from that point.
    /// See the [example](Self#example).
    #[must_use]
    pub fn through_form_factor(self, form_factor: f32) -> Irradiance<V> {
        Irradiance::new(self.value() * finite(PI * form_factor))
    }

    /// Returns the intensity I = L A cos of a flat source with this radiance, by Lambert's cosine law.
    ///
    /// `area_m2` is the area of the source, and `cos_theta` the cosine of the angle between its normal and
    /// the direction.
    ///
    /// # Example
    /// ```
    /// # use nanospectra::radiometry::{Candela, Nit};
    /// // A panel of 0.25 m2, seen at 60 degrees.
    /// assert_eq!(Nit::from(4000.0).intensity(0.25, 0.5), Candela::from(500.0));
    /// ```
    #[must_use]
    pub fn intensity(self, area_m2: f32, cos_theta: f32) -> Intensity<V> {
        Intensity::new(self.value() * finite(area_m2 * in_front(cos_theta)))
    }
}
