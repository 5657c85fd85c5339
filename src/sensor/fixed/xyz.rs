//! Tristimulus values in integers.

use crate::color::Xyz;
use crate::sensor::fixed::FixedCct;
use crate::sensor::fixed::cct::quotient;

/// X, Y and Z as integers in a common unit, a power of two of the calibration's: below 2^31 in size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FixedXyz {
    /// X
    pub x: i32,
    /// Y
    pub y: i32,
    /// Z
    pub z: i32,
    fraction: i32,
}

impl FixedXyz {
    /// `[X, Y, Z]` in units of 2^-fraction, where `fraction` is -62..=62 (beyond that it counts as the
    /// nearest).
    #[must_use]
    pub const fn new([x, y, z]: [i32; 3], fraction: i32) -> Self {
        let fraction = if fraction > 62 { 62 } else { fraction };
        FixedXyz { x, y, z, fraction: if fraction < -62 { -62 } else { fraction } }
    }

    /// One unit is 2^-fraction.
    #[must_use]
    pub const fn fraction(self) -> i32 {
        self.fraction
    }

    /// The same values in floating point.
    #[must_use]
    pub fn to_xyz(self) -> Xyz {
        // By the exponent alone: a core without an FPU needs no multiplication for it.
        let scaled = |x: i32| {
            let whole = (x as f32).to_bits() as i32;
            if x == 0 { 0.0 } else { f32::from_bits((whole - (self.fraction << 23)) as u32) }
        };
        Xyz { x: scaled(self.x), y: scaled(self.y), z: scaled(self.z) }
    }

    /// Y to the nearest integer: lux, if the calibration is in lux. Negative ones are 0, and what is beyond
    /// `u32::MAX` is that.
    #[must_use]
    pub const fn lux(self) -> u32 {
        let y = if self.y > 0 { self.y as u32 } else { 0 };
        match self.fraction {
            32.. => 0,
            1..=31 => (y >> self.fraction as u32) + (y >> (self.fraction as u32 - 1) & 1),
            0 => y,
            _ => {
                let left = -self.fraction as u32;
                if y == 0 {
                    0
                } else if left > y.leading_zeros() {
                    u32::MAX
                } else {
                    y << left
                }
            }
        }
    }

    /// Y in thousandths, to the nearest below: millilux. Negative ones are 0, and what is beyond `u32::MAX`
    /// is that.
    #[must_use]
    pub const fn millilux(self) -> u32 {
        let y = if self.y > 0 { self.y as u64 * 1000 } else { 0 };
        let shifted = if self.fraction >= 0 {
            y >> self.fraction as u32
        } else if (-self.fraction as u32) < y.leading_zeros() {
            y << -self.fraction as u32
        } else {
            u64::MAX
        };
        if shifted > u32::MAX as u64 { u32::MAX } else { shifted as u32 }
    }

    /// CIE 1960 u and v in units of 2^-20; `None` for black and for what lies outside 0 <= u, v < 1.
    #[must_use]
    pub fn uv1960(self) -> Option<[i32; 2]> {
        // Sizes below 2^26, the largest above 2^25: sums stay below 2^31, and quotients keep their digits.
        let size = self.x.unsigned_abs() | self.y.unsigned_abs() | self.z.unsigned_abs();
        let [x, y, z] = match size.leading_zeros() {
            32 => return None,
            spare @ 6.. => [self.x << (spare - 6), self.y << (spare - 6), self.z << (spare - 6)],
            spare => [self.x >> (6 - spare), self.y >> (6 - spare), self.z >> (6 - spare)],
        };
        let sum = x + 15 * y + 3 * z;
        if sum <= 0 || x < 0 || y < 0 || 4 * x >= sum || 6 * y >= sum {
            return None;
        }
        Some([quotient(4 * x as u32, sum as u32, 20), quotient(6 * y as u32, sum as u32, 20)])
    }

    /// CCT and Duv on the CIE 1931 2 degree observer, as [`Uv1960::cct`](crate::color::Uv1960::cct); `None`
    /// for black.
    ///
    /// # Accuracy
    /// 0.13 mired and 2.5e-5 in Duv over 1000 K..1e6 K and |Duv| <= 0.05 (`tests/sensor/fixed.rs`), with sums
    /// above 2^20.
    ///
    /// # Cost
    /// From counts on 1700 instructions on a Cortex-M0, where [`Uv1960::cct`](crate::color::Uv1960::cct)
    /// alone takes 14 300; 500 bytes of table.
    #[must_use]
    pub fn cct(self) -> Option<FixedCct> {
        if self.x | self.y | self.z == 0 {
            return None;
        }
        Some(match self.uv1960() {
            Some(uv) => FixedCct::of(uv),
            None => FixedCct::OffLocus,
        })
    }
}
