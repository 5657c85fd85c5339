//! Defines what can be integrated, and sums of many terms.

use core::ops::{Add, Mul};

/// A value that can be integrated over directions, such as a number or a spectrum.
///
/// A spectrum is integrated in all its bins at once. The library implements this trait for `f32`, for
/// [`Spectrum`](crate::Spectrum) and for the numbers of [`radiometry`](crate::radiometry); a program calls
/// [`Hemisphere::integrate`](crate::geometry::Hemisphere::integrate) with any of them. The methods below
/// serve algorithms that are written for every kind of value.
///
/// # Example
/// ```
/// use nanospectra::geometry::{GaussLegendre, Hemisphere, Integrand};
/// use nanospectra::Light;
///
/// // A sky of equal radiance in every direction, integrated in 16 bins at once: pi times the radiance.
/// let sky = Light::<16>::flat(2.0);
/// let e: Light<16> = GaussLegendre::<4, 1>.integrate_projected(|_| sky);
/// assert!(e.distance(&Light::flat(6.283_185)) < 1e-5);
/// assert_eq!(sky.map(|value| value * value).peak(), 4.0);
/// ```
pub trait Integrand: Copy + Add<Output = Self> + Mul<f32, Output = Self> {
    /// The value from which a sum starts, with all numbers 0.
    const ZERO: Self;

    /// Adds `value` by Kahan's summation, which keeps in `lost` what rounding took from the sum.
    ///
    /// Pass the same `lost` with every addition, and begin with [`ZERO`](Self::ZERO) in both.
    ///
    /// # Example
    /// ```
    /// # use nanospectra::geometry::Integrand;
    /// let (mut sum, mut lost) = (f32::ZERO, f32::ZERO);
    /// (0..1_000_000).for_each(|_| sum.accumulate(&mut lost, &0.1));
    /// assert!((sum - 100_000.0).abs() < 0.01);
    /// // Plain additions are off by almost 1 %.
    /// assert!((0..1_000_000).fold(0.0, |sum: f32, _| sum + 0.1) > 100_900.0);
    /// ```
    fn accumulate(&mut self, lost: &mut Self, value: &Self);

    /// Returns the value with a function applied to each of its numbers.
    ///
    /// See the [example](Integrand#example).
    #[must_use]
    fn map(self, f: impl Fn(f32) -> f32) -> Self;

    /// Returns the largest of the value's numbers, or NaN if one of them is.
    ///
    /// See the [example](Integrand#example).
    fn peak(&self) -> f32;

    /// Returns the largest absolute difference between the numbers of two values, or NaN if one of them is.
    ///
    /// See the [example](Integrand#example).
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

/// A sum of many terms by Kahan's summation.
///
/// Thousands of nearly equal terms, added plainly, can all be rounded in the same direction.
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
