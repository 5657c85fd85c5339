//! How much the counts of a chip scatter.

use crate::math::sqrt;
use crate::sensor::{BasicCounts, Count, Exposure};

/// The noise of a chip's counts, which is shot noise and what the converter adds.
///
/// [`variances`](Self::variances) computes from it how much a reading scatters. Neither number is in most
/// data sheets: repeat a reading of a steady lamp and one in the dark, and fit the variances.
///
/// # Example
///
/// ```
/// use nanospectra::sensor::{Exposure, Noise};
///
/// // 10 000 counts at unit gain are a million electrons: a variance of 100 counts squared. The converter
/// // adds the square of 2 counts, and the rounding to whole counts 1/12.
/// let noise = Noise { electrons_per_count: 100.0, read_counts: 2.0 };
/// let variances = noise.variances(&Exposure::new(1.0, 1.0, 65_535), &[10_000_u16]);
/// let [variance] = variances.to_array();
/// assert!((variance - (100.0 + 4.0 + 1.0 / 12.0)).abs() < 1e-4);
/// // The mean of 16 readings scatters a quarter as much.
/// let (one, mean) = (variances.uncertainty(), variances.of_mean(16).uncertainty());
/// assert!((one.values()[0] / mean.values()[0] - 4.0).abs() < 1e-5);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Noise {
    /// How many electrons make one count at unit gain, a number above zero that sets the shot noise. Infinity
    /// stands for no shot noise.
    pub electrons_per_count: f32,
    /// The noise that the converter adds to each count whatever the exposure, as a root mean square in
    /// counts. The rounding to whole counts, a variance of 1/12, is not part of it.
    pub read_counts: f32,
}

impl Noise {
    /// Computes the variance of each channel of one reading, from shot noise, read noise and the rounding to
    /// whole counts. See the [example](#example).
    ///
    /// At gain g a count n came from n / g * `electrons_per_count` electrons, so that its shot variance is n
    /// g / `electrons_per_count`. The counts are raw ones, with their dark level in them, because that is
    /// noisy too. Below zero there is no shot noise; NaN stays NaN.
    #[must_use]
    pub fn variances<T: Count, const C: usize>(&self, exposure: &Exposure, counts: &[T; C]) -> Variances<C> {
        let shot = exposure.gain() / self.electrons_per_count;
        let rest = self.read_counts * self.read_counts + 1.0 / 12.0;
        let mut variances = [0.0; C];
        for (variance, count) in variances.iter_mut().zip(counts) {
            let count = count.to_f32();
            let above_zero = if count < 0.0 { 0.0 } else { count };
            *variance = (above_zero * shot + rest) * exposure.per_count() * exposure.per_count();
        }
        Variances(variances)
    }
}

/// The variance of each channel of [`BasicCounts`], where channels are independent of each other.
///
/// [`Noise::variances`] computes it; [`Calibration::uncertainty`](crate::sensor::Calibration::uncertainty)
/// and [`Calibration::covariance`](crate::sensor::Calibration::covariance) carry it on to the results.
///
/// # Example
///
/// ```
/// use nanospectra::sensor::{BasicCounts, Variances};
///
/// // Of a reading and of the dark frame that was subtracted from it.
/// let both = Variances::new([4.0, 9.0]).plus(&Variances::new([5.0, 16.0]));
/// assert_eq!(both.uncertainty(), BasicCounts::new([3.0, 5.0]));
/// assert_eq!(both.of_mean(9).to_array(), [1.0, 25.0 / 9.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub struct Variances<const C: usize>([f32; C]);

impl<const C: usize> Variances<C> {
    /// Wraps variances of basic counts, as those of repeated readings. See the [example](#example).
    #[must_use]
    pub const fn new(variances: [f32; C]) -> Self {
        Variances(variances)
    }

    /// Returns the variance of each channel, in (counts per ms at unit gain) squared. See the
    /// [example](#example).
    #[must_use]
    pub const fn to_array(self) -> [f32; C] {
        self.0
    }

    /// Adds the variances of another, independent cause of noise, such as the dark frame that was subtracted.
    /// See the [example](#example).
    #[must_use]
    pub fn plus(mut self, other: &Variances<C>) -> Self {
        for (variance, more) in self.0.iter_mut().zip(&other.0) {
            *variance += more;
        }
        self
    }

    /// Computes the variances of the mean of `readings` such readings, 1 or more. See the
    /// [example](#example).
    #[must_use]
    pub fn of_mean(mut self, readings: u16) -> Self {
        for variance in &mut self.0 {
            *variance /= f32::from(readings.max(1));
        }
        self
    }

    /// Computes the standard uncertainty (k = 1) of each channel, which is the square root of its variance.
    /// See the [example](#example).
    #[must_use]
    pub fn uncertainty(&self) -> BasicCounts<C> {
        BasicCounts::new(self.0.map(root))
    }
}

/// The square root, or 0 where rounding has left a variance a little below zero.
pub(in crate::sensor) fn root(variance: f32) -> f32 {
    if variance < 0.0 { 0.0 } else { sqrt(variance) }
}

#[cfg(feature = "defmt")]
impl<const C: usize> defmt::Format for Variances<C> {
    fn format(&self, fmt: defmt::Formatter<'_>) {
        defmt::write!(fmt, "Variances({})", self.0.as_slice());
    }
}
