//! The counts that a chip reports in the dark.

use crate::math::Math;
use crate::sensor::Exposure;

/// The counts that each channel reports in the dark, which are an offset of the converter and a dark current
/// that grows with time, gain and temperature.
///
/// [`levels`](Self::levels) computes them for an exposure, and [`Exposure::basic_counts_above`] subtracts
/// them from a reading.
///
/// # Example
///
/// ```
/// use nanospectra::math::Fast;
/// use nanospectra::sensor::{DarkCounts, Exposure};
///
/// let dark = DarkCounts { offset: [2.0], rate: [0.01], measured_at_c: 25.0, doubles_every_k: 8.0 };
/// let exposure = Exposure::new(16.0, 50.0, 65_535);
/// let [level] = dark.levels(&exposure);
/// assert!((level - 10.0).abs() < 1e-5); // 2 + 0.01 * 16 * 50
/// let [warm] = dark.levels_at_with::<Fast>(&exposure, 33.0);
/// assert!((warm - 18.0).abs() < 1e-4); // 8 K more: the current has doubled, the offset has not
/// let basic = exposure.basic_counts_above(&[level], &[810_u16])?;
/// assert!((basic.values()[0] - 1.0).abs() < 1e-5); // (810 - 10) / (16 * 50)
/// # Ok::<(), nanospectra::sensor::ReadingError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DarkCounts<const C: usize> {
    /// The counts of each channel that do not depend on the exposure.
    pub offset: [f32; C],
    /// The dark current of each channel in counts per millisecond at unit gain, as it was at `measured_at_c`.
    pub rate: [f32; C],
    /// The temperature at which `rate` was measured, in degrees Celsius.
    pub measured_at_c: f32,
    /// How many kelvin it takes to double the dark current, which is 6 to 10 for silicon.
    pub doubles_every_k: f32,
}

impl<const C: usize> DarkCounts<C> {
    /// Computes the counts that this exposure has in the dark, at the temperature of the measurement. See the
    /// [example](#example).
    #[must_use]
    pub fn levels(&self, exposure: &Exposure) -> [f32; C] {
        self.grown(exposure, 1.0)
    }

    /// Computes the counts that this exposure has in the dark at another temperature. See the
    /// [example](#example).
    ///
    /// `celsius` is that temperature in degrees Celsius. `M` provides the exponential.
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
