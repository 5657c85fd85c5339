//! Groups readings in a row into runs, and computes how much the light flickers in each.

use crate::flicker::measures;
use crate::sensor::measure::Reading;
use nanospectra::sensor::Exposure;

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
    /// The short-term severity of the flicker, or why it is unknown.
    pub pst_lm: Result<f32, String>,
    pub flicker: Vec<At>,
}

/// The flicker at one frequency.
pub struct At {
    pub flicker: measures::At,
    /// Another frequency, if the run is too short to distinguish it from this one.
    pub confused_with_hz: Option<f32>,
    /// The share of the flicker that readings of this length still show.
    pub shown: f32,
}

/// Groups readings that come one after the other. It keeps a number for each reading of the present run.
pub struct Runs<'a> {
    frequencies_hz: &'a [f32],
    present: Option<Present>,
}

/// A run whose next reading may still come.
struct Present {
    label: Option<String>,
    lines: (usize, usize),
    readings: usize,
    exposure: Exposure,
    same_exposure: bool,
    /// The first and the last time, as long as all are in seconds.
    seconds: Option<(f64, f64)>,
    /// The shortest and the longest step of time.
    steps: (f64, f64),
    /// The brightness of each reading, until one is saturated.
    values: Option<Vec<f32>>,
}

impl<'a> Runs<'a> {
    pub fn new(frequencies_hz: &'a [f32]) -> Self {
        Runs { frequencies_hz, present: None }
    }

    /// Adds the next reading of the log. Returns the run before it, if it does not belong to that.
    pub fn push(&mut self, reading: &Reading) -> Option<Run> {
        // Without a column of times there are no runs.
        let (_, seconds) = reading.entry.time.as_ref()?;
        match &mut self.present {
            Some(present) if present.label == reading.entry.label => {
                present.push(reading, *seconds);
                None
            }
            _ => {
                let ended = self.end();
                self.present = Some(Present::new(reading, *seconds));
                ended
            }
        }
    }

    /// Ends the present run, and returns it if it has two or more readings.
    pub fn end(&mut self) -> Option<Run> {
        let present = self.present.take().filter(|present| present.readings > 1)?;
        let rate_hz = present.rate();
        let flicker = match (&rate_hz, present.values()) {
            (Ok(rate), Ok(values)) => {
                let of = |hz: &f32| at(values, *rate, *hz, self.frequencies_hz, present.exposure);
                self.frequencies_hz.iter().map(of).collect()
            }
            _ => Vec::new(),
        };
        let rate_hz = rate_hz.and_then(|rate| present.values().map(|_| rate));
        let pst_lm = rate_hz.clone().and_then(|rate| measures::pst_lm(present.values()?, rate));
        let Present { label, lines, readings, .. } = present;
        Some(Run { label, lines, readings, rate_hz, pst_lm, flicker })
    }
}

impl Present {
    fn new(reading: &Reading, seconds: Option<f64>) -> Self {
        Present {
            label: reading.entry.label.clone(),
            lines: (reading.entry.line, reading.entry.line),
            readings: 1,
            exposure: reading.exposure,
            same_exposure: true,
            seconds: seconds.map(|seconds| (seconds, seconds)),
            steps: (f64::INFINITY, f64::NEG_INFINITY),
            values: reading.brightness.map(|value| vec![value]),
        }
    }

    fn push(&mut self, reading: &Reading, seconds: Option<f64>) {
        self.readings += 1;
        self.lines.1 = reading.entry.line;
        self.same_exposure &= reading.exposure == self.exposure;
        if let (Some((_, before)), Some(now)) = (self.seconds, seconds) {
            self.steps = (self.steps.0.min(now - before), self.steps.1.max(now - before));
        }
        self.seconds = self.seconds.zip(seconds).map(|((first, _), now)| (first, now));
        self.values = self.values.take().zip(reading.brightness).map(|(mut values, value)| {
            values.push(value);
            values
        });
    }

    /// Returns the readings per second, if they come at equal steps.
    fn rate(&self) -> Result<f32, String> {
        let (first, last) = self.seconds.ok_or("time is not in seconds")?;
        let step = (last - first) / (self.readings - 1) as f64;
        // If the shortest and the longest step are near the mean, all are.
        let steady = [self.steps.0, self.steps.1].iter().all(|own| (own - step).abs() <= STEADY * step);
        if !(step > 0.0 && steady) {
            return Err("the steps of time are not equal".into());
        }
        let rate_hz = (1.0 / step) as f32;
        if rate_hz.is_normal() {
            Ok(rate_hz)
        } else {
            Err("the steps of time are too short or too long".into())
        }
    }

    fn values(&self) -> Result<&[f32], String> {
        if !self.same_exposure {
            return Err("the exposure changes within the run".into());
        }
        self.values.as_deref().ok_or_else(|| "a reading is saturated".into())
    }
}

fn at(values: &[f32], rate_hz: f32, frequency_hz: f32, others_hz: &[f32], exposure: Exposure) -> At {
    let seconds = values.len() as f32 / rate_hz;
    let near = |other: &&f32| **other != frequency_hz && (**other - frequency_hz).abs() * seconds < 1.0;
    At {
        flicker: measures::at(values, rate_hz, frequency_hz),
        confused_with_hz: others_hz.iter().find(near).copied(),
        shown: exposure.residual_modulation(frequency_hz),
    }
}
