//! A polygon from a point, at any tilt, cut off at the point's horizon: Lambert's formula.

use crate::geometry::vec3::{cross, difference, dot, length, scaled, sum, to_unity, unit};
use crate::math::Math;
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::radiometry::carried::ratio;
use crate::radiometry::form_factor::quadrature;
use crate::radiometry::relations::in_front;
use core::f32::consts::FRAC_1_PI;

/// From a point with a normal (of any length but 0) to the flat polygon of these vertices.
///
/// The polygon shines to the side from which its vertices run counterclockwise; from behind the factor is 0.
/// What lies below the point's horizon, or in its plane, does not count. It need not be convex.
///
/// # Accuracy
/// 1.7e-5, relative, for quadrilaterals of moderate proportions above the horizon, however small or far; cut
/// by the horizon 1e-6 of what the whole would be straight ahead and turned towards the point. Slender ones
/// lose more: rectangles 20 times as long as wide 1e-4, and seen at a slant many times that.
///
/// # Cost
/// One arc tangent an edge, or for what is small 7 quotients a triangle.
///
/// # Reference
/// Lambert 1760: half the sum over the edges of angle times normal of the plane through the edge; below
/// 0.4 of the distance Radon's seven points, since there the sum is the difference of nearly equal numbers.
///
/// ```
/// use nanospectra::radiometry::form_factor::to_polygon;
/// // The ceiling of a cubic room, from the middle of its floor: 0.23946.
/// let ceiling = [[-0.5, -0.5, 1.0], [-0.5, 0.5, 1.0], [0.5, 0.5, 1.0], [0.5, -0.5, 1.0]];
/// let f = to_polygon([0.0; 3], [0.0, 0.0, 1.0], &ceiling);
/// assert!((f - 0.239_456_5).abs() < 1e-6);
/// // A point that looks down does not see it.
/// assert_eq!(to_polygon([0.0; 3], [0.0, 0.0, -1.0], &ceiling), 0.0);
/// ```
#[cfg(feature = "libm")]
#[must_use]
pub fn to_polygon(point_m: [f32; 3], normal: [f32; 3], vertices_m: &[[f32; 3]]) -> f32 {
    to_polygon_with::<Portable>(point_m, normal, vertices_m)
}

/// [`to_polygon`] on another math backend.
#[must_use]
pub fn to_polygon_with<M: Math>(point_m: [f32; 3], normal: [f32; 3], vertices_m: &[[f32; 3]]) -> f32 {
    let Some((first, others)) = vertices_m.split_first() else { return 0.0 };
    let k = to_unity(vertices_m.iter().flatten().chain(&point_m).copied());
    let (normal, first) = (unit(normal), scaled(*first, k));
    let corner = difference(first, scaled(point_m, k));
    // A fan of triangles about the first vertex, with signs: where it folds back, the parts cancel.
    let mut total = 0.0;
    for (second, third) in others.iter().zip(others.iter().skip(1)) {
        let [u, v] = [second, third].map(|vertex| difference(scaled(*vertex, k), first));
        total += above_horizon::<M>(normal, Triangle { corner, u, v });
    }
    in_front(total * FRAC_1_PI)
}

/// Below this share of the distance a triangle is small.
const SMALL: f32 = 0.4;

/// A corner, seen from the point, and the edges from there to the other two; exact for small triangles far
/// away, where the differences of three positions would not be.
#[derive(Clone, Copy)]
struct Triangle {
    corner: [f32; 3],
    u: [f32; 3],
    v: [f32; 3],
}

impl Triangle {
    /// The same triangle from its next corner.
    fn turned(self) -> Self {
        let Triangle { corner, u, v } = self;
        Triangle { corner: sum(corner, u), u: difference(v, u), v: scaled(u, -1.0) }
    }
}

/// The part above the horizon, times pi; negative from behind.
fn above_horizon<M: Math>(normal: [f32; 3], triangle: Triangle) -> f32 {
    let k = to_unity([triangle.corner, triangle.u, triangle.v].into_iter().flatten());
    let Triangle { corner, u, v } = triangle;
    let triangle = Triangle { corner: scaled(corner, k), u: scaled(u, k), v: scaled(v, k) };
    // Height of the corner, and rise along the edges; the other corners are as high as both together.
    let [height, rise_u, rise_v] = [triangle.corner, triangle.u, triangle.v].map(|side| dot(normal, side));
    match [height, height + rise_u, height + rise_v].map(|height| height > 0.0) {
        [true, true, true] => whole::<M>(normal, triangle),
        [true, false, false] => tip::<M>(normal, triangle),
        [false, true, false] => tip::<M>(normal, triangle.turned()),
        [false, false, true] => tip::<M>(normal, triangle.turned().turned()),
        [false, true, true] => trunk::<M>(normal, triangle),
        [true, false, true] => trunk::<M>(normal, triangle.turned()),
        [true, true, false] => trunk::<M>(normal, triangle.turned().turned()),
        // Nothing, or NaN.
        [false, false, false] => (height + rise_u + rise_v) * 0.0,
    }
}

/// Where the edges from the corner cross the horizon, as shares of them.
fn cuts(normal: [f32; 3], Triangle { corner, u, v }: Triangle) -> (f32, f32) {
    let height = dot(normal, corner);
    let cut = |edge| ratio(-height, dot(normal, edge)).clamp(0.0, 1.0);
    (cut(u), cut(v))
}

/// The corner alone is above the horizon.
fn tip<M: Math>(normal: [f32; 3], triangle: Triangle) -> f32 {
    let ((cut_u, cut_v), Triangle { corner, u, v }) = (cuts(normal, triangle), triangle);
    whole::<M>(normal, Triangle { corner, u: scaled(u, cut_u), v: scaled(v, cut_v) })
}

/// The corner alone is below: a quadrilateral is left, and divided at its diagonal from the cut of `u`.
fn trunk<M: Math>(normal: [f32; 3], triangle: Triangle) -> f32 {
    let ((cut_u, cut_v), Triangle { corner, u, v }) = (cuts(normal, triangle), triangle);
    let second = Triangle { corner: sum(corner, u), u: difference(v, u), v: scaled(u, cut_u - 1.0) };
    let third =
        Triangle { corner: sum(corner, v), u: scaled(v, cut_v - 1.0), v: difference(scaled(u, cut_u), v) };
    whole::<M>(normal, second) + whole::<M>(normal, third)
}

/// A triangle without regard to the horizon, times pi; negative from behind.
fn whole<M: Math>(normal: [f32; 3], triangle: Triangle) -> f32 {
    let Triangle { corner: a, u, v } = triangle;
    let (b, c, side) = (sum(a, u), sum(a, v), difference(v, u));
    let size2 = dot(u, u).max(dot(v, v)).max(dot(side, side));
    let nearest2 = dot(a, a).min(dot(b, b)).min(dot(c, c));
    if size2 < SMALL * SMALL * nearest2 {
        // cos cos / r^2 dA; the cosine at the source, times r and twice the area, is the same all over.
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
