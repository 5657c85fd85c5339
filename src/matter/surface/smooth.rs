//! Smooth boundaries as surfaces, which reflect in one direction only.

use crate::geometry::{Direction, Integrand};
use crate::matter::surface::brdf::Brdf;
use crate::matter::surface::reflector::Reflector;
use crate::matter::surface::scattering::Quadrature;

/// A smooth surface that reflects as a mirror does, such as polished metal or the face of a glass.
///
/// It holds a [`Reflector`]. All light that it reflects goes in one direction, so its BRDF is 0 everywhere,
/// and integrals over it take the rule [`Specular`].
///
/// # Example
///
/// ```
/// use nanospectra::matter::{Dielectric, Smooth, Specular, scattering::scattered};
/// use nanospectra::geometry::Direction;
/// // A lamp of radiance 100 that is mirrored in a window at 60 degrees, where glass reflects 8.9 %.
/// let wo = Direction::spherical(1.047_197_6, 0.0);
/// let lamp = |wi: Direction| if wi.x() < 0.0 { 100.0 } else { 0.0 };
/// let lo = scattered(&Smooth(Dielectric::new(1.5)), wo, &Specular, lamp);
/// assert!((lo - 8.919).abs() < 1e-3);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Smooth<F>(pub F);

/// The quadrature rule for [`Smooth`] surfaces, whose only node is the direction of the mirror image.
///
/// See the [example](Smooth#example).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Specular;

impl<F: Reflector> Brdf for Smooth<F> {
    type Value = F::Value;

    #[inline]
    fn f(&self, wo: Direction, wi: Direction) -> F::Value {
        F::Value::ZERO * (wo.cos_theta() * wi.cos_theta())
    }
}

impl<F: Reflector> Quadrature<Smooth<F>> for Specular {
    fn arriving(&self, brdf: &Smooth<F>, wo: Direction, mut visit: impl FnMut(Direction, F::Value)) {
        if wo.cos_theta() <= 0.0 {
            return;
        }
        visit(wo.mirrored(), brdf.0.reflectance(wo.cos_theta()));
    }

    fn leaving(&self, brdf: &Smooth<F>, wi: Direction, visit: impl FnMut(Direction, F::Value)) {
        self.arriving(brdf, wi, visit);
    }
}
