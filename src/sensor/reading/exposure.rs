//! Exposures: gain, integration time, and the count from which a channel is saturated.

use crate::sensor::{BasicCounts, Channels, Count, ReadingError};

/// Gain, integration time and the range of trustworthy counts that goes with them: from the registers of a
/// chip by its module in [`chip`](crate::sensor::chip), or of any other by [`new`](Self::new).
///
/// ```
/// # use nanospectra::sensor::{ReadingError, chip::as7341};
/// // The trap of the AS7341: its converter ends at (ATIME + 1) * (ASTEP + 1), here 18 000 and not 65 535.
/// let exposure = as7341::exposure(16.0, 29, 599);
/// assert_eq!(exposure.full_scale(), 18_000);
/// let counts: [u16; 2] = [1200, 18_000];
/// assert!(matches!(exposure.basic_counts(&counts), Err(ReadingError::Saturated { channels }) if channels.contains(1)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Exposure {
    gain: f32,
    time_ms: f32,
    /// 1 / (gain * time)
    per_count: f32,
    full_scale: u32,
    floor: f32,
}

impl Exposure {
    /// An exposure of any chip: its gain, its integration time in ms, and the first count that cannot be
    /// trusted any more (below 2^31).
    ///
    /// Gain and time are above zero; with others, or a product that overflows, every reading is NaN.
    ///
    /// A reading is too dark when all channels together count less than 1 above their dark levels; see
    /// [`with_floor`](Self::with_floor).
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

    /// The same exposure with another floor: all channels together must count at least `floor` above their
    /// dark levels, or the reading is too dark.
    #[must_use]
    pub const fn with_floor(self, floor: f32) -> Self {
        Exposure { floor, ..self }
    }

    /// The gain, as a factor.
    #[must_use]
    pub const fn gain(&self) -> f32 {
        self.gain
    }

    /// The integration time, in ms.
    #[must_use]
    pub const fn time_ms(&self) -> f32 {
        self.time_ms
    }

    /// The first count that is not trusted.
    #[must_use]
    pub const fn full_scale(&self) -> u32 {
        self.full_scale
    }

    /// The least that all channels together must count above their dark levels.
    #[must_use]
    pub const fn floor(&self) -> f32 {
        self.floor
    }

    /// The basic counts that one count stands for: 1 / (gain * time), per ms.
    #[must_use]
    pub const fn per_count(&self) -> f32 {
        self.per_count
    }

    /// Converts raw counts to counts per millisecond at unit gain.
    ///
    /// # Errors
    /// `Saturated` with the channels at full scale, `TooDark` if they do not reach the floor together. A NaN
    /// count stays NaN.
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

    /// Converts raw counts above the dark level of each channel, in counts of this exposure: a frame taken in
    /// the dark, or [`DarkCounts::levels`](crate::sensor::DarkCounts::levels).
    ///
    /// A channel below its dark level becomes negative and stays so: cutting it off would brighten dark
    /// averages.
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

    /// The channels at or above full scale.
    #[must_use]
    pub fn saturated<T: Count, const C: usize>(&self, counts: &[T; C]) -> Channels {
        Channels::saturated(counts, self.full_scale)
    }
}
