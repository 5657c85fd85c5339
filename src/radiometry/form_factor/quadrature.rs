//! Quadrature with fixed nodes, for integrals whose closed form would lose digits.

use crate::geometry::gauss_legendre::nodes_and_weights;

static GAUSS: [(f32, f32); 8] = nodes_and_weights();

/// Returns the integral of `f` over 0..1, which is exact for polynomials up to the degree 15.
pub(super) fn unit_interval(f: impl Fn(f32) -> f32) -> f32 {
    GAUSS.iter().fold(0.0, |sum, (x, weight)| sum + weight * f(*x))
}

/// Radon's seven points of a triangle: the coordinates along two edges, and the weight for an area of 1.
const RADON: [(f32, f32, f32); 7] = [
    (0.333_333_34, 0.333_333_34, 0.225),
    (0.470_142_07, 0.470_142_07, 0.132_394_15),
    (0.059_715_87, 0.470_142_07, 0.132_394_15),
    (0.470_142_07, 0.059_715_87, 0.132_394_15),
    (0.101_286_51, 0.101_286_51, 0.125_939_18),
    (0.797_427, 0.101_286_51, 0.125_939_18),
    (0.101_286_51, 0.797_427, 0.125_939_18),
];

/// Returns the mean of `f` over a triangle, which is exact for polynomials up to the degree 5.
///
/// `f` takes the coordinates along two of the triangle's edges.
pub(super) fn triangle(f: impl Fn(f32, f32) -> f32) -> f32 {
    RADON.iter().fold(0.0, |sum, (s, t, weight)| sum + weight * f(*s, *t))
}
