//! The light flickermeter: how severe the flicker of a light is to the eye, as one number.

use crate::math::sqrt;
use crate::sensor::time::classes::Classes;
use crate::sensor::time::filter::{FirstOrder, HighPass, SecondOrder, tangent};
use core::f32::consts::SQRT_2;

/// The lowest and the highest rate in Hz at which readings may come.
const RATES_HZ: [f32; 2] = [400.0, 50_000.0];

/// Fewer readings than this in a second are all weighted for the eye; of more, at least as many are.
const WEIGHTED_HZ: f32 = 2000.0;

/// How many seconds the filters take to settle.
const SETTLING_S: f32 = 20.0;

/// The shortest run, in seconds, that has an answer.
const SHORTEST_S: f32 = 30.0;

/// The largest size of a reading. The square of what the filters make of it is still a number.
const LARGEST: f32 = 1e15;

/// The least mean that is light. What swings by 1e-6 of it still has a square.
const DARKEST: f32 = 1e-12;

/// The factor of equation A.6, by which a sine of 8.8 Hz that swings by 0.63 % of the mean from trough to
/// crest is an instantaneous flicker of 1.
const SCALE: f32 = 1.101_603_2e6;

/// Measures the short-term severity of flicker, Pst LM, as the light flickermeter of IEC TR 61547-1 does:
/// at 1, half of all people see the light flicker.
///
/// [`push`](Self::push) takes readings (lux, counts, a photocurrent) at equal steps and stores none of them;
/// [`pst_lm`](Self::pst_lm) gives the severity of all since the start. The measure is made for light that
/// swings with 0.3 to 80 Hz; what swings faster is told by
/// [`stroboscopic_visibility_with`](crate::sensor::stroboscopic_visibility_with). The European Union demands
/// at most 1 of lamps at full load. A measurement takes 180 s.
///
/// The mean of all readings is the reference, as in the Matlab function of Philips; a meter that divides by a
/// mean of the last seconds follows a light that is dimmed meanwhile, and differs from this one only there.
///
/// # Example
///
/// ```
/// use nanospectra::sensor::LightFlickermeter;
///
/// // A test point of the report: light that jumps by 0.6832 %, 17.6 times a second, is just visible.
/// let mut meter = LightFlickermeter::new(2000.0).unwrap();
/// for k in 0..2000 * 60 {
///     let period = (k as f32 * 8.8 / 2000.0).fract();
///     meter.push(300.0 * if period < 0.5 { 1.003_416 } else { 0.996_584 });
/// }
/// assert!((meter.pst_lm().unwrap() - 1.0).abs() < 0.01);
/// ```
///
/// # Accuracy
/// 1 % of the severity: for the worst lights of a search, beside the same filters in f64, and for the test
/// points of the report, beside the analog filters, whatever the rate. The percentiles come from classes that
/// are up to 3.1 % wide, by which no light is more than 1.6 % off.
///
/// # Cost
/// 1208 bytes of memory, however long the run is. At 20 kHz, where every tenth reading is weighted, a
/// reading takes 65 instructions on a Cortex-M4F and 4240 on a Cortex-M0. [`pst_lm`](Self::pst_lm) reads 512 classes 15 times.
///
/// # Reference
/// IEC TR 61547-1:2020, annex A; IEC 61000-4-15:2010 for the percentiles and, by its lamp and eye, for the
/// weighting; P. Beeckman, Light Flicker Assessment Toolbox (Matlab Central 63445), 2017.
#[derive(Clone, Debug)]
pub struct LightFlickermeter {
    high_pass: HighPass,
    low_pass: [SecondOrder; 3],
    /// Every how many readings one is weighted, and how many are left until then.
    every: u32,
    left: u32,
    /// The sum of the readings since the last one that was weighted.
    sum: f32,
    mean: Mean,
    eye: Eye,
    smooth: FirstOrder,
    /// How many weighted readings are left until the filters have settled, and until there is an answer.
    settling: u32,
    missing: u32,
    /// Whether a reading was not a number, or too large.
    unusable: bool,
    instantaneous: Classes,
}

impl LightFlickermeter {
    /// Makes a meter for readings that come `rate_hz` times a second. See the [example](#example).
    ///
    /// The result is `None` for a rate outside 400 to 50 000 Hz. Choose 2000 Hz or more, and a photodiode
    /// whose electronics cut off what is faster than half the rate: light that swings with nearly a multiple
    /// of the rate would seem to flicker slowly.
    #[must_use]
    pub const fn new(rate_hz: f32) -> Option<Self> {
        // Written so that NaN is refused too.
        if !(rate_hz >= RATES_HZ[0] && rate_hz <= RATES_HZ[1]) {
            return None;
        }
        let every = if rate_hz < WEIGHTED_HZ { 1 } else { (rate_hz / WEIGHTED_HZ) as u32 };
        let weighted_hz = rate_hz / every as f32;
        let corner = tangent(35.0, rate_hz);
        Some(LightFlickermeter {
            high_pass: HighPass::new(tangent(0.05, rate_hz)),
            // A Butterworth filter of the sixth order: 2 sin of 75, 45 and 15 degrees.
            low_pass: [
                SecondOrder::new(corner, 1.931_851_6),
                SecondOrder::new(corner, SQRT_2),
                SecondOrder::new(corner, 0.517_638_1),
            ],
            every,
            left: every,
            sum: 0.0,
            mean: Mean { sum: 0.0, excess: 0.0, count: 0 },
            eye: Eye::new(weighted_hz),
            smooth: FirstOrder::new(0.5 / (0.3 * weighted_hz)),
            settling: (SETTLING_S * weighted_hz) as u32,
            missing: (SHORTEST_S * weighted_hz) as u32,
            unusable: false,
            instantaneous: Classes::new(),
        })
    }

    /// Adds a reading, which comes one step after the last. See the [example](#example).
    ///
    /// Readings may be negative, as those of a dark light with noise are. After one that is not a number, or
    /// larger than 1e15, there is no answer.
    pub fn push(&mut self, reading: f32) {
        let is_usable = reading.abs() <= LARGEST;
        if !is_usable {
            self.unusable = true;
            return;
        }
        let mut seen = self.high_pass.step(reading);
        for section in &mut self.low_pass {
            [_, _, seen] = section.step(seen);
        }
        self.sum += reading;
        self.left -= 1;
        if self.left > 0 {
            return;
        }
        self.left = self.every;
        self.mean.add(self.sum / self.every as f32);
        self.sum = 0.0;
        let seen = self.eye.step(seen);
        let (_, smooth) = self.smooth.step(seen * seen);
        self.missing = self.missing.saturating_sub(1);
        if self.settling > 0 {
            self.settling -= 1;
        } else {
            // Rounding may bring what fades away below zero.
            self.instantaneous.count(smooth.max(0.0));
        }
    }

    /// Computes Pst LM of all readings so far, which is zero or more. See the [example](#example).
    ///
    /// The first 20 s do not count, because the filters settle. Steady light has 0; 100 % at 8.8 Hz has about
    /// 290.
    ///
    /// # Errors
    /// [`PstLmError`] after less than 30 s, without light (a mean below 1e-12), or after a reading that was not
    /// a number.
    pub fn pst_lm(&self) -> Result<f32, PstLmError> {
        if self.unusable {
            return Err(PstLmError::NotANumber);
        }
        if self.missing > 0 {
            return Err(PstLmError::TooShort);
        }
        let mean = self.mean.get();
        if mean < DARKEST {
            return Err(PstLmError::NoLight);
        }
        let smoothed = |percents: &[f32]| {
            let sum: f32 =
                percents.iter().map(|percent| self.instantaneous.exceeded_by(0.01 * percent)).sum();
            sum / percents.len() as f32
        };
        let severity = 0.0314 * smoothed(&[0.1])
            + 0.0525 * smoothed(&[0.7, 1.0, 1.5])
            + 0.0657 * smoothed(&[2.2, 3.0, 4.0])
            + 0.28 * smoothed(&[6.0, 8.0, 10.0, 13.0, 17.0])
            + 0.08 * smoothed(&[30.0, 50.0, 80.0]);
        Ok(sqrt(SCALE * severity) / mean)
    }
}

/// The mean of many numbers, whose sum does not lose the small ones (Kahan).
#[derive(Clone, Debug)]
struct Mean {
    sum: f32,
    excess: f32,
    count: u32,
}

impl Mean {
    fn add(&mut self, value: f32) {
        // After so many numbers one more does not matter.
        let Some(count) = self.count.checked_add(1) else { return };
        let value = value - self.excess;
        let sum = self.sum + value;
        *self = Mean { sum, excess: (sum - self.sum) - value, count };
    }

    fn get(&self) -> f32 {
        self.sum / self.count as f32
    }
}

/// The response of the eye and the brain, equation A.5, as a product:
///
/// 0.041661 s (s + 14.3) / (s^2 + 51.0 s + 57.5^2) * (s + 49.5) / (s + 7.70) * (s + 1010.5) / (s + 137.6).
#[derive(Clone, Debug)]
struct Eye {
    resonance: SecondOrder,
    slow: FirstOrder,
    fast: FirstOrder,
}

impl Eye {
    const GAIN: f32 = 0.041_661;
    const ZEROS: [f32; 3] = [14.325_108, 49.477_18, 1_010.535_8];
    const RESONANCE: f32 = 57.521_586;
    const DAMPING: f32 = 51.016_06;
    const POLES: [f32; 2] = [7.699_095, 137.604_85];

    const fn new(rate_hz: f32) -> Self {
        let half_step = 0.5 / rate_hz;
        Eye {
            resonance: SecondOrder::new(Eye::RESONANCE * half_step, Eye::DAMPING / Eye::RESONANCE),
            slow: FirstOrder::new(Eye::POLES[0] * half_step),
            fast: FirstOrder::new(Eye::POLES[1] * half_step),
        }
    }

    fn step(&mut self, input: f32) -> f32 {
        let [high, band, _] = self.resonance.step(Eye::GAIN * input);
        let (high, low) = self.slow.step(high + Eye::ZEROS[0] / Eye::RESONANCE * band);
        let (high, low) = self.fast.step(high + Eye::ZEROS[1] / Eye::POLES[0] * low);
        high + Eye::ZEROS[2] / Eye::POLES[1] * low
    }
}

/// Why [`LightFlickermeter::pst_lm`] has no answer.
///
/// # Example
///
/// ```
/// use nanospectra::sensor::{LightFlickermeter, PstLmError};
///
/// let mut meter = LightFlickermeter::new(1000.0).unwrap();
/// assert_eq!(meter.pst_lm(), Err(PstLmError::TooShort));
/// (0..30_000).for_each(|_| meter.push(0.0));
/// assert_eq!(meter.pst_lm(), Err(PstLmError::NoLight));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum PstLmError {
    /// The readings are from less than 30 s. See the [example](#example).
    TooShort,
    /// The mean of the readings is below 1e-12. See the [example](#example).
    NoLight,
    /// A reading was not a number, or it was larger than 1e15.
    NotANumber,
}

impl PstLmError {
    /// Returns the reason in words.
    #[must_use]
    pub const fn message(&self) -> &'static str {
        match self {
            PstLmError::TooShort => "needs readings of 30 s or more",
            PstLmError::NoLight => "there is no light",
            PstLmError::NotANumber => "a reading is not a number, or too large",
        }
    }
}

impl core::fmt::Display for PstLmError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(self.message())
    }
}

impl core::error::Error for PstLmError {}
