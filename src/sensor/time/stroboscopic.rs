//! The stroboscopic visibility measure: how clearly things that move are seen to jump under a light.

use crate::math::Math;
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::sensor::time::flicker::Periods;

/// The highest frequency in Hz that the measure counts.
const HIGHEST_HZ: f32 = 2000.0;

/// The exponent by which the parts of a light are summed.
const EXPONENT: f32 = 3.7;

/// Computes the stroboscopic visibility measure, SVM, of readings of a light that repeats `frequency_hz`
/// times a second: 1 is just visible to half of all viewers, 0 is steady light.
///
/// The readings (lux, counts) were taken at equal steps, `rate_hz` times a second. The parts of the light at
/// `frequency_hz` and its multiples count, up to 2000 Hz, and below half of `rate_hz`; so take at least 4000
/// readings a second, by a photodiode that is faster than that. The measure is made for light that swings
/// with 80 Hz or more, and for an office where people move; the European Union demands at most 0.4 of lamps.
/// Slower flicker is told by [`LightFlickermeter`](crate::sensor::LightFlickermeter).
///
/// The result is `None` as in [`Flicker::of`](crate::sensor::Flicker::of). NaN among the readings makes it
/// NaN.
///
/// # Accuracy
/// 4e-5 of the measure, for up to 1000 readings and up to 100 in each period, and 1 % for a second of up to
/// 50 000 readings; each period is a whole number of them (`tests/sensor/stroboscopic.rs`).
///
/// # Cost
/// One multiplication for each reading and each multiple of the frequency; nothing is stored. On a Cortex-M4F
/// 400 readings of a light of 100 Hz, 4000 times a second, take 219 thousand instructions.
///
/// # Reference
/// IEC TR 63158:2018; CIE TN 006:2016; Perz et al., Lighting Research and Technology 47 (2015).
///
/// # Example
/// ```
/// use nanospectra::sensor::stroboscopic_visibility;
/// // 100 Hz, read 4000 times a second for 0.1 s. A sine is just visible if it swings by a quarter of its mean.
/// let light = |swing: f32| {
///     core::array::from_fn::<f32, 400, _>(|k| 100.0 * (1.0 + swing * (k as f32 * core::f32::consts::TAU / 40.0).sin()))
/// };
/// let svm = |swing| stroboscopic_visibility(&light(swing), 4000.0, 100.0).unwrap();
/// assert!((svm(0.2563) - 1.0).abs() < 1e-3);
/// assert!((svm(0.1) - 0.39).abs() < 1e-3 && svm(0.0) < 1e-5);
/// ```
#[cfg(feature = "libm")]
#[must_use]
pub fn stroboscopic_visibility<'a, R>(readings: R, rate_hz: f32, frequency_hz: f32) -> Option<f32>
where
    R: IntoIterator<Item = &'a f32, IntoIter: Clone>,
{
    stroboscopic_visibility_with::<Portable, R>(readings, rate_hz, frequency_hz)
}

/// Computes the stroboscopic visibility measure by the elementary functions of the math backend `M`.
///
/// # Example
/// ```
/// use nanospectra::{math::Fast, sensor::stroboscopic_visibility_with};
/// // A light that is on for one reading of four, 1000 times a second.
/// let readings = [4.0, 0.0, 0.0, 0.0].repeat(25);
/// let svm = stroboscopic_visibility_with::<Fast, _>(&readings, 4000.0, 1000.0).unwrap();
/// assert!((svm - 2.055).abs() < 1e-3);
/// ```
#[must_use]
pub fn stroboscopic_visibility_with<'a, M: Math, R>(
    readings: R,
    rate_hz: f32,
    frequency_hz: f32,
) -> Option<f32>
where
    R: IntoIterator<Item = &'a f32, IntoIter: Clone>,
{
    let readings = readings.into_iter();
    let (periods, mean) = Periods::with_light(readings.clone(), rate_hz, frequency_hz)?;
    let (mut sum, mut hz) = (0.0, frequency_hz);
    while hz <= HIGHEST_HZ && hz < 0.5 * rate_hz {
        let swing = periods.amplitude(readings.clone(), mean, hz / rate_hz) / mean;
        sum += M::powf(swing / threshold::<M>(hz), EXPONENT);
        hz += frequency_hz;
    }
    Some(M::powf(sum, 1.0 / EXPONENT))
}

/// Returns how much a sine of this frequency has to swing, as a part of the mean, to be just visible.
fn threshold<M: Math>(hz: f32) -> f32 {
    1.0 / (1.0 + M::exp(-0.005_18 * (hz - 306.6))) + 20.0 * M::exp(-0.1 * hz)
}
