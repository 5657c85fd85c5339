//! The noise of counts.

use crate::math::sqrt;
use crate::sensor::{BasicCounts, Count, Exposure};

/// The noise of a chip's counts. Neither number is in most data sheets: repeat a reading of a steady lamp,
/// and one in the dark, and fit the variances.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Noise {
    /// Electrons that make one count at unit gain, above zero: the shot noise. Infinite for none.
    pub electrons_per_count: f32,
    /// What the converter adds to each count, rms, in counts, whatever the exposure; without the rounding to
    /// whole counts, which is known (1/12 of a count squared).
    pub read_counts: f32,
}

impl Noise {
    /// The variances of one reading: shot noise, read noise and the rounding to whole counts.
    ///
    /// At gain g a count n came from n / g * `electrons_per_count` electrons and so has the shot variance n g
    /// / `electrons_per_count`. The counts are raw ones, with their dark level in them: it is noisy too.
    /// Below zero there is no shot noise; NaN stays NaN.
    ///
    /// ```
    /// # use nanospectra::sensor::{Exposure, Noise};
    /// let noise = Noise { electrons_per_count: 100.0, read_counts: 2.0 };
    /// let [of_one_count] = noise.variances(&Exposure::new(1.0, 1.0, 65_535), &[10_000_u16]).to_array();
    /// assert!((of_one_count - (100.0 + 4.0 + 1.0 / 12.0)).abs() < 1e-4);
    /// ```
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

/// The variance of each channel of [`BasicCounts`]; channels are independent of each other.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub struct Variances<const C: usize>([f32; C]);

impl<const C: usize> Variances<C> {
    /// Takes variances of basic counts, of repeated readings for example.
    #[must_use]
    pub const fn new(variances: [f32; C]) -> Self {
        Variances(variances)
    }

    /// The variance of each channel, in (counts per ms at unit gain) squared.
    #[must_use]
    pub const fn to_array(self) -> [f32; C] {
        self.0
    }

    /// Adds the variances of another, independent cause of noise, such as the dark frame that was taken off.
    #[must_use]
    pub fn plus(mut self, other: &Variances<C>) -> Self {
        for (variance, more) in self.0.iter_mut().zip(&other.0) {
            *variance += more;
        }
        self
    }

    /// The variances of the mean of `readings` such readings, 1 or more.
    #[must_use]
    pub fn of_mean(mut self, readings: u16) -> Self {
        for variance in &mut self.0 {
            *variance /= f32::from(readings.max(1));
        }
        self
    }

    /// The standard uncertainty of each channel (k = 1): the square roots.
    #[must_use]
    pub fn uncertainty(&self) -> BasicCounts<C> {
        BasicCounts::new(self.0.map(root))
    }
}

/// Rounding may leave a variance of nothing a little below zero.
pub(in crate::sensor) fn root(variance: f32) -> f32 {
    if variance < 0.0 { 0.0 } else { sqrt(variance) }
}

#[cfg(feature = "defmt")]
impl<const C: usize> defmt::Format for Variances<C> {
    fn format(&self, fmt: defmt::Formatter<'_>) {
        defmt::write!(fmt, "Variances({})", self.0.as_slice());
    }
}
