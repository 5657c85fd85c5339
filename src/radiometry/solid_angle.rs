//! Computes solid angles in sr of cones, spheres, disks, rectangles and triangles.
//!
//! A solid angle says how large an object appears from a point. Multiply it by the radiance and the cosine to
//! get the irradiance that a small source causes ([`Radiance::irradiance`]); for a large source use a
//! [`form_factor`](crate::radiometry::form_factor), which contains the cosine.
//!
//! Lengths are in m, or in any other unit that is the same for all of them, and 0 or more. They may be of any
//! size: intermediate products neither overflow nor underflow.
//!
//! Results keep their digits however small they are. Textbook formulas subtract nearly equal numbers, such as
//! 1 - cos for the sun or a determinant of long vectors for a small triangle, and the functions here do not:
//! 2 pi (1 - cos) of the sun is off by 2e-3 in f32, while [`cone`] has all digits.
//!
//! [`Radiance::irradiance`]: crate::radiometry::Radiance::irradiance
//!
//! # Example
//! ```
//! use nanospectra::radiometry::solid_angle;
//! // The sun has a radius of 695 700 km and a distance of 149.6 million km.
//! assert!((solid_angle::sphere(6.957e8, 1.496e11) / 6.794_117e-5 - 1.0).abs() < 1e-6);
//! ```

use crate::geometry::vec3::{cross, difference, dot, length, scaled, to_unity};
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::math::{Math, sqrt};
use core::f32::consts::{FRAC_PI_2, PI, TAU};

pub use crate::radiometry::off_axis_disk::disk_off_axis;

/// The solid angle that all directions together cover: 4 pi sr. See the [example](cone#example).
pub const WHOLE_SPHERE: f32 = 4.0 * PI;

/// Returns the solid angle of the cone of directions within `half_angle_rad` (0..=pi) of an axis.
///
/// It is 4 pi sin^2(half angle / 2).
///
/// # Accuracy
/// The relative error is at most 4 units of 2^-24.
///
/// # Example
/// ```
/// use nanospectra::radiometry::solid_angle::{WHOLE_SPHERE, cone};
/// // A beam of 120 degrees, 60 degrees to each side, covers a quarter of all directions.
/// assert!((cone(core::f32::consts::FRAC_PI_3) / WHOLE_SPHERE - 0.25).abs() < 1e-6);
/// assert_eq!(cone(core::f32::consts::PI), WHOLE_SPHERE);
/// ```
#[must_use]
pub fn cone(half_angle_rad: f32) -> f32 {
    let half_angle_rad = half_angle_rad.abs();
    if half_angle_rad > FRAC_PI_2 {
        // The remaining directions form a cone about the opposite direction. pi is 8.7e-8 less than its f32.
        const BEYOND_PI: f32 = -8.742_278e-8;
        let rest = PI - half_angle_rad + BEYOND_PI;
        return WHOLE_SPHERE - if rest > 0.0 { cap(rest) } else { 0.0 };
    }
    cap(half_angle_rad)
}

/// Returns 2 pi (1 - cos) up to a quarter turn, by a series that begins after the 1 that cancels.
///
/// The first term left out is 1e-10.
fn cap(half_angle_rad: f32) -> f32 {
    let s = half_angle_rad * half_angle_rad;
    let series = 1.731_427_3e-6 - s * (1.311_687_3e-8 - s * 7.207_073e-11);
    let series = 0.008_726_646 - s * (1.558_329_7e-4 - s * series);
    s * (PI - s * (0.261_799_4 - s * series))
}

/// Returns the solid angle of a sphere that is seen from a distance to its center.
///
/// From within the sphere it is that of all directions, and from its surface half of that. See the
/// [example](crate::radiometry::solid_angle#example) of the module.
///
/// # Accuracy
/// The relative error is at most 6 units of 2^-24.
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

/// Returns the solid angle of a disk that is seen from a point on its axis.
///
/// At a distance of 0 it is 2 pi, half of all directions. For points beside the axis use [`disk_off_axis`].
///
/// # Accuracy
/// The relative error is at most 7 units of 2^-24.
///
/// # Example
/// ```
/// use nanospectra::radiometry::solid_angle::disk;
/// // A disk of 3 m radius, 4 m away: 2 pi (1 - 4 / 5).
/// assert!((disk(3.0, 4.0) - 1.256_637).abs() < 1e-6);
/// ```
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

/// Returns the solid angle of a rectangle that is seen from a point over its center.
///
/// At a distance of 0 it is 2 pi, half of all directions.
///
/// # Accuracy
/// The relative error is at most 6 units of 2^-24 while no length is more than 1e15 times another. Beyond
/// that, the result for a narrow strip may become 0.
///
/// # Example
/// ```
/// use nanospectra::radiometry::solid_angle::rectangle;
/// // One face of a cube, seen from the cube's center, covers a sixth of all directions.
/// assert!((rectangle(2.0, 2.0, 1.0) - 2.094_395).abs() < 1e-6);
/// ```
#[cfg(feature = "libm")]
#[must_use]
pub fn rectangle(width_m: f32, height_m: f32, distance_m: f32) -> f32 {
    rectangle_with::<Portable>(width_m, height_m, distance_m)
}

/// Does the same as [`rectangle`] with a math backend of your choice.
#[must_use]
pub fn rectangle_with<M: Math>(width_m: f32, height_m: f32, distance_m: f32) -> f32 {
    let k = to_unity([width_m, height_m, distance_m]);
    let [a, b, d] = [0.5 * width_m, 0.5 * height_m, distance_m].map(|x| (x * k).abs());
    4.0 * M::atan2(a * b, d * sqrt(a * a + b * b + d * d))
}

/// Returns the solid angle of a triangle with three vertices that is seen from the point `from_m`.
///
/// The order of the vertices does not matter. The result is 0 for a triangle without area and for one that is
/// seen edge-on, which includes points on the triangle and on its vertices.
///
/// # Accuracy
/// If the vertices are seen within right angles of each other, the relative error is at most 5 units of 2^-24
/// times (1 + c), where c is the condition of the determinant: the sum of the absolute values of its terms
/// over its value. c is small for a triangle that is seen from the front, and grows as the view becomes
/// edge-on. Random small triangles of 1e-6 of the distance are within 1e-4, where the textbook formula has no
/// digit left. If two vertices lie in nearly opposite directions, the error of random triangles is at most 20
/// units times (1 + c + 1 / the sine of the angle between them), because close to an edge the rounding of the
/// observer's position turns the whole view. The worst are those whose vertices lie nearly in one line with
/// the observer between them: 7 units times (1 + c) / sine^2, of the least sine of an angle above a right one
/// (searched in `tests/radiometry/worst_sources.rs`). Below a sine of 1e-3 this may leave no digit.
///
/// # Reference
/// Van Oosterom and Strackee 1983, with the determinant of one vertex and two edges.
///
/// # Example
/// ```
/// use nanospectra::radiometry::solid_angle::triangle;
/// // A triangle through the unit points of the three axes fills an octant, an eighth of all directions.
/// let octant = triangle([0.0; 3], [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
/// assert!((octant - core::f32::consts::FRAC_PI_2).abs() < 2e-7);
/// ```
#[cfg(feature = "libm")]
#[must_use]
pub fn triangle(from_m: [f32; 3], vertices_m: [[f32; 3]; 3]) -> f32 {
    triangle_with::<Portable>(from_m, vertices_m)
}

/// Does the same as [`triangle`] with a math backend of your choice.
#[must_use]
pub fn triangle_with<M: Math>(from_m: [f32; 3], vertices_m: [[f32; 3]; 3]) -> f32 {
    let k = to_unity(vertices_m.into_iter().flatten().chain(from_m));
    let from = scaled(from_m, k);
    let [p, q, r] = vertices_m.map(|vertex| scaled(vertex, k));
    let [a, b, c] = [p, q, r].map(|vertex| difference(vertex, from));
    // Take the cross product of two edges. Those of a small triangle are exact, and their product is as small
    // as its area. The product of two vertices could be a difference of numbers a million times as large.
    let determinant = dot(a, cross(difference(q, p), difference(r, p)));
    if determinant == 0.0 {
        return 0.0;
    }
    let [la, lb, lc] = [a, b, c].map(length);
    let cosines = la * lb * lc + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la;
    2.0 * M::atan2(determinant.abs(), cosines)
}
