//! Raw counts, and the reasons why a reading may be no measurement.

use crate::color::Xyz;

/// A raw count: `u16` of most chips, `u32` of those with wide converters (OPT4048, TCS3530), `f32` of those
/// that calibrate themselves (AS726x).
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no raw count",
    note = "counts are u16, u32 or f32: say which at the first, as in `[18_000_u16; 8]`"
)]
pub trait Count: Copy + sealed::Sealed {
    /// The count as a number; above 2^24 to 24 bits.
    fn to_f32(self) -> f32;
    /// Negative while the count is below the full scale (itself below 2^31). Signs are cheaper to collect
    /// over the channels than comparisons: 16 instructions for eight channels where branches take 20 to 30.
    fn headroom(self, full_scale: u32) -> i32;
}

impl Count for u16 {
    #[inline]
    fn to_f32(self) -> f32 {
        self.into()
    }
    #[inline]
    fn headroom(self, full_scale: u32) -> i32 {
        i32::from(self) - full_scale as i32
    }
}

impl Count for u32 {
    #[inline]
    fn to_f32(self) -> f32 {
        self as f32
    }
    #[inline]
    fn headroom(self, full_scale: u32) -> i32 {
        if self >= full_scale { 0 } else { -1 }
    }
}

impl Count for f32 {
    #[inline]
    fn to_f32(self) -> f32 {
        self
    }
    #[inline]
    fn headroom(self, full_scale: u32) -> i32 {
        // NaN is not full: it must come out as NaN.
        if self >= full_scale as f32 { 0 } else { -1 }
    }
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for u16 {}
    impl Sealed for u32 {}
    impl Sealed for f32 {}
}

/// A set of channels, counted from 0, of the first 32.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Channels(u32);

impl Channels {
    /// With `channel` in it (one beyond 31 counts as 31).
    #[must_use]
    pub const fn with(self, channel: usize) -> Self {
        Channels(self.0 | 1 << if channel < 31 { channel } else { 31 })
    }

    /// Those of `counts` at or above `full_scale`.
    pub(in crate::sensor) fn saturated<T: Count, const C: usize>(counts: &[T; C], full_scale: u32) -> Self {
        let mut channels = Channels::default();
        for (channel, count) in counts.iter().enumerate() {
            if count.headroom(full_scale) >= 0 {
                channels = channels.with(channel);
            }
        }
        channels
    }

    /// Whether `channel` is in it.
    #[must_use]
    pub const fn contains(self, channel: usize) -> bool {
        channel < 32 && self.0 >> channel & 1 == 1
    }

    /// The number of channels in the set.
    #[must_use]
    pub const fn count(self) -> u32 {
        self.0.count_ones()
    }

    /// One bit for each channel, channel 0 the lowest.
    #[must_use]
    pub const fn bits(self) -> u32 {
        self.0
    }
}

/// Why a reading cannot be turned into a color.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum ReadingError {
    /// These channels have reached full scale: measure again with less gain or time.
    Saturated {
        /// The channels at or above full scale.
        channels: Channels,
    },
    /// All channels together are not far enough above their dark levels: measure again with more gain or
    /// time.
    TooDark,
    /// X, Y or Z is negative: no light looks like this. Either the calibration was made for other lights, or
    /// the light is so nearly dark or so pure a red that noise decides; Y alone may still be good.
    Negative {
        /// The sums as they are.
        xyz: Xyz,
    },
}

impl ReadingError {
    /// Of counts that are saturated or too dark. (Out of line: readings that are fine do not pay for it.)
    #[cold]
    #[inline(never)]
    pub(in crate::sensor) fn because<T: Count, const C: usize>(counts: &[T; C], full_scale: u32) -> Self {
        let channels = Channels::saturated(counts, full_scale);
        if channels.count() > 0 { ReadingError::Saturated { channels } } else { ReadingError::TooDark }
    }
}

impl core::fmt::Display for ReadingError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            ReadingError::Saturated { channels } => {
                write!(f, "channels at full scale (bits {:#b}): use less gain or time", channels.bits())
            }
            ReadingError::TooDark => {
                f.write_str("the channels are not above their dark levels: use more gain or time")
            }
            ReadingError::Negative { xyz } => {
                write!(f, "the calibration gives a negative color: X {}, Y {}, Z {}", xyz.x, xyz.y, xyz.z)
            }
        }
    }
}

impl core::error::Error for ReadingError {}
