//! Groups readings in a row into runs, and computes how much the light flickers in each.

use crate::output::number::shortest;
use crate::sensor::measure::Reading;
use nanospectra::sensor::{Exposure, Flicker, amplitude_at};

/// The share by which steps of time may differ.
const STEADY: f64 = 0.02;

/// Two or more readings in a row with the same label, at known times.
///
/// All readings of a log without labels are one run.
pub struct Run {
    pub label: Option<String>,
    pub lines: (usize, usize),
    pub readings: usize,
    /// The readings per second, or why that is unknown.
    pub rate_hz: Result<f32, String>,
    pub flicker: Vec<At>,
}

/// The flicker at one frequency.
pub struct At {
    pub frequency_hz: f32,
    /// The flicker and its amplitude at this frequency over the mean, or why they are unknown.
    pub found: Result<(Flicker, f32), String>,
    /// Another frequency, if the run is too short to distinguish it from this one.
    pub confused_with_hz: Option<f32>,
    /// The share of the flicker that readings of this length still show.
    pub shown: f32,
}

pub fn of(readings: &[Reading], frequencies_hz: &[f32]) -> Vec<Run> {
    let timed = readings.iter().all(|reading| reading.entry.time.is_some());
    let runs = readings.chunk_by(|a, b| a.entry.label == b.entry.label).filter(|run| timed && run.len() > 1);
    runs.map(|run| {
        let rate_hz = rate(run);
        let flicker = match (&rate_hz, values(run)) {
            (Ok(rate), Ok(values)) => frequencies_hz
                .iter()
                .map(|hz| at(&values, *rate, *hz, frequencies_hz, run[0].exposure))
                .collect(),
            _ => Vec::new(),
        };
        let rate_hz = rate_hz.and_then(|rate| values(run).map(|_| rate));
        let lines = (run[0].entry.line, run[run.len() - 1].entry.line);
        Run { label: run[0].entry.label.clone(), lines, readings: run.len(), rate_hz, flicker }
    })
    .collect()
}

/// Returns the readings per second, if they come at equal steps.
fn rate(run: &[Reading]) -> Result<f32, String> {
    let seconds = |reading: &Reading| reading.entry.time.as_ref().and_then(|(_, seconds)| *seconds);
    let times: Option<Vec<f64>> = run.iter().map(seconds).collect();
    let times = times.ok_or("time is not in seconds")?;
    let step = (times[times.len() - 1] - times[0]) / (times.len() - 1) as f64;
    let steady = times.windows(2).all(|pair| (pair[1] - pair[0] - step).abs() <= STEADY * step);
    if !(step > 0.0 && steady) {
        return Err("the steps of time are not equal".into());
    }
    let rate_hz = (1.0 / step) as f32;
    if rate_hz.is_normal() { Ok(rate_hz) } else { Err("the steps of time are too short or too long".into()) }
}

fn values(run: &[Reading]) -> Result<Vec<f32>, String> {
    if run.iter().any(|reading| reading.exposure != run[0].exposure) {
        return Err("the exposure changes within the run".into());
    }
    let values: Option<Vec<f32>> = run.iter().map(|reading| reading.brightness).collect();
    values.ok_or_else(|| "a reading is saturated".into())
}

fn at(values: &[f32], rate_hz: f32, frequency_hz: f32, others_hz: &[f32], exposure: Exposure) -> At {
    let seconds = values.len() as f32 / rate_hz;
    let near = |other: &&f32| **other != frequency_hz && (**other - frequency_hz).abs() * seconds < 1.0;
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
    At {
        frequency_hz,
        found,
        confused_with_hz: others_hz.iter().find(near).copied(),
        shown: exposure.residual_modulation(frequency_hz),
    }
}
