//! Complex numbers, for the amplitude and phase of a field and for the refractive index of matter that
//! absorbs.

use crate::math::sqrt;
use core::ops::{Add, Mul, Sub};

/// A complex number, which describes the amplitude and the phase of an electric field.
///
/// # Example
/// ```
/// use nanospectra::math::Complex;
///
/// let field = Complex { re: 3.0, im: 4.0 };
/// assert_eq!(field.power(), 25.0);
/// // A quarter of a period later: times i.
/// assert_eq!(field * Complex { re: 0.0, im: 1.0 }, Complex { re: -4.0, im: 3.0 });
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Complex {
    /// The real part, which is the absolute value times the cosine of the phase. See the
    /// [example](Complex#example).
    pub re: f32,
    /// The imaginary part, which is the absolute value times the sine of the phase. See the
    /// [example](Complex#example).
    pub im: f32,
}

impl Complex {
    pub(crate) const fn new(re: f32, im: f32) -> Self {
        Complex { re, im }
    }

    /// Returns the square of the absolute value, which is the power of a field. See the
    /// [example](Complex#example).
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

    /// 1 over this number, also where the square of its absolute value is beyond f32.
    pub(crate) fn inverse(self) -> Self {
        let size = self.re.abs().max(self.im.abs());
        let (re, im) = (self.re / size, self.im / size);
        let square = re * re + im * im;
        Complex { re: re / square / size, im: -im / square / size }
    }

    /// The square root of a number whose imaginary part is zero or more, without cancellation. Both parts of
    /// the root are zero or more.
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
