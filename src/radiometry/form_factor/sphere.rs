//! Computes the form factor from a point to a sphere, also where the horizon hides part of the sphere.

use crate::geometry::vec3::to_unity;
use crate::math::Math;
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::radiometry::carried::ratio;
use crate::radiometry::relations::in_front;
use core::f32::consts::FRAC_1_PI;

/// Returns the form factor from a point to a sphere whose center is at `distance_m`.
///
/// `cos_theta` is the cosine of the angle between the point's normal and the direction to the center. The
/// part of the sphere below the point's horizon does not count. From within the sphere the factor is 1.
///
/// # Accuracy
/// With the center above the horizon, the relative error is at most 1e-6. With the center below, the error is
/// at most 1.4e-7 of (r/d)^2, which is the largest possible factor.
///
/// # Example
/// ```
/// use nanospectra::radiometry::form_factor::to_sphere;
/// assert_eq!(to_sphere(1.0, 2.0, 0.8), 0.2); // cos (r/d)^2 when all of it is above the horizon
/// // With its center on the horizon it is (s - sin s cos s) / pi, where sin s = 1/2.
/// assert!((to_sphere(1.0, 2.0, 0.0) - 0.028_834_4).abs() < 1e-7);
/// assert_eq!(to_sphere(1.0, 2.0, -0.6), 0.0);
/// ```
#[cfg(feature = "libm")]
#[must_use]
pub fn to_sphere(radius_m: f32, distance_m: f32, cos_theta: f32) -> f32 {
    to_sphere_with::<Portable>(radius_m, distance_m, cos_theta)
}

/// Does the same as [`to_sphere`] with a math backend of your choice.
#[must_use]
pub fn to_sphere_with<M: Math>(radius_m: f32, distance_m: f32, cos_theta: f32) -> f32 {
    let k = to_unity([radius_m, distance_m]);
    let [r, d] = [radius_m, distance_m].map(|x| (x * k).abs());
    if d < r {
        return 1.0 + 0.0 * cos_theta; // 1, or NaN if the cosine is NaN
    }
    let sin = ratio(r, d);
    let c = cos_theta;
    if c >= sin {
        return c * sin * sin;
    }
    if c <= -sin {
        return 0.0;
    }
    // The visible part is bounded by an arc of the horizon and one of the sphere's outline. These are the
    // sines and cosines of their half angles.
    let half_chord = M::sqrt((sin - c) * (sin + c));
    let cos = M::sqrt((d - r) * (d + r)) / d;
    let across = (1.0 - c) * (1.0 + c);
    let horizon = segment(M::atan2(half_chord, cos), half_chord * cos / across);
    let (sin_outline, cos_outline) = (half_chord / sin, -c * cos / sin);
    let outline = segment(M::atan2(sin_outline, cos_outline), sin_outline * cos_outline / across);
    // Lambert's boundary integral, written as segments of two circles. Both are positive while the center is
    // above the horizon.
    in_front((horizon + c * (sin * sin) * outline) * FRAC_1_PI)
}

/// Returns twice the area of the segment of a unit circle with this half angle.
///
/// It is the angle minus `product`, which is its sine times its cosine, or a series where both are nearly
/// equal.
fn segment(half_angle_rad: f32, product: f32) -> f32 {
    if half_angle_rad > 0.8 {
        return half_angle_rad - product;
    }
    let s = half_angle_rad * half_angle_rad;
    // The series is 2/3 x^3 (1 - y / 20 + y^2 / 840 - ..) with y = 4 x^2.
    let series = 7.054_674e-4 - s * (2.565_336e-5 + s * -6.577_785e-7);
    let series = 0.133_333_33 - s * (0.012_698_413 - s * series);
    half_angle_rad * s * (0.666_666_7 - s * series)
}
