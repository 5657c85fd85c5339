//! Counts of a chip to XYZ in integers.

use crate::math::const_for;
use crate::sensor::fixed::FixedXyz;
use crate::sensor::{Calibration, Channels, Exposure, ReadingError};

/// A light meter in integers: the exposure, dark level and calibration of a [`Meter`](crate::sensor::Meter)
/// as weights of 31 bits.
///
/// # Accuracy
/// XYZ within `2 C + 2` units of 2^-30 of its full scale (what all counts at 65 535 would give, if no weight
/// were negative).
///
/// # Cost
/// Eight channels to XYZ and lux on a Cortex-M0: 306 instructions, where [`Meter`](crate::sensor::Meter)
/// takes some 6 400.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FixedMeter<const C: usize> {
    /// Of each channel, what 2^16 counts add to X, Y and Z.
    columns: [[i32; 3]; C],
    start: [i32; 3],
    /// One unit of the sums is 2^-fraction of what the calibration gives (lux, mostly).
    fraction: i32,
    full_scale: u16,
    /// The least sum of all counts.
    floor: u32,
}

/// The sizes of a row's weights, with what it starts from, add up to less than this.
const LARGEST_SUM: f64 = (1_u32 << 30) as f64;

impl<const C: usize> FixedMeter<C> {
    /// A meter for readings with this exposure; `None` if all weights are zero, one is no number, or they are
    /// beyond 1e-15..1e15 or so of what is usual. For `const` use:
    /// it computes in f64.
    #[must_use]
    pub const fn new(exposure: &Exposure, calibration: &Calibration<C>) -> Option<Self> {
        Self::new_above(exposure, &[0.0; C], calibration)
    }

    /// A meter that first takes these dark levels, in counts of the exposure, off each channel; `None` too if
    /// one is not within 0..=65 535.
    #[must_use]
    pub const fn new_above(
        exposure: &Exposure,
        dark_levels: &[f32; C],
        calibration: &Calibration<C>,
    ) -> Option<Self> {
        let per_count = 1.0 / (exposure.gain() as f64 * exposure.time_ms() as f64);
        let rows = calibration.rows();
        // The largest sum of sizes of a row decides on the scale: 65 535 counts in every channel, and the
        // start is no larger than that, since no dark level is.
        let mut largest = 0.0;
        const_for!(0..3, |d| {
            let mut sum = 0.0;
            const_for!(0..C, |c| sum += (rows[d][c] as f64 * per_count).abs() * 65_536.0);
            // NaN comes and stays.
            largest = if sum <= largest || largest.is_nan() { largest } else { sum };
        });
        if !(largest > 0.0 && largest < f64::INFINITY) {
            return None;
        }
        let (mut fraction, mut scale) = (0, 1.0);
        while largest * scale * 2.0 < LARGEST_SUM && fraction < 62 {
            scale *= 2.0;
            fraction += 1;
        }
        while largest * scale >= LARGEST_SUM && fraction > -62 {
            scale /= 2.0;
            fraction -= 1;
        }
        if largest * scale >= LARGEST_SUM || largest * scale * 2.0 < LARGEST_SUM {
            return None;
        }
        let (mut columns, mut start, mut total) = ([[0; 3]; C], [0; 3], exposure.floor() as f64);
        let mut c = 0;
        while c < C {
            if !(dark_levels[c] >= 0.0 && dark_levels[c] <= 65_535.0) {
                return None;
            }
            total += dark_levels[c] as f64;
            const_for!(0..3, |d| {
                let weight = rows[d][c] as f64 * per_count * scale;
                columns[c][d] = rounded(weight * 65_536.0);
                start[d] -= rounded(weight * dark_levels[c] as f64);
            });
            c += 1;
        }
        let full_scale = if exposure.full_scale() < 65_535 { exposure.full_scale() as u16 } else { 65_535 };
        Some(FixedMeter { columns, start, fraction, full_scale, floor: ceiling(total) })
    }

    /// The tristimulus values of one reading.
    ///
    /// # Errors
    /// `Saturated` with the channels at full scale; `TooDark`; `Negative`, with the sums, if one of them is
    /// below zero.
    #[inline]
    pub fn xyz(&self, counts: &[u16; C]) -> Result<FixedXyz, ReadingError> {
        let ([mut x, mut y, mut z], mut total, mut headroom) = (self.start, 0, -1);
        for (count, [to_x, to_y, to_z]) in counts.iter().zip(&self.columns) {
            let count = u32::from(*count);
            headroom &= count as i32 - i32::from(self.full_scale);
            total += count;
            x += times(count, *to_x);
            y += times(count, *to_y);
            z += times(count, *to_z);
        }
        if headroom >= 0 || total < self.floor {
            return Err(ReadingError::because(counts, self.full_scale.into()));
        }
        let xyz = FixedXyz::new([x, y, z], self.fraction);
        if x | y | z < 0 { Err(ReadingError::Negative { xyz: xyz.to_xyz() }) } else { Ok(xyz) }
    }

    /// The channels at or above full scale.
    #[must_use]
    pub fn saturated(&self, counts: &[u16; C]) -> Channels {
        Channels::saturated(counts, self.full_scale.into())
    }
}

/// count * weight / 2^16, rounded down: a product of 48 bits by two of 32. Neither overflows: |weight| <
/// 2^30, so the upper half is within 2^14, and 16 bits by 16 fit.
#[inline(always)]
fn times(count: u32, weight: i32) -> i32 {
    let upper = count as i32 * (weight >> 16);
    let lower = count * (weight as u32 & 0xffff);
    upper + (lower >> 16) as i32
}

/// To the nearest integer, in const fn.
const fn rounded(x: f64) -> i32 {
    if x < 0.0 { -((0.5 - x) as i32) } else { (x + 0.5) as i32 }
}

const fn ceiling(x: f64) -> u32 {
    let whole = x as u32;
    if (whole as f64) < x { whole.saturating_add(1) } else { whole }
}
