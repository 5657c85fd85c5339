//! What a smooth surface reflects of light that comes from all sides.

use crate::geometry::gauss_legendre::nodes_and_weights;
use crate::matter::Dielectric;

/// Cosines and weights: 8 points on 0..=1.
static COSINES: [(f32, f32); 8] = nodes_and_weights();

/// Reflectance for unpolarized light that comes from outside at the cosine `cos`.
pub(super) fn fresnel(eta: f32, cos: f32) -> f32 {
    Dielectric::new(eta).fresnel(cos).unpolarized()
}

/// The range of `eta` that the means are for.
pub(super) fn is_denser(eta: f32) -> bool {
    (1.0..=3.0).contains(&eta)
}

/// The mean reflectance for light from all sides outside, 0.091778 for `eta` = 1.5; `eta` 1..=3, else NaN.
///
/// # Accuracy
/// 2e-7 absolute from 1.2 on; below, where all is reflected at grazing angles only, 1.1e-4.
#[must_use]
pub fn external_reflectance(eta: f32) -> f32 {
    if !is_denser(eta) {
        return f32::NAN;
    }
    // In the cosine itself: in its square the integrand has a root at grazing.
    2.0 * COSINES.iter().map(|(cos, weight)| weight * cos * fresnel(eta, *cos)).sum::<f32>()
}

/// The mean reflectance for light from all sides inside, total reflection included: 0.596346 for `eta` = 1.5;
/// `eta` 1..=3, else NaN.
///
/// # Accuracy
/// As [`external_reflectance`], from which it follows by reciprocity: 1 - (1 - F) / eta^2.
#[must_use]
pub fn internal_reflectance(eta: f32) -> f32 {
    // In this order little is lost near 1.
    ((eta - 1.0) * (eta + 1.0) + external_reflectance(eta)) / (eta * eta)
}

/// [`internal_reflectance`] by the fit of Egan and Hilgeman that computer graphics uses: 0.596733 for `eta` =
/// 1.5.
///
/// # Accuracy
/// Within 1e-3 of the exact mean for `eta` 1.2..=1.7, and 1.6e-3 above it at 1, where there is nothing to
/// reflect.
#[must_use]
pub const fn internal_reflectance_fit(eta: f32) -> f32 {
    let inverse = 1.0 / eta;
    0.668 + 0.0636 * eta + inverse * (0.710 - 1.440 * inverse)
}
