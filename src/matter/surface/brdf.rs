//! How a surface scatters light: the BRDF, and the plainest one.

use crate::geometry::{Direction, Integrand};
use core::f32::consts::FRAC_1_PI;

/// A bidirectional reflectance distribution function: radiance towards `wo` for each irradiance from `wi`.
///
/// Its values are numbers, or spectra ([`Reflectance`](crate::Reflectance) per sr). Integrals over it are in
/// [`scattering`](crate::matter::scattering).
///
/// ```
/// # use nanospectra::{Reflectance, geometry::Direction, matter::{Brdf, Lambert}};
/// let red = Reflectance::<3>::from_bins([0.1, 0.2, 0.7]);
/// let f = Lambert(red).f(Direction::NORMAL, Direction::spherical(1.0, 0.0));
/// assert!((f.values()[2] - 0.7 / 3.141_592_7).abs() < 1e-7); // the same towards everywhere
/// ```
pub trait Brdf {
    /// A number, or a spectrum.
    type Value: Integrand;

    /// The value for light from `wi` to `wo`, 1/sr, 0 or more. 0 where either is at or below the horizon; NaN
    /// in a direction gives NaN.
    fn f(&self, wo: Direction, wi: Direction) -> Self::Value;
}

/// A perfectly matt surface: equally bright from everywhere. Holds its reflectance, 0..=1.
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
