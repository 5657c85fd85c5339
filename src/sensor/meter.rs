//! A light meter: raw counts to color in one pass over the channels.

use crate::color::Xyz;
use crate::math::const_for;
use crate::sensor::calibrate::positive;
use crate::sensor::{Calibration, Count, Exposure, ReadingError};

/// A light meter that turns raw counts into XYZ in one pass over the channels.
///
/// Exposure, dark level and calibration are one matrix, so that each count is only converted, checked and
/// multiplied. [`new`](Self::new) makes the meter, in a `static` too, and [`xyz`](Self::xyz) reads it. It
/// suits an instrument whose exposure stays (or take one `Meter` for each of a few exposures). The same
/// numbers, to rounding, come step by step from [`Exposure::basic_counts`] and [`Calibration::xyz`].
///
/// # Example
///
/// ```
/// # use nanospectra::sensor::{Calibration, Exposure, Meter, ReadingError};
/// static TO_XYZ: Calibration<2> = Calibration::from_rows([[0.9, 0.1], [0.4, 0.6], [0.0, 1.1]]);
/// static METER: Meter<2> = Meter::new_above(&Exposure::new(4.0, 25.0, 65_535), &[3.0, 5.0], &TO_XYZ);
/// let xyz = METER.xyz(&[1003_u16, 2005])?;
/// assert!((xyz.y - (0.4 * 10.0 + 0.6 * 20.0)).abs() < 1e-4); // 10 and 20 counts per ms at unit gain
/// assert_eq!(METER.xyz(&[3_u16, 5]), Err(ReadingError::TooDark));
/// # Ok::<(), ReadingError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meter<const C: usize> {
    /// What a count of each channel adds to X, Y and Z.
    columns: [[f32; 3]; C],
    /// What the sums start from: the dark levels, subtracted.
    start: [f32; 3],
    full_scale: u32,
    floor: f32,
}

impl<const C: usize> Meter<C> {
    /// Makes a meter for readings with this exposure, in a `static` too. See the [example](#example).
    #[must_use]
    pub const fn new(exposure: &Exposure, calibration: &Calibration<C>) -> Self {
        let mut columns = [[0.0; 3]; C];
        const_for!(0..C, |c| {
            const_for!(0..3, |d| columns[c][d] = calibration.rows()[d][c] * exposure.per_count());
        });
        Meter { columns, start: [0.0; 3], full_scale: exposure.full_scale(), floor: exposure.floor() }
    }

    /// Computes the tristimulus values of one reading. See the [example](#example).
    ///
    /// # Errors
    /// `Saturated` with the channels at full scale; `TooDark`; `Negative`, with the sums, if one of them is
    /// below zero. A NaN count stays NaN.
    ///
    /// # Cost
    /// Eight channels: 123 instructions on a Cortex-M4F.
    #[inline]
    pub fn xyz<T: Count>(&self, counts: &[T; C]) -> Result<Xyz, ReadingError> {
        let ([mut x, mut y, mut z], mut total, mut headroom) = (self.start, 0.0, -1);
        for (count, [to_x, to_y, to_z]) in counts.iter().zip(&self.columns) {
            let value = count.to_f32();
            headroom &= count.headroom(self.full_scale);
            total += value;
            x += to_x * value;
            y += to_y * value;
            z += to_z * value;
        }
        if headroom >= 0 || total < self.floor {
            return Err(ReadingError::because(counts, self.full_scale));
        }
        positive(Xyz { x, y, z })
    }

    /// Makes a meter that first subtracts these dark levels, in counts of the exposure, from each channel.
    /// See the [example](#example).
    #[must_use]
    pub const fn new_above(
        exposure: &Exposure,
        dark_levels: &[f32; C],
        calibration: &Calibration<C>,
    ) -> Self {
        let mut meter = Self::new(exposure, calibration);
        const_for!(0..C, |c| {
            meter.floor += dark_levels[c];
            const_for!(0..3, |d| meter.start[d] -= meter.columns[c][d] * dark_levels[c]);
        });
        meter
    }

    /// Multiplies every result by `k`.
    ///
    /// To have Y in lux, show a light to the sensor and to a reference lux meter, and pass what the lux meter
    /// reads divided by the Y that this meter gives.
    ///
    /// ```
    /// # use nanospectra::sensor::{Calibration, Exposure, Meter, ReadingError};
    /// # static TO_XYZ: Calibration<2> = Calibration::from_rows([[0.9, 0.1], [0.4, 0.6], [0.0, 1.1]]);
    /// let meter = Meter::new(&Exposure::new(4.0, 25.0, 65_535), &TO_XYZ);
    /// let counts = [1000_u16, 2000]; // under 500 lx
    /// let meter = meter.scaled(500.0 / meter.xyz(&counts)?.y);
    /// assert!((meter.xyz(&counts)?.y - 500.0).abs() < 1e-3);
    /// # Ok::<(), ReadingError>(())
    /// ```
    #[must_use]
    pub const fn scaled(mut self, k: f32) -> Self {
        const_for!(0..3, |d| {
            self.start[d] *= k;
            const_for!(0..C, |c| self.columns[c][d] *= k);
        });
        self
    }
}
