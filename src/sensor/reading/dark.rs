//! The counts that a chip has in the dark.

use crate::math::Math;
use crate::sensor::Exposure;

/// Dark counts of each channel: an offset of the converter, and a dark current that grows with time, gain and
/// temperature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DarkCounts<const C: usize> {
    /// Counts that do not depend on the exposure.
    pub offset: [f32; C],
    /// Counts per millisecond at unit gain, at `measured_at_c`.
    pub rate: [f32; C],
    /// The temperature at which `rate` was measured, degrees Celsius.
    pub measured_at_c: f32,
    /// The dark current doubles every so many kelvin: 6 to 10 for silicon.
    pub doubles_every_k: f32,
}

impl<const C: usize> DarkCounts<C> {
    /// The counts that this exposure has in the dark, at the temperature of the measurement.
    #[must_use]
    pub fn levels(&self, exposure: &Exposure) -> [f32; C] {
        self.grown(exposure, 1.0)
    }

    /// The counts that this exposure has in the dark at another temperature; `M` provides the exponential.
    #[must_use]
    pub fn levels_at_with<M: Math>(&self, exposure: &Exposure, celsius: f32) -> [f32; C] {
        let doublings = (celsius - self.measured_at_c) / self.doubles_every_k;
        self.grown(exposure, M::exp(core::f32::consts::LN_2 * doublings))
    }

    fn grown(&self, exposure: &Exposure, growth: f32) -> [f32; C] {
        let per_rate = growth * exposure.gain() * exposure.time_ms();
        let mut levels = self.offset;
        for (level, rate) in levels.iter_mut().zip(&self.rate) {
            *level += rate * per_rate;
        }
        levels
    }
}
