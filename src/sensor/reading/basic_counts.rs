//! Counts divided by gain and time, so that readings with different exposures can be compared.

/// Counts per millisecond at unit gain ("basic counts" in the makers' notes), one for each channel; above
/// dark if a dark level was taken off.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub struct BasicCounts<const C: usize>([f32; C]);

impl<const C: usize> BasicCounts<C> {
    /// Takes numbers that are basic counts already, as of a log, a simulation or a chip that calibrates
    /// itself.
    #[must_use]
    pub const fn new(values: [f32; C]) -> Self {
        BasicCounts(values)
    }

    /// The basic counts of each channel.
    #[must_use]
    pub const fn values(&self) -> &[f32; C] {
        &self.0
    }

    /// The same counts with each channel multiplied by its factor. What is the same for every reading is
    /// better folded into the [`Calibration`](crate::sensor::Calibration).
    #[must_use]
    pub fn scaled(mut self, factors: &[f32; C]) -> Self {
        for (value, factor) in self.0.iter_mut().zip(factors) {
            *value *= factor;
        }
        self
    }

    /// The counts that the chip would have had at the temperature of its calibration.
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

/// The change of each channel's responsivity with temperature: linear, as data sheets give it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drift<const C: usize> {
    /// Relative change for each kelvin: 1e-3 is 0.1 %/K.
    pub per_k: [f32; C],
    /// The temperature of the calibration, degrees Celsius.
    pub calibrated_at_c: f32,
}
