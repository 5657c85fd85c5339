//! What can be integrated, and sums of many terms of it.

use core::ops::{Add, Mul};

/// What can be integrated: a number, or a spectrum, for which every wavelength is integrated at once.
pub trait Integrand: Copy + Add<Output = Self> + Mul<f32, Output = Self> {
    /// Nothing.
    const ZERO: Self;

    /// Adds `value`; `lost` keeps what rounding took from the sum, for the next addition (Kahan's summation).
    fn accumulate(&mut self, lost: &mut Self, value: &Self);

    /// Each number of it by a function.
    #[must_use]
    fn map(self, f: impl Fn(f32) -> f32) -> Self;

    /// The largest number of it; NaN if there is one.
    fn peak(&self) -> f32;

    /// The largest difference to another, without its sign; NaN if there is one.
    fn distance(&self, other: &Self) -> f32;
}

impl Integrand for f32 {
    const ZERO: Self = 0.0;

    fn accumulate(&mut self, lost: &mut Self, value: &Self) {
        let value = value - *lost;
        let sum = *self + value;
        *lost = (sum - *self) - value;
        *self = sum;
    }

    fn map(self, f: impl Fn(f32) -> f32) -> Self {
        f(self)
    }

    fn peak(&self) -> f32 {
        *self
    }

    fn distance(&self, other: &Self) -> f32 {
        (self - other).abs()
    }
}

/// A sum of thousands of equal terms: plain addition would be off by as many roundings, all in one direction.
pub(crate) struct Total<V> {
    pub(crate) sum: V,
    lost: V,
}

impl<V: Integrand> Total<V> {
    pub(crate) const fn new() -> Self {
        Total { sum: V::ZERO, lost: V::ZERO }
    }

    pub(crate) fn add(&mut self, value: V) {
        self.sum.accumulate(&mut self.lost, &value);
    }
}
