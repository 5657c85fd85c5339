//! The mean reflectance of a smooth surface for light that comes from all sides.

use crate::geometry::gauss_legendre::nodes_and_weights;
use crate::matter::Dielectric;

/// The cosines and weights of 8 Gauss points on 0..=1.
static COSINES: [(f32, f32); 8] = nodes_and_weights();

/// The reflectance for unpolarized light that comes from outside at the cosine `cos`.
pub(super) fn fresnel(eta: f32, cos: f32) -> f32 {
    Dielectric::new(eta).fresnel(cos).unpolarized()
}

/// Whether `eta` is in the range in which the means hold.
pub(super) fn is_denser(eta: f32) -> bool {
    (1.0..=3.0).contains(&eta)
}

/// Computes the mean reflectance of a smooth surface for diffuse light that comes from outside.
///
/// `eta` is the refractive index of the matter relative to the outside, 1..=3; otherwise the result is NaN.
///
/// # Accuracy
/// 3e-7 absolute from an `eta` of 1.2 on. Below, where light is reflected at grazing angles only, 1.1e-4.
///
/// # Example
///
/// ```
/// use nanospectra::matter::{external_reflectance, internal_reflectance};
/// assert!((external_reflectance(1.5) - 0.091_778).abs() < 1e-6);
/// // From within, most directions are totally reflected.
/// assert!((internal_reflectance(1.5) - 0.596_346).abs() < 1e-6);
/// ```
#[must_use]
pub fn external_reflectance(eta: f32) -> f32 {
    if !is_denser(eta) {
        return f32::NAN;
    }
    // The integral is over the cosine. Over its square the integrand would have a root at grazing incidence.
    2.0 * COSINES.iter().map(|(cos, weight)| weight * cos * fresnel(eta, *cos)).sum::<f32>()
}

/// Computes the mean reflectance of a smooth surface for diffuse light that comes from inside, total
/// reflection included.
///
/// `eta` is the refractive index of the matter relative to the outside, 1..=3; otherwise the result is NaN.
/// See the [example](external_reflectance#example).
///
/// # Accuracy
/// As [`external_reflectance`], from which it follows by reciprocity: 1 - (1 - F) / eta^2.
#[must_use]
pub fn internal_reflectance(eta: f32) -> f32 {
    // In this order little accuracy is lost where eta is close to 1.
    ((eta - 1.0) * (eta + 1.0) + external_reflectance(eta)) / (eta * eta)
}

/// Computes [`internal_reflectance`] by the fit of Egan and Hilgeman, as most programs in computer graphics
/// do.
///
/// # Accuracy
/// Within 1e-3 of the exact mean for `eta` 1.2..=1.7, and 1.6e-3 above it at 1, where nothing is reflected.
///
/// # Example
///
/// ```
/// use nanospectra::matter::internal_reflectance_fit;
/// assert!((internal_reflectance_fit(1.5) - 0.596_733).abs() < 1e-6);
/// ```
#[must_use]
pub const fn internal_reflectance_fit(eta: f32) -> f32 {
    let inverse = 1.0 / eta;
    0.668 + 0.0636 * eta + inverse * (0.710 - 1.440 * inverse)
}
