//! Fresnel's equations as the textbook has them, with complex numbers in f64.

/// A complex number: real and imaginary part.
pub type Complex = [f64; 2];

pub fn times(a: Complex, b: Complex) -> Complex {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

pub fn over(a: Complex, b: Complex) -> Complex {
    let size = power(b);
    times(a, [b[0] / size, -b[1] / size])
}

pub fn power(a: Complex) -> f64 {
    a[0] * a[0] + a[1] * a[1]
}

/// The root in the upper right quarter.
fn root(a: Complex) -> Complex {
    let size = a[0].hypot(a[1]).sqrt();
    let half = 0.5 * a[1].atan2(a[0]);
    [size * half.cos(), size * half.sin()]
}

/// Amplitudes (s, p) reflected by a medium of this relative complex index.
pub fn amplitudes(index: Complex, cos_i: f64) -> (Complex, Complex) {
    let square = times(index, index);
    let t = root([square[0] - (1.0 - cos_i * cos_i), square[1]]);
    let up = times(square, [cos_i, 0.0]);
    let s = over([cos_i - t[0], -t[1]], [cos_i + t[0], t[1]]);
    let p = over([up[0] - t[0], up[1] - t[1]], [up[0] + t[0], up[1] + t[1]]);
    (s, p)
}

/// Shares of power (s, p).
pub fn reflectances(index: Complex, cos_i: f64) -> (f64, f64) {
    let (s, p) = amplitudes(index, cos_i);
    (power(s), power(p))
}

/// Mean of both.
pub fn unpolarized(index: Complex, cos_i: f64) -> f64 {
    let (s, p) = reflectances(index, cos_i);
    0.5 * (s + p)
}

/// The share that enters a conductor, without taking it from 1.
pub fn absorbed(index: Complex, cos_i: f64) -> (f64, f64) {
    let square = times(index, index);
    let t = root([square[0] - (1.0 - cos_i * cos_i), square[1]]);
    let up = times(square, [cos_i, 0.0]);
    let of_p = square[0] * t[0] + square[1] * t[1];
    let (s, p) = ([cos_i + t[0], t[1]], [up[0] + t[0], up[1] + t[1]]);
    (4.0 * cos_i * t[0] / power(s), 4.0 * cos_i * of_p / power(p))
}
