//! Arithmetic of spectra, bin by bin: lights add up, factors weaken them, and a light over a light is a
//! factor.

use crate::grid::Bands;
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::math::{Math, assigning_operator, at_least, at_most, linear_operators, operator, sqrt};
use crate::spectrum::{Factor, Power, Spectrum};
use core::ops::{Index, IndexMut};

impl<Q, const N: usize, G> Spectrum<Q, N, G> {
    /// Combines each bin with the same bin of another spectrum by a function.
    #[inline(always)]
    fn zip<P, R>(&self, other: &Spectrum<P, N, G>, f: impl Fn(f32, f32) -> f32) -> Spectrum<R, N, G> {
        let mut values = [0.0; N];
        for (value, (a, b)) in values.iter_mut().zip(self.0.iter().zip(&other.0)) {
            *value = f(*a, *b);
        }
        Spectrum::unchecked(values)
    }

    /// Applies a function to each bin.
    #[inline(always)]
    pub(super) fn each(&self, f: impl Fn(f32) -> f32) -> Self {
        let mut values = [0.0; N];
        for (value, a) in values.iter_mut().zip(&self.0) {
            *value = f(*a);
        }
        Spectrum::unchecked(values)
    }
}

// The sum of two lights that shine at once, their difference, and multiples of a spectrum.
linear_operators! {
    [Q, const N: usize, G: Bands] Spectrum<Q, N, G>, Spectrum::flat(0.0);
    |a, b| { a.zip(b, |a, b| a + b) } { a.zip(b, |a, b| a - b) }
    { a.each(|a| a * b) } { a.each(|a| a / b) } { a.each(|a| -a) }
}

// Light that passes a filter or leaves a surface, or two filters in a row; division undoes this.
assigning_operator! {
    [Q, const N: usize, G: Bands] Mul mul MulAssign mul_assign
    |a: Spectrum<Q, N, G>, b: Spectrum<Factor, N, G>| { a.zip(b, |a, b| a * b) }
}
assigning_operator! {
    [Q, const N: usize, G: Bands] Div div DivAssign div_assign
    |a: Spectrum<Q, N, G>, b: Spectrum<Factor, N, G>| { a.zip(b, |a, b| a / b) }
}
operator! {
    [const N: usize, G: Bands] Mul mul
    |a: Spectrum<Factor, N, G>, b: Spectrum<Power, N, G>| -> Spectrum<Power, N, G> { b.zip(a, |b, a| b * a) }
}
// The ratio of two lights, such as behind and before a filter, is a factor.
operator! {
    [const N: usize, G: Bands] Div div
    |a: Spectrum<Power, N, G>, b: Spectrum<Power, N, G>| -> Spectrum<Factor, N, G> { a.zip(b, |a, b| a / b) }
}

/// A spectrum that is zero in every bin.
impl<Q, const N: usize, G: Bands> Default for Spectrum<Q, N, G> {
    fn default() -> Self {
        Spectrum::flat(0.0)
    }
}

/// The value of bin `k`.
///
/// This panics for `k >= N`, as arrays do; [`values`](Spectrum::values)`().get(k)` does not.
impl<Q, const N: usize, G> Index<usize> for Spectrum<Q, N, G> {
    type Output = f32;

    #[inline]
    fn index(&self, k: usize) -> &f32 {
        &self.0[k]
    }
}

/// The value of bin `k`, to write to. This panics for `k >= N`, as reading does.
impl<Q, const N: usize, G> IndexMut<usize> for Spectrum<Q, N, G> {
    #[inline]
    fn index_mut(&mut self, k: usize) -> &mut f32 {
        &mut self.0[k]
    }
}

/// Functions of all bins. A NaN stays NaN in its bin.
impl<Q, const N: usize, G: Bands> Spectrum<Q, N, G> {
    /// Returns this spectrum with each value limited to `low..=high`.
    ///
    /// If `low` is above `high`, the result is `high`; nothing panics.
    ///
    /// ```
    /// # use nanospectra::Reflectance;
    /// let paint = Reflectance::<3>::from_bins([-0.1, 0.5, f32::NAN]).clamp(0.0, 1.0);
    /// assert!(paint[0] == 0.0 && paint[1] == 0.5 && paint[2].is_nan());
    /// ```
    #[must_use]
    #[inline]
    pub fn clamp(&self, low: f32, high: f32) -> Self {
        self.each(|value| at_most(at_least(value, low), high))
    }

    /// Returns the linear mix of this spectrum (`t` = 0) and another one (`t` = 1), which is exact at both
    /// ends.
    ///
    /// ```
    /// # use nanospectra::Light;
    /// assert_eq!(Light::<16>::flat(2.0).lerp(&Light::flat(4.0), 0.25), Light::flat(2.5));
    /// ```
    #[must_use]
    #[inline]
    pub fn lerp(&self, other: &Self, t: f32) -> Self {
        self.zip(other, |a, b| (1.0 - t) * a + t * b)
    }

    /// Returns the larger of both values for each bin, and NaN where either value is NaN.
    ///
    /// The largest value of all bins is [`peak`](Self::peak).
    ///
    /// ```
    /// # use nanospectra::Light;
    /// let (a, b) = (Light::<3>::from_bins([1.0, 2.0, f32::NAN]), Light::from_bins([3.0, 0.5, 1.0]));
    /// assert!(a.max(&b).values()[..2] == [3.0, 2.0] && a.max(&b)[2].is_nan() && b.max(&a)[2].is_nan());
    /// assert!(a.min(&b).values()[..2] == [1.0, 0.5] && a.min(&b)[2].is_nan() && b.min(&a)[2].is_nan());
    /// ```
    #[must_use]
    #[inline]
    pub fn max(&self, other: &Self) -> Self {
        self.zip(other, |a, b| if a > b || a.is_nan() { a } else { b })
    }

    /// Returns the smaller of both values for each bin, and NaN where either value is NaN. See the
    /// [example](Self::max) of `max`.
    #[must_use]
    #[inline]
    pub fn min(&self, other: &Self) -> Self {
        self.zip(other, |a, b| if a < b || a.is_nan() { a } else { b })
    }

    /// Returns whether every value is zero; a spectrum that holds a NaN is not black.
    ///
    /// ```
    /// # use nanospectra::Light;
    /// assert!(Light::<16>::default().is_black() && !Light::<16>::flat(1e-30).is_black());
    /// ```
    #[must_use]
    #[inline]
    pub fn is_black(&self) -> bool {
        self.0.iter().all(|value| *value == 0.0)
    }
}

impl<const N: usize, G: Bands> Spectrum<Factor, N, G> {
    /// Returns the correctly rounded square root of each value, and NaN for a value below zero.
    ///
    /// The root of a transmittance is that of a filter half as thick.
    ///
    /// ```
    /// # use nanospectra::Reflectance;
    /// assert_eq!(Reflectance::<16>::flat(0.25).sqrt(), Reflectance::flat(0.5));
    /// ```
    #[must_use]
    pub fn sqrt(&self) -> Self {
        self.each(sqrt)
    }

    /// Returns e to the power of each value.
    ///
    /// The transmittance of a medium of optical depth `depth` is `(-depth).exp()`.
    ///
    /// ```
    /// # use nanospectra::Reflectance;
    /// let depth = Reflectance::<16>::flat(1.0);
    /// assert!(((-depth).exp()[0] - 0.367_879_4).abs() < 1e-7);
    /// ```
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn exp(&self) -> Self {
        self.exp_with::<Portable>()
    }

    /// Returns e to the power of each value, computed by the math backend `M`.
    ///
    /// ```
    /// # use nanospectra::{Reflectance, math::Fast};
    /// let depth = Reflectance::<16>::flat(1.0);
    /// assert!(((-depth).exp_with::<Fast>()[0] - 0.367_879_4).abs() < 1e-7);
    /// ```
    #[must_use]
    pub fn exp_with<M: Math>(&self) -> Self {
        self.each(M::exp)
    }
}
