//! The Mueller matrix that mirrors, polarizers and retarders have in common.

use crate::grid::{Bins, by_fields};
use crate::math::{const_for, cos_turns, sin_turns, sqrt_by_digits};
use crate::price::{Effects, Price, Priced};
use crate::spectrum::{Factor, Spectrum};
use core::marker::PhantomData;

/// The Mueller matrix of a mirror, polarizer or retarder, one per bin, in the element's own axes, with the
/// angle of its first axis: `[[a, b, 0, 0], [b, a, 0, 0], [0, 0, c, s], [0, 0, -s, c]]`.
pub struct Mueller<const N: usize, G = Bins<380, 730>> {
    /// a, b, c, s.
    elements: [[f32; 4]; N],
    /// Cosine and sine of twice the angle of the axis.
    cos: f32,
    sin: f32,
    grid: PhantomData<G>,
}

by_fields!([const N: usize, G] Mueller<N, G>, "Mueller": elements, cos, sin);

impl<const N: usize, G> Mueller<N, G> {
    pub(crate) const fn new(elements: [[f32; 4]; N], axis_turns: f32) -> Self {
        // (From 2^23 on these are whole turns, doubled or not; doubled, the largest would be infinite.)
        let twice = if axis_turns.abs() > 1e30 { axis_turns } else { 2.0 * axis_turns };
        let (cos, sin) = (cos_turns(twice), sin_turns(twice));
        Mueller { elements, cos, sin, grid: PhantomData }
    }

    /// What becomes of a Stokes vector in bin `k`; NaN beyond the last.
    #[must_use]
    #[inline]
    pub fn turn(&self, k: usize, [i, q, u, v]: [f32; 4]) -> [f32; 4] {
        let [a, b, c, s] = self.elements.get(k).copied().unwrap_or([f32::NAN; 4]);
        let (q, u) = (self.cos * q + self.sin * u, self.cos * u - self.sin * q);
        let (i, q) = (a * i + b * q, b * i + a * q);
        let (u, v) = (c * u + s * v, c * v - s * u);
        [i, self.cos * q - self.sin * u, self.sin * q + self.cos * u, v]
    }

    /// What [`turn_natural`](Self::turn_natural) in all bins costs.
    pub(crate) const PRICE_OF_NATURAL: Price = Price { multiply_adds: 4 * N, ..Self::PRICE };

    /// What becomes of unpolarized light in bin `k`: a quarter of the work, since no compiler may leave out a
    /// product with zero.
    #[inline]
    pub(crate) fn turn_natural(&self, k: usize, intensity: f32) -> [f32; 4] {
        let [a, b, ..] = self.elements.get(k).copied().unwrap_or([f32::NAN; 4]);
        let polarized = b * intensity;
        [a * intensity, self.cos * polarized, self.sin * polarized, 0.0]
    }

    /// The share of unpolarized light that leaves: the effect left out, by name.
    #[must_use]
    pub const fn ignoring_polarization(&self) -> Spectrum<Factor, N, G> {
        let mut values = [0.0; N];
        const_for!(0..N, |k| values[k] = self.elements[k][0]);
        Spectrum::unchecked(values)
    }

    /// What becomes of the row of an observer that looks at it: the transpose of [`turn`](Self::turn).
    pub(crate) const fn fold(&self, k: usize, [i, q, u, v]: [f32; 4]) -> [f32; 4] {
        let [a, b, c, s] = self.elements[k];
        let (q, u) = (self.cos * q + self.sin * u, self.cos * u - self.sin * q);
        let (i, q) = (a * i + b * q, b * i + a * q);
        let (u, v) = (c * u - s * v, c * v + s * u);
        [i, self.cos * q - self.sin * u, self.sin * q + self.cos * u, v]
    }
}

impl<const N: usize, G> Priced for Mueller<N, G> {
    const PRICE: Price = Price { effects: Effects::POLARIZATION, multiply_adds: 16 * N, bytes: 16 * N + 8 };
}

/// Half the sum, half the difference and the geometric mean of the powers along an axis and across it.
pub(crate) const fn along_and_across(along: f32, across: f32) -> [f32; 3] {
    let along = if along < 0.0 { 0.0 } else { along };
    let across = if across < 0.0 { 0.0 } else { across };
    let product = along * across;
    // One root where the product is in range.
    let both = if 1e-30 < product && product < 1e30 {
        sqrt_by_digits(product)
    } else {
        sqrt_by_digits(along) * sqrt_by_digits(across)
    };
    [0.5 * along + 0.5 * across, 0.5 * along - 0.5 * across, both]
}
