//! Raw counts, and the reasons why a reading may not be a measurement.

use crate::color::Xyz;

/// A raw count as a chip reports it, which is a `u16`, a `u32` or an `f32`.
///
/// Most chips report `u16`; those with wide converters (OPT4048, TCS3530) `u32`; those that calibrate
/// themselves (AS726x) `f32`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no raw count",
    note = "counts are u16, u32 or f32: say which at the first, as in `[18_000_u16; 8]`"
)]
pub trait Count: Copy + sealed::Sealed {
    /// Converts the count to f32, which keeps its upper 24 bits.
    fn to_f32(self) -> f32;
    /// Returns a number that is negative while the count is below the full scale (itself below 2^31).
    ///
    /// Signs are cheaper to collect over the channels than comparisons are: eight channels take 16
    /// instructions, where branches take 20 to 30.
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
        // NaN does not count as full, because it must come out as NaN.
        if self >= full_scale as f32 { 0 } else { -1 }
    }
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for u16 {}
    impl Sealed for u32 {}
    impl Sealed for f32 {}
}

/// A set of channels, counted from 0, which can hold the first 32.
///
/// [`Exposure::saturated`](crate::sensor::Exposure::saturated) and [`ReadingError::Saturated`] give one; the
/// first call is [`contains`](Self::contains) or [`count`](Self::count).
///
/// # Example
///
/// ```
/// use nanospectra::sensor::{Channels, Exposure};
///
/// let channels = Exposure::new(1.0, 1.0, 1000).saturated(&[20_u16, 1000, 30, 2000]);
/// assert!(channels.contains(1) && !channels.contains(2));
/// assert_eq!((channels.count(), channels.bits()), (2, 0b1010));
/// assert_eq!(channels, Channels::default().with(1).with(3));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Channels(u32);

impl Channels {
    /// Returns whether `channel` is in the set. See the [example](#example).
    #[must_use]
    pub const fn contains(self, channel: usize) -> bool {
        channel < 32 && self.0 >> channel & 1 == 1
    }

    /// Returns how many channels are in the set. See the [example](#example).
    #[must_use]
    pub const fn count(self) -> u32 {
        self.0.count_ones()
    }

    /// Returns the set as a number that has one bit for each channel, with channel 0 as the lowest bit. See
    /// the [example](#example).
    #[must_use]
    pub const fn bits(self) -> u32 {
        self.0
    }

    /// Adds `channel` to the set, where one beyond 31 counts as 31. See the [example](#example).
    #[must_use]
    pub const fn with(self, channel: usize) -> Self {
        Channels(self.0 | 1 << if channel < 31 { channel } else { 31 })
    }

    /// Collects those of `counts` that are at or above `full_scale`.
    pub(in crate::sensor) fn saturated<T: Count, const C: usize>(counts: &[T; C], full_scale: u32) -> Self {
        let mut channels = Channels::default();
        for (channel, count) in counts.iter().enumerate() {
            if count.headroom(full_scale) >= 0 {
                channels = channels.with(channel);
            }
        }
        channels
    }
}

/// Why a reading cannot be turned into a color.
///
/// [`Exposure::basic_counts`](crate::sensor::Exposure::basic_counts), [`Calibration::xyz`] and [`Meter::xyz`]
/// return it.
///
/// # Example
///
/// ```
/// use nanospectra::sensor::{Calibration, Exposure, Meter, ReadingError};
///
/// static TO_XYZ: Calibration<2> = Calibration::from_rows([[0.9, 0.1], [0.4, 0.6], [-0.2, 1.1]]);
/// let meter = Meter::new(&Exposure::new(1.0, 10.0, 1000), &TO_XYZ);
/// let less_gain = match meter.xyz(&[400_u16, 1000]) {
///     Ok(_) => false,
///     Err(ReadingError::Saturated { channels }) => channels.contains(1), // the second channel
///     Err(_) => false,
/// };
/// assert!(less_gain);
/// assert_eq!(meter.xyz(&[0_u16, 0]), Err(ReadingError::TooDark));
/// // Light that only the first channel sees would have a negative Z.
/// assert!(matches!(meter.xyz(&[900_u16, 0]), Err(ReadingError::Negative { xyz }) if xyz.z < 0.0));
/// ```
///
/// [`Calibration::xyz`]: crate::sensor::Calibration::xyz
/// [`Meter::xyz`]: crate::sensor::Meter::xyz
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum ReadingError {
    /// These channels have reached full scale, so measure again with less gain or time. See the
    /// [example](#example).
    Saturated {
        /// The channels that are at or above full scale.
        channels: Channels,
    },
    /// All channels together are not far enough above their dark levels, so measure again with more gain or
    /// time. See the [example](#example).
    TooDark,
    /// X, Y or Z is negative, although no light looks like this. See the [example](#example).
    ///
    /// Either the calibration was made for other lights, or the light is so nearly dark or so pure a red that
    /// noise decides. Y alone may still be good.
    Negative {
        /// The sums X, Y and Z that the calibration gives.
        xyz: Xyz,
    },
}

impl ReadingError {
    /// Names the reason of counts that are saturated or too dark. The function stays out of line, so that
    /// readings that are fine do not pay for it.
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
                write!(
                    f,
                    "channels have reached full scale (bits {:#b}): use less gain or time",
                    channels.bits()
                )
            }
            ReadingError::TooDark => {
                f.write_str("the channels are not above their dark levels: use more gain or time")
            }
            ReadingError::Negative { xyz } if xyz.to_array().iter().all(|sum| sum.is_finite()) => {
                write!(f, "the calibration gives a negative color: X {}, Y {}, Z {}", xyz.x, xyz.y, xyz.z)
            }
            ReadingError::Negative { .. } => f.write_str(
                "the calibration gives a negative color, and sums beyond 3.4e38: check its numbers",
            ),
        }
    }
}

impl core::error::Error for ReadingError {}
