//! Computes the nodes and weights of Gauss-Legendre quadrature at compile time.

use crate::math::const_for;

/// Returns N nodes in 0..1, in increasing order, with weights that add up to 1.
///
/// The rule is exact for polynomials up to the degree 2 N - 1.
pub(crate) const fn nodes_and_weights<const N: usize>() -> [(f32, f32); N] {
    let mut table = [(0.0, 0.0); N];
    let n = N as f64;
    const_for!(0..N.div_ceil(2), |k| {
        // Newton's method on the Legendre polynomial, started from the asymptotic formula of its root.
        let mut x = cosine(core::f64::consts::PI * (k as f64 + 0.75) / (n + 0.5));
        let mut slope = 0.0;
        const_for!(0..5, |_step| {
            let (mut value, mut before) = (x, 1.0);
            const_for!(1..N, |degree| {
                let next =
                    ((2 * degree + 1) as f64 * x * value - degree as f64 * before) / (degree + 1) as f64;
                before = value;
                value = next;
            });
            slope = n * (x * value - before) / (x * x - 1.0);
            x -= value / slope;
        });
        let exact = 1.0 / ((1.0 - x) * (1.0 + x) * slope * slope);
        // Round down, so that the sum of all weights does not exceed 1.
        let nearest = exact as f32;
        let weight = if nearest as f64 > exact { nearest.next_down() } else { nearest };
        table[k] = ((0.5 * (1.0 - x)) as f32, weight);
        table[N - 1 - k] = ((0.5 * (1.0 + x)) as f32, weight);
    });
    table
}

/// Returns the cosine by its Taylor series, which within 0..=pi is accurate enough to start Newton's method.
const fn cosine(x: f64) -> f64 {
    let (mut sum, mut term, mut k) = (1.0, 1.0, 1.0);
    while k < 24.0 {
        term *= -x * x / (k * (k + 1.0));
        sum += term;
        k += 2.0;
    }
    sum
}
