//! Computes what is said of flicker, or why it is unknown.

use crate::output::number::shortest;
use nanospectra::sensor::{Flicker, LightFlickermeter, amplitude_at, stroboscopic_visibility};

/// How many readings in a second tell all that the stroboscopic visibility measure counts.
const SVM_HZ: f32 = 4000.0;

/// The flicker at one frequency.
pub struct At {
    pub frequency_hz: f32,
    /// The flicker and its amplitude at this frequency over the mean, or why they are unknown.
    pub found: Result<(Flicker, f32), String>,
    /// The stroboscopic visibility measure, or why it is unknown.
    pub svm: Result<f32, String>,
}

/// Measures the flicker of readings at one frequency.
pub fn at(values: &[f32], rate_hz: f32, frequency_hz: f32) -> At {
    let found = if rate_hz < 2.0 * frequency_hz {
        Err(format!("needs {} or more readings a second", shortest(2.0 * frequency_hz)))
    } else {
        match (Flicker::of(values, rate_hz, frequency_hz), amplitude_at(values, rate_hz, frequency_hz)) {
            (Some(flicker), Some(amplitude)) => {
                let amplitude = amplitude / flicker.mean;
                let numbers = [flicker.mean, flicker.percent, flicker.index, amplitude];
                let is_finite = numbers.iter().all(|number| number.is_finite());
                is_finite.then_some((flicker, amplitude)).ok_or("the numbers are too large".into())
            }
            _ => Err("needs a whole period, and light".into()),
        }
    };
    let svm = found.as_ref().map_err(String::clone).and_then(|_| svm(values, rate_hz, frequency_hz));
    At { frequency_hz, found, svm }
}

/// Returns the readings of the first second. A longer run tells no more of one frequency, which no lamp and
/// no clock keeps for long.
pub fn first_second(values: &[f32], rate_hz: f32) -> &[f32] {
    &values[..values.len().min(rate_hz.ceil() as usize)]
}

fn svm(values: &[f32], rate_hz: f32, frequency_hz: f32) -> Result<f32, String> {
    if rate_hz < SVM_HZ {
        return Err(format!("needs {} or more readings a second", shortest(SVM_HZ)));
    }
    match stroboscopic_visibility(first_second(values, rate_hz), rate_hz, frequency_hz) {
        Some(svm) if svm.is_finite() => Ok(svm),
        Some(_) => Err("the numbers are too large".into()),
        None => Err("needs a whole period in the first second".into()),
    }
}

/// Measures how severe the flicker of readings is to the eye.
pub fn pst_lm(values: &[f32], rate_hz: f32) -> Result<f32, String> {
    let mut meter = LightFlickermeter::new(rate_hz).ok_or("needs 400 to 50000 readings a second")?;
    values.iter().for_each(|value| meter.push(*value));
    meter.pst_lm().map_err(|why| why.message().into())
}

/// Returns the notes on measures that are missing, where that is not why all of the flicker is.
pub fn unknown<'a>(pst_lm: &Result<f32, String>, flicker: impl IntoIterator<Item = &'a At>) -> Vec<String> {
    let mut notes: Vec<String> =
        pst_lm.as_ref().err().map(|why| format!("pst_lm: {why}")).into_iter().collect();
    let svm = flicker.into_iter().filter(|at| at.found.is_ok()).find_map(|at| at.svm.as_ref().err());
    notes.extend(svm.map(|why| format!("flicker.svm: {why}")));
    notes
}
