//! A sphere from a point, at any tilt and also where it sets below the point's horizon.

use crate::geometry::vec3::to_unity;
use crate::math::Math;
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::radiometry::carried::ratio;
use crate::radiometry::relations::in_front;
use core::f32::consts::FRAC_1_PI;

/// From a point to a sphere whose center is at `distance_m`, in a direction of cosine `cos_theta` from the
/// point's normal. What lies below the horizon does not count; from within the sphere the factor is 1.
///
/// # Accuracy
/// 5e-7, relative, with the center above the horizon; below it 1.2e-7 of (r/d)^2, the largest there can be.
///
/// ```
/// use nanospectra::radiometry::form_factor::to_sphere;
/// assert_eq!(to_sphere(1.0, 2.0, 0.8), 0.2); // cos (r/d)^2 when all of it is up
/// // Rising, half above the horizon: (s - sin s cos s) / pi with sin s = 1/2.
/// assert!((to_sphere(1.0, 2.0, 0.0) - 0.028_834_4).abs() < 1e-7);
/// assert_eq!(to_sphere(1.0, 2.0, -0.6), 0.0);
/// ```
#[cfg(feature = "libm")]
#[must_use]
pub fn to_sphere(radius_m: f32, distance_m: f32, cos_theta: f32) -> f32 {
    to_sphere_with::<Portable>(radius_m, distance_m, cos_theta)
}

/// [`to_sphere`] on another math backend.
#[must_use]
pub fn to_sphere_with<M: Math>(radius_m: f32, distance_m: f32, cos_theta: f32) -> f32 {
    let k = to_unity([radius_m, distance_m]);
    let [r, d] = [radius_m, distance_m].map(|x| (x * k).abs());
    if d < r {
        return 1.0 + 0.0 * cos_theta; // NaN stays
    }
    let sin = ratio(r, d);
    let c = cos_theta;
    if c >= sin {
        return c * sin * sin;
    }
    if c <= -sin {
        return 0.0;
    }
    // The visible part is bounded by an arc of the horizon and one of the sphere's outline. Their half
    // angles:
    let half_chord = M::sqrt((sin - c) * (sin + c));
    let cos = M::sqrt((d - r) * (d + r)) / d;
    let across = (1.0 - c) * (1.0 + c);
    let horizon = segment(M::atan2(half_chord, cos), half_chord * cos / across);
    let (sin_outline, cos_outline) = (half_chord / sin, -c * cos / sin);
    let outline = segment(M::atan2(sin_outline, cos_outline), sin_outline * cos_outline / across);
    // Lambert's boundary integral, sorted into segments of two circles: both count up as long as the center
    // is up.
    in_front((horizon + c * (sin * sin) * outline) * FRAC_1_PI)
}

/// Twice the area of the segment of a unit circle with this half angle: the angle less `product`, its sine
/// times its cosine; a series where they are nearly equal.
fn segment(half_angle_rad: f32, product: f32) -> f32 {
    if half_angle_rad > 0.8 {
        return half_angle_rad - product;
    }
    let s = half_angle_rad * half_angle_rad;
    // 2/3 x^3 (1 - y / 20 + y^2 / 840 - ..) with y = 4 x^2.
    let series = 7.054_674e-4 - s * (2.565_336e-5 + s * -6.577_785e-7);
    let series = 0.133_333_33 - s * (0.012_698_413 - s * series);
    half_angle_rad * s * (0.666_666_7 - s * series)
}
