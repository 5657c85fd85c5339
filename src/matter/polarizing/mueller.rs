//! The Mueller matrix that mirrors, polarizers and retarders have in common.

use crate::grid::{Bins, by_fields};
use crate::math::{const_for, cos_turns, sin_turns, sqrt_by_digits};
use crate::price::{Effects, Price, Priced};
use crate::spectrum::{Factor, Spectrum};
use core::marker::PhantomData;

/// The Mueller matrix that describes a mirror, polarizer or retarder, one per bin, in its own axes, with the
/// angle of its first axis.
///
/// It is `[[a, b, 0, 0], [b, a, 0, 0], [0, 0, c, s], [0, 0, -s, c]]`, which is enough for all of them. You
/// get it from [`Mirror::mueller`](crate::matter::Mirror::mueller),
/// [`Polarizer::mueller`](crate::matter::Polarizer::mueller) or
/// [`Retarder::mueller`](crate::matter::Retarder::mueller), and apply it by [`turn`](Self::turn).
///
/// # Example
///
/// ```
/// use nanospectra::matter::Polarizer;
/// // A perfect polarizer passes half of unpolarized light, polarized along its axis.
/// let sheet = Polarizer::<31>::ideal(0.0);
/// assert_eq!(sheet.mueller().turn(0, [1.0, 0.0, 0.0, 0.0]), [0.5, 0.5, 0.0, 0.0]);
/// assert_eq!(sheet.mueller().ignoring_polarization().values(), &[0.5; 31]);
/// ```
pub struct Mueller<const N: usize, G = Bins<380, 730>> {
    /// The elements a, b, c, s of each bin.
    elements: [[f32; 4]; N],
    /// The cosine and sine of twice the angle of the axis.
    cos: f32,
    sin: f32,
    grid: PhantomData<G>,
}

by_fields!([const N: usize, G] Mueller<N, G>, "Mueller": elements, cos, sin);

impl<const N: usize, G> Mueller<N, G> {
    pub(crate) const fn new(elements: [[f32; 4]; N], axis_turns: f32) -> Self {
        // Above 2^23 every number is whole turns, doubled or not; the largest would be infinite if doubled.
        let twice = if axis_turns.abs() > 1e30 { axis_turns } else { 2.0 * axis_turns };
        let (cos, sin) = (cos_turns(twice), sin_turns(twice));
        Mueller { elements, cos, sin, grid: PhantomData }
    }

    /// Applies the matrix of bin `k` to a Stokes vector and returns that of the light that leaves.
    ///
    /// All four numbers are NaN where `k` is not below `N`. See the [example](#example).
    #[must_use]
    #[inline]
    pub fn turn(&self, k: usize, [i, q, u, v]: [f32; 4]) -> [f32; 4] {
        let [a, b, c, s] = self.elements.get(k).copied().unwrap_or([f32::NAN; 4]);
        let (q, u) = (self.cos * q + self.sin * u, self.cos * u - self.sin * q);
        let (i, q) = (a * i + b * q, b * i + a * q);
        let (u, v) = (c * u + s * v, c * v - s * u);
        [i, self.cos * q - self.sin * u, self.sin * q + self.cos * u, v]
    }

    /// The cost of [`turn_natural`](Self::turn_natural) in all bins.
    pub(crate) const PRICE_OF_NATURAL: Price = Price { multiply_adds: 4 * N, ..Self::PRICE };

    /// The Stokes vector that leaves when unpolarized light comes in bin `k`. This takes a quarter of the
    /// work of [`turn`](Self::turn), where the compiler may not leave out products with zero.
    #[inline]
    pub(crate) fn turn_natural(&self, k: usize, intensity: f32) -> [f32; 4] {
        let [a, b, ..] = self.elements.get(k).copied().unwrap_or([f32::NAN; 4]);
        let polarized = b * intensity;
        [a * intensity, self.cos * polarized, self.sin * polarized, 0.0]
    }

    /// Returns the share of unpolarized light that leaves, in each bin. See the [example](#example).
    #[must_use]
    pub const fn ignoring_polarization(&self) -> Spectrum<Factor, N, G> {
        let mut values = [0.0; N];
        const_for!(0..N, |k| values[k] = self.elements[k][0]);
        Spectrum::unchecked(values)
    }

    /// The weights that an observer with these weights has before the element: the transpose of
    /// [`turn`](Self::turn).
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
    // One square root is enough where the product is in range.
    let both = if 1e-30 < product && product < 1e30 {
        sqrt_by_digits(product)
    } else {
        sqrt_by_digits(along) * sqrt_by_digits(across)
    };
    [0.5 * along + 0.5 * across, 0.5 * along - 0.5 * across, both]
}
