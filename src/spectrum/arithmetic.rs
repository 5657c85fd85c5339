//! Light adds, scales, and is weakened by factors.

use crate::grid::Bands;
use crate::spectrum::{Factor, Spectrum};
use core::ops::{Add, AddAssign, Mul, MulAssign, Sub};

impl<Q, const N: usize, G: Bands> Add for Spectrum<Q, N, G> {
    type Output = Self;
    /// Two lights shining at once (or two shares added).
    fn add(mut self, other: Self) -> Self {
        self += other;
        self
    }
}

impl<Q, const N: usize, G: Bands> AddAssign for Spectrum<Q, N, G> {
    fn add_assign(&mut self, other: Self) {
        for (a, b) in self.0.iter_mut().zip(&other.0) {
            *a += b;
        }
    }
}

impl<Q, const N: usize, G: Bands> Sub for Spectrum<Q, N, G> {
    type Output = Self;
    /// What one has more than the other: dark reading off, for example.
    fn sub(mut self, other: Self) -> Self {
        for (a, b) in self.0.iter_mut().zip(&other.0) {
            *a -= b;
        }
        self
    }
}

impl<Q, const N: usize, G: Bands> Mul<f32> for Spectrum<Q, N, G> {
    type Output = Self;
    /// Every bin times one number.
    fn mul(mut self, k: f32) -> Self {
        self *= k;
        self
    }
}

impl<Q, const N: usize, G: Bands> MulAssign<f32> for Spectrum<Q, N, G> {
    fn mul_assign(&mut self, k: f32) {
        for value in &mut self.0 {
            *value *= k;
        }
    }
}

impl<Q, const N: usize, G: Bands> Mul<Spectrum<Factor, N, G>> for Spectrum<Q, N, G> {
    type Output = Self;
    /// Light through a filter or off a surface; or two filters in a row.
    fn mul(mut self, factor: Spectrum<Factor, N, G>) -> Self {
        for (value, k) in self.0.iter_mut().zip(&factor.0) {
            *value *= k;
        }
        self
    }
}
