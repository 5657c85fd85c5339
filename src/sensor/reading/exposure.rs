//! Exposures: gain, integration time, and the count from which a channel is saturated.

use crate::sensor::{BasicCounts, Channels, Count, ReadingError};

/// The gain and the integration time of a reading, and the range of counts that can be trusted with them.
///
/// Take it from the registers of a chip by its module in [`chip`](crate::sensor::chip), or make it for any
/// other chip with [`new`](Self::new). The first call is [`basic_counts`](Self::basic_counts), which turns
/// raw counts into counts per millisecond at unit gain and refuses readings that are saturated or too dark.
///
/// # Example
///
/// ```
/// use nanospectra::sensor::{ReadingError, chip::as7341};
///
/// // The converter of an AS7341 ends at (ATIME + 1) * (ASTEP + 1) counts: here at 18 000, not at 65 535.
/// let exposure = as7341::exposure(16.0, 29, 599); // gain 16, 30 * 600 steps of 2.78 us
/// assert_eq!((exposure.gain(), exposure.full_scale()), (16.0, 18_000));
///
/// // 1200 counts are 1200 / (16 * 50.04 ms) = 1.4988 per millisecond at unit gain.
/// let basic = exposure.basic_counts(&[1200_u16, 600])?;
/// assert!((basic.values()[0] - 1.4988).abs() < 1e-4);
///
/// // A channel at full scale makes the reading an error that names the channel; so does darkness.
/// let saturated = exposure.basic_counts(&[1200_u16, 18_000]);
/// assert!(matches!(saturated, Err(ReadingError::Saturated { channels }) if channels.contains(1)));
/// assert_eq!(exposure.basic_counts(&[0_u16, 0]), Err(ReadingError::TooDark));
/// # Ok::<(), ReadingError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Exposure {
    gain: f32,
    time_ms: f32,
    /// 1 / (gain * time), in basic counts per count.
    per_count: f32,
    full_scale: u32,
    floor: f32,
}

impl Exposure {
    /// Makes the exposure of any chip from its gain, its integration time in ms, and the first count that
    /// cannot be trusted any more (below 2^31).
    ///
    /// Gain and time must be above zero, and their product must not overflow. If not, every reading is NaN.
    ///
    /// A reading is too dark when all channels together count less than 1 above their dark levels; see
    /// [`with_floor`](Self::with_floor) for another limit.
    ///
    /// ```
    /// # use nanospectra::sensor::Exposure;
    /// let exposure = Exposure::new(4.0, 25.0, 65_535); // gain 4, 25 ms, a converter of 16 bits
    /// let basic = exposure.basic_counts(&[1000_u16])?;
    /// assert!((basic.values()[0] - 10.0).abs() < 1e-5); // 1000 / (4 * 25)
    /// # Ok::<(), nanospectra::sensor::ReadingError>(())
    /// ```
    #[must_use]
    pub const fn new(gain: f32, time_ms: f32, full_scale: u32) -> Self {
        let product = gain * time_ms;
        let usable = product > 0.0 && product < f32::INFINITY && 1.0 / product < f32::INFINITY;
        Exposure {
            gain,
            time_ms,
            per_count: if usable { 1.0 / product } else { f32::NAN },
            full_scale: if full_scale < 0x7fff_ffff { full_scale } else { 0x7fff_ffff },
            floor: 1.0,
        }
    }

    /// Converts raw counts to counts per millisecond at unit gain. See the [example](#example).
    ///
    /// # Errors
    /// `Saturated` with the channels at full scale; `TooDark` if all channels together do not reach the
    /// floor. A NaN count stays NaN.
    #[inline(always)]
    pub fn basic_counts<T: Count, const C: usize>(
        &self,
        counts: &[T; C],
    ) -> Result<BasicCounts<C>, ReadingError> {
        let (mut total, mut headroom) = (0.0, -1);
        for count in counts {
            headroom &= count.headroom(self.full_scale);
            total += count.to_f32();
        }
        if headroom >= 0 || total < self.floor {
            return Err(ReadingError::because(counts, self.full_scale));
        }
        Ok(BasicCounts::new(counts.map(|count| count.to_f32() * self.per_count)))
    }

    /// Converts raw counts to counts per millisecond at unit gain, after the dark level of each channel is
    /// subtracted.
    ///
    /// The levels are counts of this exposure: a frame that was taken in the dark, or
    /// [`DarkCounts::levels`](crate::sensor::DarkCounts::levels). A channel below its dark level becomes
    /// negative and stays so, because clipping it to zero would brighten the average of dark readings.
    ///
    /// ```
    /// # use nanospectra::sensor::Exposure;
    /// let exposure = Exposure::new(4.0, 25.0, 65_535);
    /// let basic = exposure.basic_counts_above(&[3.0, 5.0], &[1003_u16, 2005])?;
    /// assert!((basic.values()[1] - 20.0).abs() < 1e-5); // (2005 - 5) / (4 * 25)
    /// # Ok::<(), nanospectra::sensor::ReadingError>(())
    /// ```
    ///
    /// # Errors
    /// As [`basic_counts`](Self::basic_counts).
    #[inline(always)]
    pub fn basic_counts_above<T: Count, const C: usize>(
        &self,
        dark_levels: &[f32; C],
        counts: &[T; C],
    ) -> Result<BasicCounts<C>, ReadingError> {
        let (mut total, mut headroom) = (0.0, -1);
        let mut basic = [0.0; C];
        for ((out, count), level) in basic.iter_mut().zip(counts).zip(dark_levels) {
            let value = count.to_f32() - level;
            headroom &= count.headroom(self.full_scale);
            total += value;
            *out = value * self.per_count;
        }
        if headroom >= 0 || total < self.floor {
            return Err(ReadingError::because(counts, self.full_scale));
        }
        Ok(BasicCounts::new(basic))
    }

    /// Returns the set of channels that are at or above full scale.
    ///
    /// ```
    /// # use nanospectra::sensor::Exposure;
    /// let exposure = Exposure::new(4.0, 25.0, 65_535);
    /// assert_eq!(exposure.saturated(&[1000_u16, 65_535, 65_535]).count(), 2);
    /// ```
    #[must_use]
    pub fn saturated<T: Count, const C: usize>(&self, counts: &[T; C]) -> Channels {
        Channels::saturated(counts, self.full_scale)
    }

    /// Replaces the floor: all channels together must count at least `floor` above their dark levels, or the
    /// reading is too dark.
    ///
    /// The floor of a new exposure is 1 count.
    ///
    /// ```
    /// # use nanospectra::sensor::{Exposure, ReadingError};
    /// let exposure = Exposure::new(4.0, 25.0, 65_535).with_floor(100.0);
    /// assert_eq!(exposure.basic_counts(&[40_u16, 50]), Err(ReadingError::TooDark));
    /// assert!(exposure.basic_counts(&[40_u16, 60]).is_ok());
    /// ```
    #[must_use]
    pub const fn with_floor(self, floor: f32) -> Self {
        Exposure { floor, ..self }
    }

    /// Returns the gain as a factor. See the [example](#example).
    #[must_use]
    pub const fn gain(&self) -> f32 {
        self.gain
    }

    /// Returns the integration time in milliseconds.
    #[must_use]
    pub const fn time_ms(&self) -> f32 {
        self.time_ms
    }

    /// Returns the first count that is not trusted any more. See the [example](#example).
    #[must_use]
    pub const fn full_scale(&self) -> u32 {
        self.full_scale
    }

    /// Returns the least that all channels together must count above their dark levels.
    #[must_use]
    pub const fn floor(&self) -> f32 {
        self.floor
    }

    /// Returns the basic counts that one raw count stands for, 1 / (gain * time), in counts per millisecond.
    #[must_use]
    pub const fn per_count(&self) -> f32 {
        self.per_count
    }
}
