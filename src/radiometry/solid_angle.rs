//! Solid angles in sr, in forms that keep their digits however small they are.
//!
//! Lengths are in m (any one unit will do), 0 or more, and scale freely: products of them neither overflow
//! nor underflow. Where the textbook subtracts nearly equal numbers, 1 - cos for the sun or a determinant of
//! long vectors for a small triangle, these forms do not: 2 pi (1 - cos) of the sun is 2e-3 off in f32, here
//! it has all its digits.
//!
//! ```
//! use nanospectra::radiometry::solid_angle;
//! // The sun: radius 695 700 km, distance 149.6 million km.
//! assert!((solid_angle::sphere(6.957e8, 1.496e11) / 6.794_117e-5 - 1.0).abs() < 1e-6);
//! ```

use crate::geometry::vec3::{cross, difference, dot, length, scaled, to_unity};
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::math::{Math, sqrt};
use core::f32::consts::{FRAC_PI_2, PI, TAU};

pub use crate::radiometry::off_axis_disk::disk_off_axis;

/// All directions.
pub const WHOLE_SPHERE: f32 = 4.0 * PI;

/// The cone of directions within `half_angle_rad` (0..=pi) of an axis: 4 pi sin^2(half / 2).
///
/// # Accuracy
/// 4 units of 2^-24, relative.
#[must_use]
pub fn cone(half_angle_rad: f32) -> f32 {
    let half_angle_rad = half_angle_rad.abs();
    if half_angle_rad > FRAC_PI_2 {
        // What is left over is a cone about the opposite direction. pi is 8.7e-8 less than its f32.
        const BEYOND_PI: f32 = -8.742_278e-8;
        let rest = PI - half_angle_rad + BEYOND_PI;
        return WHOLE_SPHERE - if rest > 0.0 { cap(rest) } else { 0.0 };
    }
    cap(half_angle_rad)
}

/// 2 pi (1 - cos) as a series without its 1, up to a quarter turn: the term left out is 1e-10.
fn cap(half_angle_rad: f32) -> f32 {
    let s = half_angle_rad * half_angle_rad;
    let series = 1.731_427_3e-6 - s * (1.311_687_3e-8 - s * 7.207_073e-11);
    let series = 0.008_726_646 - s * (1.558_329_7e-4 - s * series);
    s * (PI - s * (0.261_799_4 - s * series))
}

/// A sphere seen from a distance to its center. From within it is all directions, from its surface half of
/// them.
///
/// # Accuracy
/// 6 units of 2^-24, relative.
#[must_use]
pub fn sphere(radius_m: f32, distance_m: f32) -> f32 {
    let k = to_unity([radius_m, distance_m]);
    let [r, d] = [radius_m, distance_m].map(|x| (x * k).abs());
    if d < r {
        return WHOLE_SPHERE;
    }
    if r == 0.0 && d == 0.0 {
        return 0.0;
    }
    TAU * (r * r) / (d * (d + sqrt((d - r) * (d + r))))
}

/// A disk seen from a point on its axis. At no distance it is half of all directions.
///
/// # Accuracy
/// 6 units of 2^-24, relative.
#[must_use]
pub fn disk(radius_m: f32, distance_m: f32) -> f32 {
    let k = to_unity([radius_m, distance_m]);
    let [r, d] = [radius_m, distance_m].map(|x| (x * k).abs());
    let (r2, slant2) = (r * r, r * r + d * d);
    if slant2 == 0.0 {
        return 0.0;
    }
    TAU * r2 / (slant2 + d * sqrt(slant2))
}

/// A rectangle seen from a point over its center. At no distance it is half of all directions.
///
/// # Accuracy
/// 5 units of 2^-24, relative, while no length is more than 1e15 times another: beyond, a strip may vanish.
#[cfg(feature = "libm")]
#[must_use]
pub fn rectangle(width_m: f32, height_m: f32, distance_m: f32) -> f32 {
    rectangle_with::<Portable>(width_m, height_m, distance_m)
}

/// [`rectangle`] on another math backend.
#[must_use]
pub fn rectangle_with<M: Math>(width_m: f32, height_m: f32, distance_m: f32) -> f32 {
    let k = to_unity([width_m, height_m, distance_m]);
    let [a, b, d] = [0.5 * width_m, 0.5 * height_m, distance_m].map(|x| (x * k).abs());
    4.0 * M::atan2(a * b, d * sqrt(a * a + b * b + d * d))
}

/// A triangle of three vertices, seen from the point `from_m`; its orientation does not matter.
///
/// A triangle without area has none, nor has one seen edge-on: from a point in its plane (be it on the
/// triangle) or on a vertex.
///
/// # Accuracy
/// 4 units of 2^-24 times (1 + the condition of the determinant): the sum of the sizes of its terms over its
/// value, a few for what is seen from the front, and growing as the view becomes edge-on. Random small
/// triangles of 1e-6 of the distance are within 1e-4, where the textbook's form has no digit left. Where two
/// vertices lie in nearly opposite directions, the error is up to 20 units times (1 + the condition + 1 / the
/// sine of the angle between them): near its edge a rounding of the observer's place turns the whole view.
///
/// # Reference
/// Van Oosterom and Strackee 1983, with the determinant of one vertex and two edges.
///
/// ```
/// use nanospectra::radiometry::solid_angle::triangle;
/// // The corner of a cube sees an eighth of all directions through three far points.
/// let octant = triangle([0.0; 3], [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
/// assert!((octant - core::f32::consts::FRAC_PI_2).abs() < 2e-7);
/// ```
#[cfg(feature = "libm")]
#[must_use]
pub fn triangle(from_m: [f32; 3], vertices_m: [[f32; 3]; 3]) -> f32 {
    triangle_with::<Portable>(from_m, vertices_m)
}

/// [`triangle`] on another math backend.
#[must_use]
pub fn triangle_with<M: Math>(from_m: [f32; 3], vertices_m: [[f32; 3]; 3]) -> f32 {
    let k = to_unity(vertices_m.into_iter().flatten().chain(from_m));
    let from = scaled(from_m, k);
    let [p, q, r] = vertices_m.map(|vertex| scaled(vertex, k));
    let [a, b, c] = [p, q, r].map(|vertex| difference(vertex, from));
    // From the edges: those of a small triangle are exact, and the cross product is as small as its area.
    // That of two long vectors would be a difference of numbers a million times as large.
    let determinant = dot(a, cross(difference(q, p), difference(r, p)));
    if determinant == 0.0 {
        return 0.0;
    }
    let [la, lb, lc] = [a, b, c].map(length);
    let cosines = la * lb * lc + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la;
    2.0 * M::atan2(determinant.abs(), cosines)
}
