//! Counts of a chip to XYZ in integers.

use crate::math::const_for;
use crate::sensor::fixed::FixedXyz;
use crate::sensor::{Calibration, Channels, Exposure, ReadingError};

/// A light meter that turns raw counts into XYZ in integers, as [`Meter`](crate::sensor::Meter) does in
/// floats.
///
/// Exposure, dark level and calibration are weights of 31 bits. [`new`](Self::new) makes the meter in a
/// `static`, and [`xyz`](Self::xyz) reads it.
///
/// # Example
///
/// ```
/// use nanospectra::sensor::fixed::FixedMeter;
/// use nanospectra::sensor::{Calibration, Exposure, ReadingError};
///
/// static TO_XYZ: Calibration<2> = Calibration::from_rows([[0.9, 0.1], [0.4, 0.6], [0.0, 1.1]]);
/// static METER: FixedMeter<2> =
///     FixedMeter::new_above(&Exposure::new(4.0, 25.0, 65_535), &[3.0, 5.0], &TO_XYZ).unwrap();
/// // 10 and 20 counts per ms at unit gain: Y = 0.4 * 10 + 0.6 * 20 = 16.
/// let xyz = METER.xyz(&[1003, 2005])?;
/// assert_eq!(xyz.lux(), 16);
/// assert_eq!(METER.xyz(&[3, 5]), Err(ReadingError::TooDark));
/// assert!(METER.saturated(&[3, 65_535]).contains(1));
/// # Ok::<(), ReadingError>(())
/// ```
///
/// # Accuracy
/// XYZ within `3 C` units of 2^-30 of its full scale, and `4 C` above dark levels. (Full scale is what all
/// counts at 65 535 would give the largest of X, Y and Z, if no weight were negative.)
///
/// # Cost
/// Eight channels to XYZ and lux on a Cortex-M0: 306 instructions, where [`Meter`](crate::sensor::Meter)
/// takes some 6 400.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FixedMeter<const C: usize> {
    /// What 2^16 counts of each channel add to X, Y and Z.
    columns: [[i32; 3]; C],
    start: [i32; 3],
    /// The unit of the sums, which is 2^-fraction of what the calibration gives (lux, mostly).
    fraction: i32,
    full_scale: u16,
    /// The least sum of all counts that is not too dark.
    floor: u32,
}

/// The limit of each row: the sizes of its weights, and what it starts from, add up to less than this.
const LARGEST_SUM: f64 = (1_u32 << 30) as f64;

impl<const C: usize> FixedMeter<C> {
    /// Makes a meter for readings with this exposure.
    ///
    /// `None` if all weights are zero, if one is NaN or infinite, or if they are beyond 1e-15..1e15 or so of
    /// what is usual. It computes in f64, so call it in a `const` or a `static`.
    ///
    /// ```
    /// # use nanospectra::sensor::{Calibration, Exposure, fixed::FixedMeter};
    /// static TO_LUX: Calibration<1> = Calibration::from_rows([[0.0], [2.0], [0.0]]);
    /// static METER: FixedMeter<1> = FixedMeter::new(&Exposure::new(1.0, 10.0, 65_535), &TO_LUX).unwrap();
    /// assert_eq!(METER.xyz(&[500])?.lux(), 100); // 500 / 10 * 2
    /// # Ok::<(), nanospectra::sensor::ReadingError>(())
    /// ```
    #[must_use]
    pub const fn new(exposure: &Exposure, calibration: &Calibration<C>) -> Option<Self> {
        Self::new_above(exposure, &[0.0; C], calibration)
    }

    /// Computes the tristimulus values of one reading. See the [example](#example).
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

    /// Makes a meter that first subtracts these dark levels, in counts of the exposure, from each channel.
    /// See the [example](#example).
    ///
    /// The result is `None` in the same cases as that of [`new`](Self::new), and if a dark level is not
    /// within 0..=65 535. It computes in f64, so call it in a `const` or a `static`.
    #[must_use]
    pub const fn new_above(
        exposure: &Exposure,
        dark_levels: &[f32; C],
        calibration: &Calibration<C>,
    ) -> Option<Self> {
        let per_count = 1.0 / (exposure.gain() as f64 * exposure.time_ms() as f64);
        let rows = calibration.rows();
        // The largest row decides on the scale, at 65 535 counts in every channel. The start is no larger
        // than that, since no dark level is.
        let mut largest = 0.0;
        const_for!(0..3, |d| {
            let mut sum = 0.0;
            const_for!(0..C, |c| sum += (rows[d][c] as f64 * per_count).abs() * 65_536.0);
            // A NaN comes in, since no comparison with it is true, and then it stays.
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

    /// Returns the set of channels that are at or above full scale. See the [example](#example).
    #[must_use]
    pub fn saturated(&self, counts: &[u16; C]) -> Channels {
        Channels::saturated(counts, self.full_scale.into())
    }
}

/// Computes count * weight / 2^16, rounded down, which is a product of 48 bits by two of 32. Neither of the
/// two overflows: |weight| < 2^30, so that the upper half is within 2^14, and 16 bits by 16 fit.
#[inline(always)]
fn times(count: u32, weight: i32) -> i32 {
    let upper = count as i32 * (weight >> 16);
    let lower = count * (weight as u32 & 0xffff);
    upper + (lower >> 16) as i32
}

/// Rounds to the nearest integer, in `const fn`.
const fn rounded(x: f64) -> i32 {
    if x < 0.0 { -((0.5 - x) as i32) } else { (x + 0.5) as i32 }
}

const fn ceiling(x: f64) -> u32 {
    let whole = x as u32;
    if (whole as f64) < x { whole.saturating_add(1) } else { whole }
}
