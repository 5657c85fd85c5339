//! Tristimulus values in integers.

use crate::color::Xyz;
use crate::sensor::fixed::FixedCct;
use crate::sensor::fixed::cct::quotient;

/// Holds X, Y and Z as integers in a common unit, which is a power of two of the unit of the
/// calibration.
///
/// [`FixedMeter::xyz`](crate::sensor::fixed::FixedMeter::xyz) returns it. [`lux`](Self::lux) and
/// [`cct`](Self::cct) are what one asks first.
///
/// # Example
///
/// ```
/// use nanospectra::sensor::fixed::{FixedCct, FixedXyz};
///
/// // X = 95.05, Y = 100, Z = 108.88, daylight D65, in units of 2^-20.
/// let d65 = FixedXyz::new([95.05, 100.0, 108.88].map(|value: f32| (value * 1048576.0) as i32), 20);
/// assert_eq!((d65.lux(), d65.millilux(), d65.y), (100, 100_000, 100 << 20));
/// assert_eq!((d65.fraction(), d65.to_xyz().y), (20, 100.0));
/// assert!(matches!(d65.cct(), Some(FixedCct::Near { cct_k: 6500..=6508, .. })));
/// let Some([u, v]) = d65.uv1960() else { return };
/// assert_eq!([u * 1000 >> 20, v * 1000 >> 20], [197, 312]); // u = 0.1978, v = 0.3122
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FixedXyz {
    /// The tristimulus value X, which is below 2^31 in size.
    pub x: i32,
    /// The tristimulus value Y, which is below 2^31 in size. See the [example](#example).
    pub y: i32,
    /// The tristimulus value Z, which is below 2^31 in size.
    pub z: i32,
    fraction: i32,
}

impl FixedXyz {
    /// Returns Y rounded to the nearest integer, which is lux if the calibration is in lux. See the
    /// [example](#example).
    ///
    /// Negative values give 0, and values beyond `u32::MAX` give `u32::MAX`.
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

    /// Returns Y in thousandths, rounded down, which is millilux if the calibration is in lux. See the
    /// [example](#example).
    ///
    /// Negative values give 0, and values beyond `u32::MAX` give `u32::MAX`.
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

    /// Computes CCT and Duv on the CIE 1931 2 degree observer, as [`Uv1960::cct`](crate::color::Uv1960::cct)
    /// does. See the [example](#example).
    ///
    /// `None` for black.
    ///
    /// # Accuracy
    /// 0.11 mired and 2.5e-5 in Duv over 1000 K..1e6 K and |Duv| <= 0.05, with sums above 2^20 (searched in
    /// `tests/sensor/worst_readings.rs`).
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

    /// Computes CIE 1960 u and v in units of 2^-20. See the [example](#example).
    ///
    /// The result is `None` for black, and for a color whose u or v is not within 0 <= u, v < 1.
    #[must_use]
    pub fn uv1960(self) -> Option<[i32; 2]> {
        // Sizes are below 2^26 and the largest is above 2^25: sums stay below 2^31, and quotients keep their
        // digits.
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

    /// Converts the same values to floating point. See the [example](#example).
    #[must_use]
    pub fn to_xyz(self) -> Xyz {
        // Only the exponent changes, so that a core without an FPU needs no multiplication.
        let scaled = |x: i32| {
            let whole = (x as f32).to_bits() as i32;
            if x == 0 { 0.0 } else { f32::from_bits((whole - (self.fraction << 23)) as u32) }
        };
        Xyz { x: scaled(self.x), y: scaled(self.y), z: scaled(self.z) }
    }

    /// Makes X, Y and Z from integers in units of 2^-fraction. See the [example](#example).
    ///
    /// `fraction` is -62..=62; beyond that it counts as the nearest of the two.
    #[must_use]
    pub const fn new([x, y, z]: [i32; 3], fraction: i32) -> Self {
        let fraction = if fraction > 62 { 62 } else { fraction };
        FixedXyz { x, y, z, fraction: if fraction < -62 { -62 } else { fraction } }
    }

    /// Returns the exponent of the unit, which is 2^-fraction. See the [example](#example).
    #[must_use]
    pub const fn fraction(self) -> i32 {
        self.fraction
    }
}
