//! Flicker: how much a light flickers, and which times average it out.
//!
//! A sum over readings takes them at equal steps, each as the mean of its step, which is how a chip that
//! integrates all the time reads them. The sum runs over a whole number of periods of the flicker, counted
//! from the first reading. If the last period ends within a reading, that reading counts in part.

use crate::math::{cos_turns, sin_turns, sqrt};
use crate::sensor::Exposure;

/// The frequencies in Hz at which lamps on mains of 50 and of 60 Hz flicker, which are twice those of the
/// mains.
pub const MAINS_FLICKER_HZ: [f32; 2] = [100.0, 120.0];

/// The shortest integration time, in ms, that holds whole periods of both mains: 5 periods of 100 Hz, 6 of
/// 120 Hz.
///
/// ```
/// # use nanospectra::sensor::{MAINS_FLICKER_HZ, MAINS_PERIODS_MS};
/// let periods = MAINS_FLICKER_HZ.map(|hz| hz * MAINS_PERIODS_MS / 1000.0);
/// assert_eq!(periods, [5.0, 6.0]);
/// ```
pub const MAINS_PERIODS_MS: f32 = 50.0;

/// The share of a period that may be missing where a whole number of periods was meant, because rates are not
/// round numbers.
const SLACK: f32 = 1e-5;

/// How much a light flickers, which is told by its mean, its percent flicker and its flicker index.
///
/// [`Flicker::of`] computes them from readings at equal steps.
///
/// # Example
///
/// ```
/// use nanospectra::sensor::Flicker;
///
/// // Pulse width modulation with a duty of 25 %, at 250 Hz, read 1000 times a second.
/// let readings = [4.0, 0.0, 0.0, 0.0, 4.0, 0.0, 0.0, 0.0];
/// let Some(flicker) = Flicker::of(&readings, 1000.0, 250.0) else { return };
/// assert_eq!((flicker.mean, flicker.percent, flicker.index), (1.0, 100.0, 0.75)); // index 1 - duty
/// ```
///
/// # Reference
/// CIE International Lighting Vocabulary (amplitude of fluctuation, flicker index; IEC 60050-845,
/// 845-22-094); ANSI/IES LS-1, 5.9.9.4.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Flicker {
    /// The mean of the readings, which is taken over whole periods. See the [example](#example).
    pub mean: f32,
    /// Percent flicker, 0..=100, which is 100 (max - min) / (max + min) of the readings of these periods. See
    /// the [example](#example).
    pub percent: f32,
    /// Flicker index, the share of all light that lies above the mean. See the [example](#example).
    ///
    /// It is within 0..=1 for readings that are not negative.
    pub index: f32,
}

impl Flicker {
    /// Computes the flicker of readings (lux, counts) that were taken `rate_hz` times a second of a light
    /// that repeats `frequency_hz` times a second. See the [example](#example).
    ///
    /// `None` where there is no answer: less than one period, fewer than two readings in each, no light (a
    /// sum that is not above zero), a rate or frequency that is not above zero. NaN among the readings makes
    /// all three numbers NaN, and infinity the last two.
    ///
    /// Each reading averages the light while it integrates. How much of a sine is left after that is told by
    /// [`Exposure::residual_modulation`].
    #[must_use]
    pub fn of<'a, R>(readings: R, rate_hz: f32, frequency_hz: f32) -> Option<Self>
    where
        R: IntoIterator<Item = &'a f32, IntoIter: Clone>,
    {
        let readings = readings.into_iter();
        let (periods, mean) = Periods::with_light(readings.clone(), rate_hz, frequency_hz)?;
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

/// Computes the mean of readings over as many whole periods of a flicker as they hold, so that it does not
/// depend on the phase at which they begin.
///
/// The readings were taken `rate_hz` times a second, and the light repeats `frequency_hz` times a second.
/// `None` for less than one period, or a rate or frequency that is not above zero. NaN stays NaN.
///
/// ```
/// # use nanospectra::sensor::mean_over_periods;
/// // Six readings of a light with a period of four: the last two are left out.
/// let readings = [0.0, 10.0, 20.0, 10.0, 0.0, 10.0];
/// assert_eq!(mean_over_periods(&readings, 400.0, 100.0), Some(10.0));
/// ```
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

/// Computes the amplitude (half of crest to trough) of the part of readings that swings with `frequency_hz`.
///
/// It is in the unit of the readings, which were taken `rate_hz` times a second, and comes from Goertzel's
/// recurrence over whole periods. `None` for less than one period, fewer than two readings in each, or a rate
/// or frequency that is not above zero. NaN stays NaN.
///
/// ```
/// # use nanospectra::sensor::amplitude_at;
/// // 100 lx that swing by 20 lx at 100 Hz, read 400 times a second.
/// let readings = [100.0, 120.0, 100.0, 80.0, 100.0, 120.0, 100.0, 80.0];
/// let Some(amplitude) = amplitude_at(&readings, 400.0, 100.0) else { return };
/// assert!((amplitude - 20.0).abs() < 1e-3);
/// ```
///
/// # Accuracy
/// 7e-5 of the amplitude for up to 1000 readings with a period of 100 or fewer, each period a whole number of
/// them, and a mean of up to ten amplitudes (searched in `tests/sensor/worst_readings.rs`). At exactly two
/// readings in a period it depends on the phase.
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
    let mean = periods.mean(readings.clone());
    Some(periods.amplitude(readings, mean, frequency_hz / rate_hz))
}

impl Exposure {
    /// Computes the share of a flicker of `frequency_hz` that a reading still shows: 1 for a time much
    /// shorter than a period, 0 for whole periods.
    ///
    /// It is the magnitude of sinc, sin(x) / x with x = pi times frequency times integration time.
    ///
    /// # Accuracy
    /// 3e-7.
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

    /// Returns whether a reading averages out a flicker of `frequency_hz`: not more than 0.5 % of it is left.
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

/// Computes the longest time in ms that holds whole periods of `frequency_hz` and is no longer than
/// `at_most_ms` (to rounding).
///
/// The result is `None` if not even one period fits.
///
/// ```
/// # use nanospectra::sensor::whole_periods_ms;
/// assert_eq!(whole_periods_ms(120.0, 60.0), Some(7.0 * 1000.0 / 120.0)); // 58.3 ms
/// assert_eq!(whole_periods_ms(100.0, 9.0), None);
/// ```
#[must_use]
pub const fn whole_periods_ms(frequency_hz: f32, at_most_ms: f32) -> Option<f32> {
    let periods = whole(at_most_ms * frequency_hz / 1000.0);
    if periods >= 1.0 && frequency_hz > 0.0 { Some(periods * 1000.0 / frequency_hz) } else { None }
}

/// The whole number of periods in `periods`, with slack.
const fn whole(periods: f32) -> f32 {
    (periods * (1.0 + SLACK)) as u32 as f32
}

/// How many readings whole periods take up.
pub(in crate::sensor::time) struct Periods {
    per_period: f32,
    /// The length of all periods together, in readings.
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

    /// The periods of a light of two or more readings in each, and its mean, which is above zero or NaN.
    pub(in crate::sensor::time) fn with_light<'a>(
        readings: impl Iterator<Item = &'a f32> + Clone,
        rate_hz: f32,
        frequency_hz: f32,
    ) -> Option<(Self, f32)> {
        let periods = Periods::of(readings.clone(), rate_hz, frequency_hz)?;
        let mean = periods.mean(readings);
        if periods.per_period < 2.0 || mean <= 0.0 { None } else { Some((periods, mean)) }
    }

    /// The readings with their weights, which are 1 but for the last one.
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

    /// The amplitude of the part that swings by `turns` in each reading, by Goertzel's recurrence.
    pub(in crate::sensor::time) fn amplitude<'a>(
        &self,
        readings: impl Iterator<Item = &'a f32>,
        mean: f32,
        turns: f32,
    ) -> f32 {
        // The mean is subtracted, because a part of a reading would spread it over every frequency.
        let turn = 2.0 * cos_turns(turns);
        let (mut last, mut before) = (0.0, 0.0);
        for (value, weight) in self.weighted(readings) {
            (last, before) = (weight * (value - mean) + turn * last - before, last);
        }
        let squares = last * last + before * before - turn * last * before;
        let size = if squares < 0.0 { 0.0 } else { sqrt(squares) };
        2.0 * size / self.length
    }
}
