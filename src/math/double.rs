//! Numbers of 48 bits as the sum of two f32. They hold the phase of light in a film as thick as 400 000
//! wavelengths, of which only the fraction of a turn matters.

use crate::math::sqrt;
use crate::math::turns::fraction;

/// The number `high + low`, where `low` is below half a unit in the last place of `high`.
#[derive(Clone, Copy)]
pub(crate) struct Double {
    pub(crate) high: f32,
    pub(crate) low: f32,
}

impl Double {
    pub(crate) const fn new(x: f32) -> Self {
        Double { high: x, low: 0.0 }
    }

    /// The sum of two f32 without loss (Knuth).
    pub(crate) const fn sum(a: f32, b: f32) -> Self {
        let high = a + b;
        let part = high - a;
        Double { high, low: (a - (high - part)) + (b - part) }
    }

    /// The product of two f32 without loss (Dekker, with halves of 12 bits cut by a mask, which cannot
    /// overflow).
    pub(crate) const fn product(a: f32, b: f32) -> Self {
        let high = a * b;
        let ([a1, a2], [b1, b2]) = (halves(a), halves(b));
        Double { high, low: ((a1 * b1 - high) + a1 * b2 + a2 * b1) + a2 * b2 }
    }

    pub(crate) const fn plus(self, other: Self) -> Self {
        let Double { high, low } = Self::sum(self.high, other.high);
        Self::sum(high, low + (self.low + other.low))
    }

    pub(crate) const fn minus(self, other: Self) -> Self {
        self.plus(Double { high: -other.high, low: -other.low })
    }

    pub(crate) const fn times(self, other: Self) -> Self {
        let Double { high, low } = Self::product(self.high, other.high);
        Self::sum(high, low + (self.high * other.low + self.low * other.high))
    }

    pub(crate) const fn over(self, divisor: f32) -> Self {
        let quotient = self.high / divisor;
        let back = Self::product(quotient, divisor);
        let rest = (self.high - back.high) - back.low + self.low;
        Self::sum(quotient, rest / divisor)
    }

    /// The square root of a number above zero.
    pub(crate) fn sqrt(self) -> Self {
        let root = sqrt(self.high);
        let square = Self::product(root, root);
        let rest = (self.high - square.high) - square.low + self.low;
        Self::sum(root, rest / (root + root))
    }

    /// The difference to the nearest whole number, -1/2..=1/2, exact but for the last rounding.
    pub(crate) fn fraction(self) -> f32 {
        fraction(fraction(self.high) + fraction(self.low))
    }
}

/// Splits a number of 24 bits into one of 12 bits and the rest.
const fn halves(x: f32) -> [f32; 2] {
    let head = f32::from_bits(x.to_bits() & 0xffff_f000);
    [head, x - head]
}
