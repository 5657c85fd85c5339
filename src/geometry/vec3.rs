//! Vector arithmetic on three coordinates, which the geometry is written in.

use crate::math::sqrt;

pub(crate) fn sum(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    let ([ax, ay, az], [bx, by, bz]) = (a, b);
    [ax + bx, ay + by, az + bz]
}

pub(crate) fn difference(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    let ([ax, ay, az], [bx, by, bz]) = (a, b);
    [ax - bx, ay - by, az - bz]
}

pub(crate) fn scaled(a: [f32; 3], k: f32) -> [f32; 3] {
    a.map(|x| x * k)
}

pub(crate) fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    let ([ax, ay, az], [bx, by, bz]) = (a, b);
    ax * bx + ay * by + az * bz
}

pub(crate) fn cross(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    let ([ax, ay, az], [bx, by, bz]) = (a, b);
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}

pub(crate) fn length(a: [f32; 3]) -> f32 {
    sqrt(dot(a, a))
}

/// Returns the power of two that scales the largest of some lengths to between 1 and 2.
///
/// Near the ends of the range of f32 the result is between 2^-22 and 4. Products of three or four scaled
/// lengths then neither overflow nor underflow, and a power of two costs no digits.
pub(crate) fn to_unity(lengths: impl IntoIterator<Item = f32>) -> f32 {
    let exponent = lengths.into_iter().fold(0, |largest: u32, x| largest.max(x.to_bits() << 1 >> 24));
    f32::from_bits(254_u32.saturating_sub(exponent).max(1) << 23)
}

/// Returns the vector of length 1 in a direction. The zero vector has no direction and stays zero.
pub(crate) fn unit(a: [f32; 3]) -> [f32; 3] {
    let a = scaled(a, to_unity(a));
    let length = length(a);
    if length == 0.0 { a } else { a.map(|x| x / length) }
}
