//! The BRDF, which tells how a surface scatters light, and the simplest one.

use crate::geometry::{Direction, Integrand};
use core::f32::consts::FRAC_1_PI;

/// A bidirectional reflectance distribution function: the radiance that leaves towards `wo` for each unit of
/// irradiance that arrives from `wi`.
///
/// [`f`](Self::f) evaluates it. Its values are numbers or spectra ([`Reflectance`](crate::Reflectance) per
/// sr). Both directions point away from the surface and are in its own frame; a
/// [`Frame`](crate::geometry::Frame) makes them from positions in a scene. Integrals over a BRDF, and checks
/// of one, are in [`scattering`](crate::matter::scattering).
///
/// # Example
///
/// ```
/// use nanospectra::{Reflectance, geometry::Direction, matter::{Brdf, Lambert}};
/// let red = Reflectance::<3>::from_bins([0.1, 0.2, 0.7]);
/// let f = Lambert(red).f(Direction::NORMAL, Direction::spherical(1.0, 0.0));
/// assert!((f.values()[2] - 0.7 / 3.141_592_7).abs() < 1e-7); // the same towards everywhere
/// ```
pub trait Brdf {
    /// The type of the values: a number, or a spectrum that holds one for each bin.
    type Value: Integrand;

    /// Evaluates the BRDF for light that comes from `wi` and leaves towards `wo`, in 1/sr, 0 or more.
    ///
    /// The cosine of the angle of incidence is not included. The value is 0 where either direction is at or
    /// below the horizon, and NaN where a direction is NaN. See the [example](Brdf#example).
    fn f(&self, wo: Direction, wi: Direction) -> Self::Value;
}

/// A perfectly matt surface, which looks equally bright from all directions.
///
/// It holds its reflectance, 0..=1, as a number or a spectrum; the BRDF is this divided by pi. See the
/// [example](Brdf#example).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lambert<V>(pub V);

impl<V: Integrand> Brdf for Lambert<V> {
    type Value = V;

    #[inline]
    fn f(&self, wo: Direction, wi: Direction) -> V {
        self.0 * (FRAC_1_PI * visible(wo, wi))
    }
}

/// 1 where both directions are above the surface, 0 elsewhere; NaN for NaN.
#[inline]
pub(crate) fn visible(wo: Direction, wi: Direction) -> f32 {
    let (o, i) = (wo.cos_theta(), wi.cos_theta());
    if o.is_nan() || i.is_nan() {
        f32::NAN
    } else if o > 0.0 && i > 0.0 {
        1.0
    } else {
        0.0
    }
}
