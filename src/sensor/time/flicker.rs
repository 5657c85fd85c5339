//! Flicker: how much a light flickers, and which times average it out.
//!
//! A sum over readings takes them at equal steps and each as the mean of its step, as a chip that integrates
//! all the time has them. It runs over a whole number of periods of the flicker, counted from the first
//! reading; the last reading counts in part if that is where the last period ends.

use crate::math::{cos_turns, sin_turns, sqrt};
use crate::sensor::Exposure;

/// The frequencies of lamps on mains of 50 and of 60 Hz: twice those of the mains.
pub const MAINS_FLICKER_HZ: [f32; 2] = [100.0, 120.0];

/// The shortest integration time, in ms, of whole periods of both: 5 of 100 Hz, 6 of 120 Hz.
pub const MAINS_PERIODS_MS: f32 = 50.0;

/// So many periods are missing at most, as a share, where a whole number of them was meant: rates are not
/// round.
const SLACK: f32 = 1e-5;

/// The flicker of a light: its mean, percent flicker and flicker index.
///
/// # Reference
/// CIE International Lighting Vocabulary (amplitude of fluctuation, flicker index; IEC 60050-845,
/// 845-22-094); ANSI/IES LS-1, 5.9.9.4.
///
/// ```
/// # use nanospectra::sensor::Flicker;
/// // Pulse width modulation with a duty of 25 %, at 250 Hz, read 1000 times a second.
/// let readings = [4.0, 0.0, 0.0, 0.0, 4.0, 0.0, 0.0, 0.0];
/// let Some(flicker) = Flicker::of(&readings, 1000.0, 250.0) else { return };
/// assert_eq!((flicker.mean, flicker.percent, flicker.index), (1.0, 100.0, 0.75)); // index 1 - duty
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Flicker {
    /// The mean over whole periods.
    pub mean: f32,
    /// Percent flicker, 0..=100: (max - min) / (max + min) of the readings of these periods.
    pub percent: f32,
    /// Flicker index, 0..=1 for readings that are not negative: what lies above the mean, as a share of all.
    pub index: f32,
}

impl Flicker {
    /// The flicker of readings (lux, counts) taken `rate_hz` times a second of a light that repeats
    /// `frequency_hz` times.
    ///
    /// NaN among them makes all three numbers NaN (infinity the last two). `None` where there is no answer:
    /// less than one period, fewer than two readings in each, no light (a sum not above zero), a rate or
    /// frequency not above zero.
    ///
    /// Each reading averages the light while it integrates: of a sine there is
    /// [`Exposure::residual_modulation`] left.
    #[must_use]
    pub fn of<'a, R>(readings: R, rate_hz: f32, frequency_hz: f32) -> Option<Self>
    where
        R: IntoIterator<Item = &'a f32, IntoIter: Clone>,
    {
        let readings = readings.into_iter();
        let periods = Periods::of(readings.clone(), rate_hz, frequency_hz)?;
        if periods.per_period < 2.0 {
            return None;
        }
        let mean = periods.mean(readings.clone());
        if mean <= 0.0 {
            return None;
        }
        if !mean.is_finite() {
            return Some(Flicker { mean, percent: f32::NAN, index: f32::NAN });
        }
        let (mut low, mut high, mut above) = (f32::INFINITY, 0.0_f32, 0.0);
        for (value, weight) in periods.weighted(readings) {
            low = low.min(value);
            high = high.max(value);
            above += weight * (value - mean).max(0.0);
        }
        // Noise around a dark level may be below zero; light is not.
        let low = low.max(0.0);
        let percent = 100.0 * (high - low) / (high + low);
        Some(Flicker { mean, percent, index: above / (mean * periods.length) })
    }
}

/// The mean of readings taken `rate_hz` times a second, over as many whole periods of `frequency_hz` as they
/// hold: what a light that flickers has on average, whichever its phase.
///
/// `None` for less than one period, or a rate or frequency not above zero. NaN stays NaN.
///
/// # Accuracy
/// A wave that repeats is averaged to what its phase makes of the last, partial reading; nothing is left
/// where a period is a whole number of readings.
#[must_use]
pub fn mean_over_periods<'a, R>(readings: R, rate_hz: f32, frequency_hz: f32) -> Option<f32>
where
    R: IntoIterator<Item = &'a f32, IntoIter: Clone>,
{
    let readings = readings.into_iter();
    Some(Periods::of(readings.clone(), rate_hz, frequency_hz)?.mean(readings))
}

/// The amplitude (half of crest to trough) of the part of readings that swings with `frequency_hz`, by
/// Goertzel's recurrence over whole periods; in the readings' unit.
///
/// `None` for less than one period, fewer than two readings in each, or a rate or frequency not above zero.
/// NaN stays NaN.
///
/// # Accuracy
/// 4e-5 of the amplitude for up to 1000 readings with a period of 100 or fewer, each period a whole number of
/// them (swept in `tests/sensor/measures.rs`). At exactly two readings in a period it depends on the phase.
///
/// # Cost
/// One multiplication for each reading.
///
/// # Reference
/// Goertzel, Am. Math. Monthly 65 (1958).
#[must_use]
pub fn amplitude_at<'a, R>(readings: R, rate_hz: f32, frequency_hz: f32) -> Option<f32>
where
    R: IntoIterator<Item = &'a f32, IntoIter: Clone>,
{
    let readings = readings.into_iter();
    let periods = Periods::of(readings.clone(), rate_hz, frequency_hz)?;
    if periods.per_period < 2.0 {
        return None;
    }
    // Without the mean, which a part of a reading would leak into every frequency.
    let mean = periods.mean(readings.clone());
    let turn = 2.0 * cos_turns(frequency_hz / rate_hz);
    let (mut last, mut before) = (0.0, 0.0);
    for (value, weight) in periods.weighted(readings) {
        (last, before) = (weight * (value - mean) + turn * last - before, last);
    }
    let squares = last * last + before * before - turn * last * before;
    let size = if squares < 0.0 { 0.0 } else { sqrt(squares) };
    Some(2.0 * size / periods.length)
}

impl Exposure {
    /// The share of a flicker of `frequency_hz` that a reading still shows: |sinc|, 1 for a time much shorter
    /// than a period, 0 for whole periods.
    ///
    /// # Accuracy
    /// 2e-7.
    ///
    /// ```
    /// # use nanospectra::sensor::Exposure;
    /// let five_ms = Exposure::new(1.0, 5.0, 65_535);
    /// assert!((five_ms.residual_modulation(100.0) - 0.6366).abs() < 1e-4); // 2 / pi: half a period
    /// ```
    #[must_use]
    pub fn residual_modulation(&self, frequency_hz: f32) -> f32 {
        let half_turns = frequency_hz * self.time_ms() * 1e-3;
        if half_turns == 0.0 {
            return 1.0;
        }
        (sin_turns(0.5 * half_turns) / (core::f32::consts::PI * half_turns)).abs()
    }

    /// Whether a reading averages a flicker of `frequency_hz`: not more than 0.5 % of it is left.
    ///
    /// ```
    /// # use nanospectra::sensor::{MAINS_FLICKER_HZ, chip::as7341};
    /// let exposure = as7341::exposure(16.0, 29, 599); // 50.04 ms
    /// assert!(MAINS_FLICKER_HZ.iter().all(|hz| exposure.averages(*hz)));
    /// assert!(!as7341::exposure(16.0, 29, 499).averages(100.0)); // 41.7 ms
    /// ```
    #[must_use]
    pub fn averages(&self, frequency_hz: f32) -> bool {
        self.residual_modulation(frequency_hz) <= 5e-3
    }
}

/// The longest time of whole periods of `frequency_hz` that is no longer than `at_most_ms` (to rounding), in
/// ms; `None` if not even one fits.
#[must_use]
pub const fn whole_periods_ms(frequency_hz: f32, at_most_ms: f32) -> Option<f32> {
    let periods = whole(at_most_ms * frequency_hz / 1000.0);
    if periods >= 1.0 && frequency_hz > 0.0 { Some(periods * 1000.0 / frequency_hz) } else { None }
}

/// The whole number of periods in `periods`, with slack.
const fn whole(periods: f32) -> f32 {
    (periods * (1.0 + SLACK)) as u32 as f32
}

/// The readings that whole periods take up.
struct Periods {
    per_period: f32,
    /// Of all periods, in readings.
    length: f32,
}

impl Periods {
    fn of<'a>(readings: impl Iterator<Item = &'a f32>, rate_hz: f32, frequency_hz: f32) -> Option<Self> {
        let per_period = rate_hz / frequency_hz;
        if !(rate_hz > 0.0 && frequency_hz > 0.0 && per_period > 0.0 && per_period.is_finite()) {
            return None;
        }
        let readings = readings.count() as f32;
        let periods = whole(readings / per_period);
        let length = (periods * per_period).min(readings);
        (periods >= 1.0 && length > 0.0).then_some(Periods { per_period, length })
    }

    /// The readings with their weights: 1, and at last what is left.
    fn weighted<'a>(&self, readings: impl Iterator<Item = &'a f32>) -> impl Iterator<Item = (f32, f32)> {
        let length = self.length;
        readings
            .enumerate()
            .map(move |(k, value)| (*value, (length - k as f32).min(1.0)))
            .take_while(|(_, weight)| *weight > 0.0)
    }

    fn mean<'a>(&self, readings: impl Iterator<Item = &'a f32>) -> f32 {
        self.weighted(readings).map(|(value, weight)| value * weight).sum::<f32>() / self.length
    }
}
