//! The command `sensor`, which computes color, illuminance and flicker from a log of a color sensor's counts.
//!
//! Each row of a file is split into [`cells`], which are read as an entry of a [`log`]. An [`instrument`]
//! [`measure`]s it, and the reading is reported as [`text`] or as [`json`] before the next row is read.
//! Without a log, the command reads one that was [`simulate`]d.

mod advice;
mod args;
mod calibration;
mod cells;
mod chip;
mod dark;
mod instrument;
mod json;
mod log;
mod measure;
mod responsivity;
mod runs;
pub mod simulate;
mod text;

pub use args::Args;

use crate::failure::Failure;
use crate::output::terminal;
use dark::Frames;
use instrument::{Instrument, Setup};
use log::{Entry, Log};
use measure::Reading;
use runs::Runs;

/// What is needed to report on the readings of a log, of which only one is in memory at a time.
pub struct Report<'a> {
    pub setup: &'a Setup,
    /// Lines that say how the colors were computed from responsivities or a calibration.
    pub colors: Vec<String>,
    pub frequencies_hz: &'a [f32],
    log: &'a Log,
    measure: Box<dyn Fn(Entry) -> Result<Reading, Failure> + 'a>,
}

impl<'a> Report<'a> {
    /// Measures the readings of the log from the first one. One iterator is in use at a time.
    pub fn readings(&self) -> Result<impl Iterator<Item = Result<Reading, Failure>>, Failure> {
        Ok(self.log.entries()?.map(|entry| (self.measure)(entry?)))
    }

    /// Returns an empty collection of runs.
    pub fn runs(&self) -> Runs<'a> {
        Runs::new(self.frequencies_hz)
    }

    /// Returns the note on columns that are not used, which belongs to every reading.
    pub fn unused(&self) -> Option<(&'static str, String)> {
        let unused = self.log.unused.as_ref()?;
        Some(("log", format!("these columns are not used: {unused}")))
    }
}

/// Reports on the log, or on the bundled one if none is named.
///
/// All of the log is checked before the first line is printed, so that no error leaves half a report. For
/// this the log is read several times.
pub fn run(args: &Args) -> Result<(), Failure> {
    args.check()?;
    if args.simulate {
        return terminal::print(&simulate::log());
    }
    let log = log::read(args)?;
    let setup = Setup::new(args, &log.channels)?;
    let report = report(args, &setup, &log)?;
    if args.json { json::print(&report) } else { text::print(&report) }
}

/// Makes the report. The number of channels is part of a type, and so must be one of these.
fn report<'a>(args: &'a Args, setup: &'a Setup, log: &'a Log) -> Result<Report<'a>, Failure> {
    macro_rules! with_channels {
        ($($count:literal)*) => {
            match log.channels.len() {
                $($count => with_channels_of::<$count>(args, setup, log),)*
                other => Err(Failure::of(
                    "--sensor custom",
                    format_args!("the log has {other} channels; leave out columns until there are 1 to 18"),
                )),
            }
        };
    }
    with_channels!(1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18)
}

fn with_channels_of<'a, const C: usize>(
    args: &'a Args,
    setup: &'a Setup,
    log: &'a Log,
) -> Result<Report<'a>, Failure> {
    let mut instrument = Instrument::<C>::new(args, setup)?;
    let dark = Frames::read(args, log)?;
    Ok(Report {
        setup,
        colors: std::mem::take(&mut instrument.colors),
        frequencies_hz: &args.flicker_hz,
        log,
        measure: Box::new(move |entry| measure::reading(&instrument, setup, &dark, entry)),
    })
}
