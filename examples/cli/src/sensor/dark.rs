//! Finds the dark counts that are subtracted from a reading.

use crate::failure::Failure;
use crate::sensor::args::Args;
use crate::sensor::log::{self, Entry, Log};
use nanospectra::sensor::Exposure;
use std::collections::HashMap;
use std::collections::hash_map::Entry::{Occupied, Vacant};

/// The dark levels that are known from the log itself or from a file.
pub struct Frames {
    file: String,
    /// The means of all dark readings of each exposure, or of all exposures (`None`).
    frames: HashMap<Option<[u32; 3]>, Frame>,
}

/// The sums of dark readings.
struct Frame {
    readings: u16,
    sums: Vec<f64>,
}

/// The dark level of each channel, in counts, and the number of readings that it is the mean of.
pub struct Level {
    pub counts: Vec<f32>,
    pub readings: u16,
}

impl Frames {
    pub fn read(args: &Args, log: &Log) -> Result<Self, Failure> {
        let mut frames = HashMap::new();
        let Some(path) = &args.dark else {
            let frames = Frames { file: log.file().to_owned(), frames };
            frames.check(log)?;
            return Ok(frames);
        };
        if log.has_dark() {
            return Err(Failure::of(
                "--dark",
                "the log has dark_ columns too; leave out the option or the columns",
            ));
        }
        let dark = log::read_dark(path, args.sensor, &log.channels)?;
        for entry in dark.entries()? {
            let entry = entry?;
            match frames.entry(entry.exposure.map(key)) {
                Occupied(mut same) => {
                    let frame: &mut Frame = same.get_mut();
                    frame.readings = frame.readings.saturating_add(1);
                    frame.sums.iter_mut().zip(&entry.counts).for_each(|(sum, count)| *sum += count);
                }
                Vacant(new) => {
                    new.insert(Frame { readings: 1, sums: entry.counts });
                }
            }
        }
        let frames = Frames { file: dark.file().to_owned(), frames };
        frames.check(log)?;
        Ok(frames)
    }

    /// Returns a failure if a reading of the log has no dark level, or none that leaves room for light.
    fn check(&self, log: &Log) -> Result<(), Failure> {
        if self.frames.is_empty() && !log.has_dark() {
            return Ok(());
        }
        log.entries()?.try_for_each(|entry| self.of(&entry?).map(|_| ()))
    }

    /// Returns the dark level of an entry, if one is known.
    pub fn of(&self, entry: &Entry) -> Result<Option<Level>, Failure> {
        if let Some(counts) = &entry.dark {
            return level(&self.file, entry, counts.iter().copied(), 1);
        }
        if self.frames.is_empty() {
            return Ok(None);
        }
        let frame = self.frames.get(&None).or_else(|| self.frames.get(&entry.exposure.map(key)));
        let Some(frame) = frame else {
            let what = format!("no dark reading has the exposure of line {} of the log", entry.line);
            return Err(Failure::of(&self.file, what + "; add one, measured with the shutter closed"));
        };
        level(&self.file, entry, frame.sums.iter().map(|sum| sum / f64::from(frame.readings)), frame.readings)
    }
}

/// Returns what is equal for equal exposures, all of whose numbers are above zero.
fn key(exposure: Exposure) -> [u32; 3] {
    [exposure.gain().to_bits(), exposure.time_ms().to_bits(), exposure.full_scale()]
}

/// Returns the level, or a failure if it leaves no room for light.
fn level(
    file: &str,
    entry: &Entry,
    counts: impl Iterator<Item = f64>,
    readings: u16,
) -> Result<Option<Level>, Failure> {
    let counts: Vec<f32> = counts.map(|count| count as f32).collect();
    let full_scale = entry.exposure.map_or(f32::INFINITY, |exposure| exposure.full_scale() as f32);
    if let Some(k) = counts.iter().position(|count| *count >= full_scale) {
        let (channel, count, line) = (k + 1, counts[k], entry.line);
        let what =
            format!("channel {channel} counts {count} in the dark, which is the full scale of line {line}");
        return Err(Failure::of(file, what + " of the log; measure the dark again"));
    }
    Ok(Some(Level { counts, readings }))
}
