//! Complex numbers: a field's amplitude and phase, an index that absorbs.

use crate::math::sqrt;
use core::ops::{Add, Mul, Sub};

/// A complex number: the amplitude of a field, and its phase.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Complex {
    /// The real part.
    pub re: f32,
    /// The imaginary part.
    pub im: f32,
}

impl Complex {
    pub(crate) const fn new(re: f32, im: f32) -> Self {
        Complex { re, im }
    }

    /// The square of its size.
    #[must_use]
    pub const fn power(self) -> f32 {
        self.re * self.re + self.im * self.im
    }

    pub(crate) fn plus(self, real: f32) -> Self {
        Complex { re: self.re + real, im: self.im }
    }

    pub(crate) fn times(self, real: f32) -> Self {
        Complex { re: self.re * real, im: self.im * real }
    }

    pub(crate) fn over(self, other: Complex) -> Self {
        (self * Complex { re: other.re, im: -other.im }).times(1.0 / other.power())
    }

    /// 1 over this, for sizes whose square f32 cannot hold too.
    pub(crate) fn inverse(self) -> Self {
        let size = self.re.abs().max(self.im.abs());
        let (re, im) = (self.re / size, self.im / size);
        let square = re * re + im * im;
        Complex { re: re / square / size, im: -im / square / size }
    }

    /// The root with a real and an imaginary part of zero or more, of a number whose imaginary part is;
    /// without cancellation.
    pub(crate) fn sqrt(self) -> Self {
        let size = self.re.abs().max(self.im.abs());
        if size == 0.0 {
            return self;
        }
        let (re, im) = (self.re / size, self.im / size);
        let large = sqrt(size) * sqrt(0.5 * (re.abs() + sqrt(re * re + im * im)));
        let small = 0.5 * self.im / large;
        if re >= 0.0 { Complex::new(large, small) } else { Complex::new(small, large) }
    }
}

impl Add for Complex {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Complex { re: self.re + other.re, im: self.im + other.im }
    }
}

impl Sub for Complex {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Complex { re: self.re - other.re, im: self.im - other.im }
    }
}

impl Mul for Complex {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Complex { re: self.re * other.re - self.im * other.im, im: self.re * other.im + self.im * other.re }
    }
}
