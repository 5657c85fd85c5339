//! Computes the form factor from a point to a polygon by Lambert's formula.

use crate::geometry::vec3::{cross, difference, dot, length, scaled, sum, to_unity, unit};
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::math::{Math, at_most};
use crate::radiometry::carried::ratio;
use crate::radiometry::form_factor::quadrature;
use crate::radiometry::relations::in_front;
use core::f32::consts::FRAC_1_PI;

/// Returns the form factor from a point with a normal to the flat polygon of these vertices.
///
/// The normal may have any length other than 0. The polygon emits to the side from which its vertices run
/// counterclockwise; from behind the factor is 0. The part of the polygon below the point's horizon, or in
/// the plane of the horizon, does not count. The polygon need not be convex. The factor is at most 1.
///
/// # Accuracy
/// For parallelograms of moderate proportions above the horizon the relative error is at most 6e-5, however
/// small or far they are. (Their sides are up to three times as long as each other, at angles of 25 degrees
/// or more, and they are seen within 70 degrees of their normals.) For those that the horizon cuts it is at
/// most 7e-6 of the factor that the whole would have straight ahead and turned towards the point. Slender
/// polygons lose more: rectangles 20 times as long as wide 4e-4, and many times that if they are seen at a
/// slant (searched in `tests/radiometry/worst_sources.rs`).
///
/// # Cost
/// The function takes one arc tangent per edge, or for a small polygon 7 quotients per triangle.
///
/// # Reference
/// Lambert 1760: half the sum over the edges of the angle times the normal of the plane through the edge. For
/// triangles smaller than 0.4 of the distance, where this sum is a difference of nearly equal numbers, it
/// uses Radon's quadrature with seven points.
///
/// # Example
/// ```
/// use nanospectra::radiometry::form_factor::to_polygon;
/// // The ceiling of a cubic room, from the middle of its floor.
/// let ceiling = [[-0.5, -0.5, 1.0], [-0.5, 0.5, 1.0], [0.5, 0.5, 1.0], [0.5, -0.5, 1.0]];
/// let f = to_polygon([0.0; 3], [0.0, 0.0, 1.0], &ceiling);
/// assert!((f - 0.239_456_5).abs() < 1e-6);
/// // A surface that faces down does not see it.
/// assert_eq!(to_polygon([0.0; 3], [0.0, 0.0, -1.0], &ceiling), 0.0);
/// ```
#[cfg(feature = "libm")]
#[must_use]
pub fn to_polygon(point_m: [f32; 3], normal: [f32; 3], vertices_m: &[[f32; 3]]) -> f32 {
    to_polygon_with::<Portable>(point_m, normal, vertices_m)
}

/// Does the same as [`to_polygon`] with a math backend of your choice.
#[must_use]
pub fn to_polygon_with<M: Math>(point_m: [f32; 3], normal: [f32; 3], vertices_m: &[[f32; 3]]) -> f32 {
    let Some((first, others)) = vertices_m.split_first() else { return 0.0 };
    let k = to_unity(vertices_m.iter().flatten().chain(&point_m).copied());
    let (normal, first) = (unit(normal), scaled(*first, k));
    let corner = difference(first, scaled(point_m, k));
    // Divide the polygon into a fan of triangles about the first vertex. Where the polygon is concave,
    // triangles overlap, and have opposite signs, so that the surplus cancels.
    let mut total = 0.0;
    for (second, third) in others.iter().zip(others.iter().skip(1)) {
        let [u, v] = [second, third].map(|vertex| difference(scaled(*vertex, k), first));
        total += above_horizon::<M>(normal, Triangle { corner, u, v });
    }
    // Rounding may add up to more than the whole hemisphere.
    at_most(in_front(total * FRAC_1_PI), 1.0)
}

/// The share of the distance below which a triangle counts as small.
const SMALL: f32 = 0.4;

/// A triangle, held as the vector from the point to one corner and the edges from there to the other two.
///
/// This is exact for small triangles far away, where differences of three positions would not be.
#[derive(Clone, Copy)]
struct Triangle {
    corner: [f32; 3],
    u: [f32; 3],
    v: [f32; 3],
}

impl Triangle {
    /// Returns the same triangle, held by its next corner.
    fn turned(self) -> Self {
        let Triangle { corner, u, v } = self;
        Triangle { corner: sum(corner, u), u: difference(v, u), v: scaled(u, -1.0) }
    }
}

/// Returns the form factor of the part above the horizon, times pi. It is negative from behind.
fn above_horizon<M: Math>(normal: [f32; 3], triangle: Triangle) -> f32 {
    let k = to_unity([triangle.corner, triangle.u, triangle.v].into_iter().flatten());
    let Triangle { corner, u, v } = triangle;
    let triangle = Triangle { corner: scaled(corner, k), u: scaled(u, k), v: scaled(v, k) };
    // The height of the corner above the horizon, and the rise along each edge: their sums are the heights of
    // the other corners.
    let [height, rise_u, rise_v] = [triangle.corner, triangle.u, triangle.v].map(|side| dot(normal, side));
    match [height, height + rise_u, height + rise_v].map(|height| height > 0.0) {
        [true, true, true] => whole::<M>(normal, triangle),
        [true, false, false] => tip::<M>(normal, triangle),
        [false, true, false] => tip::<M>(normal, triangle.turned()),
        [false, false, true] => tip::<M>(normal, triangle.turned().turned()),
        [false, true, true] => trunk::<M>(normal, triangle),
        [true, false, true] => trunk::<M>(normal, triangle.turned()),
        [true, true, false] => trunk::<M>(normal, triangle.turned().turned()),
        // 0, or NaN if a height is NaN.
        [false, false, false] => (height + rise_u + rise_v) * 0.0,
    }
}

/// Returns where the two edges from the corner cross the horizon, as shares of their lengths.
fn cuts(normal: [f32; 3], Triangle { corner, u, v }: Triangle) -> (f32, f32) {
    let height = dot(normal, corner);
    let cut = |edge| ratio(-height, dot(normal, edge)).clamp(0.0, 1.0);
    (cut(u), cut(v))
}

/// Returns the result of [`above_horizon`] if only the corner is above the horizon.
fn tip<M: Math>(normal: [f32; 3], triangle: Triangle) -> f32 {
    let ((cut_u, cut_v), Triangle { corner, u, v }) = (cuts(normal, triangle), triangle);
    whole::<M>(normal, Triangle { corner, u: scaled(u, cut_u), v: scaled(v, cut_v) })
}

/// Returns the result of [`above_horizon`] if only the corner is below the horizon.
///
/// What remains above is a quadrilateral, which is divided along the diagonal from the cut of `u`.
fn trunk<M: Math>(normal: [f32; 3], triangle: Triangle) -> f32 {
    let ((cut_u, cut_v), Triangle { corner, u, v }) = (cuts(normal, triangle), triangle);
    let second = Triangle { corner: sum(corner, u), u: difference(v, u), v: scaled(u, cut_u - 1.0) };
    let third =
        Triangle { corner: sum(corner, v), u: scaled(v, cut_v - 1.0), v: difference(scaled(u, cut_u), v) };
    whole::<M>(normal, second) + whole::<M>(normal, third)
}

/// Returns the form factor of a triangle without regard to the horizon, times pi. It is negative from behind.
fn whole<M: Math>(normal: [f32; 3], triangle: Triangle) -> f32 {
    let Triangle { corner: a, u, v } = triangle;
    let (b, c, side) = (sum(a, u), sum(a, v), difference(v, u));
    let size2 = dot(u, u).max(dot(v, v)).max(dot(side, side));
    let nearest2 = dot(a, a).min(dot(b, b)).min(dot(c, c));
    if size2 < SMALL * SMALL * nearest2 {
        // The integrand is cos cos / r^2 dA. The cosine at the source, times r and twice the area, is the
        // same for all points of the triangle.
        let facing = -dot(cross(u, v), a);
        let [height, rise_u, rise_v] = [a, u, v].map(|side| dot(normal, side));
        return 0.5
            * quadrature::triangle(|s, t| {
                let r = sum(a, sum(scaled(u, s), scaled(v, t)));
                let r2 = dot(r, r);
                (height + s * rise_u + t * rise_v) / r2 * (facing / r2)
            });
    }
    let edge = |from, along, to| {
        let plane = cross(from, along);
        let size = length(plane);
        if size == 0.0 { 0.0 } else { dot(normal, plane) / size * M::atan2(size, dot(from, to)) }
    };
    -0.5 * (edge(a, u, b) + edge(b, side, c) + edge(c, scaled(v, -1.0), a))
}
