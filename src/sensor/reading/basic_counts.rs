//! Counts divided by gain and time, so that readings with different exposures can be compared.

/// Counts per millisecond at unit gain, one for each channel, so that readings with different exposures can
/// be compared.
///
/// The makers' application notes call them "basic counts". They come from
/// [`Exposure::basic_counts`](crate::sensor::Exposure::basic_counts), or, with the dark level subtracted,
/// from [`Exposure::basic_counts_above`](crate::sensor::Exposure::basic_counts_above); a
/// [`Calibration`](crate::sensor::Calibration) turns them into XYZ.
///
/// # Example
///
/// ```
/// use nanospectra::sensor::{BasicCounts, Drift};
///
/// let basic = BasicCounts::new([10.0, 20.0]);
/// assert_eq!(basic.scaled(&[1.0, 0.5]).values(), &[10.0, 10.0]);
///
/// // The first channel gains 0.1 % for each kelvin, and the chip is 20 K warmer than when it was calibrated.
/// let drift = Drift { per_k: [1e-3, 0.0], calibrated_at_c: 25.0 };
/// let [first, second] = *basic.without(&drift, 45.0).values();
/// assert!((first - 10.0 / 1.02).abs() < 1e-5 && second == 20.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub struct BasicCounts<const C: usize>([f32; C]);

impl<const C: usize> BasicCounts<C> {
    /// Wraps numbers that are basic counts already, as those of a log, of a simulation or of a chip that
    /// calibrates itself. See the [example](#example).
    #[must_use]
    pub const fn new(values: [f32; C]) -> Self {
        BasicCounts(values)
    }

    /// Returns the basic counts of each channel. See the [example](#example).
    #[must_use]
    pub const fn values(&self) -> &[f32; C] {
        &self.0
    }

    /// Multiplies each channel by its factor. See the [example](#example).
    ///
    /// A factor that is the same for every reading is better folded into the
    /// [`Calibration`](crate::sensor::Calibration), where it costs nothing.
    #[must_use]
    pub fn scaled(mut self, factors: &[f32; C]) -> Self {
        for (value, factor) in self.0.iter_mut().zip(factors) {
            *value *= factor;
        }
        self
    }

    /// Computes the counts that the chip would have had at the temperature of its calibration. See the
    /// [example](#example).
    ///
    /// `celsius` is the temperature of the chip while it measured, in degrees Celsius.
    #[must_use]
    pub fn without(mut self, drift: &Drift<C>, celsius: f32) -> Self {
        let warmer = celsius - drift.calibrated_at_c;
        for (value, per_k) in self.0.iter_mut().zip(&drift.per_k) {
            *value /= 1.0 + per_k * warmer;
        }
        self
    }
}

#[cfg(feature = "defmt")]
impl<const C: usize> defmt::Format for BasicCounts<C> {
    fn format(&self, fmt: defmt::Formatter<'_>) {
        defmt::write!(fmt, "BasicCounts({})", self.0.as_slice());
    }
}

/// The change of each channel's responsivity with temperature, which data sheets give as linear.
///
/// [`BasicCounts::without`] removes it from a reading. See the [example](BasicCounts#example) there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drift<const C: usize> {
    /// The relative change of each channel for each kelvin, where 1e-3 is 0.1 %/K.
    pub per_k: [f32; C],
    /// The temperature at which the chip was calibrated, in degrees Celsius.
    pub calibrated_at_c: f32,
}
