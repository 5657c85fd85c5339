//! The command `sensor`, which computes color, illuminance and flicker from a log of a color sensor's counts.
//!
//! A file is split into [`cells`], which are read as the entries of a [`log`]. An [`instrument`] [`measure`]s
//! each of them, and the readings are reported as [`text`] or as [`json`]. Without a log, the command reads
//! one that was [`simulate`]d.

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
use instrument::{Instrument, Setup};
use log::Log;
use measure::Reading;
use runs::Run;

/// The whole report, which is complete before its first line is printed, so that no error leaves half of it.
pub struct Report {
    pub setup: Setup,
    /// Lines that say how the colors were computed from responsivities or a calibration.
    pub colors: Vec<String>,
    pub readings: Vec<Reading>,
    pub runs: Vec<Run>,
}

/// Reports on the log, or on the bundled one if none is named.
pub fn run(args: &Args) -> Result<(), Failure> {
    args.check()?;
    if args.simulate {
        return terminal::print(&simulate::log());
    }
    let log = log::read(args)?;
    let setup = Setup::new(args, &log.channels)?;
    let report = report(args, setup, log)?;
    terminal::print(&if args.json { json::lines(&report) } else { text::report(&report) })
}

/// Makes the report. The number of channels is part of a type, and so must be one of these.
fn report(args: &Args, setup: Setup, log: Log) -> Result<Report, Failure> {
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

fn with_channels_of<const C: usize>(args: &Args, setup: Setup, log: Log) -> Result<Report, Failure> {
    let instrument = Instrument::<C>::new(args, &setup)?;
    let dark = dark::Frames::read(args, &log)?;
    let readings = log
        .entries
        .into_iter()
        .map(|entry| measure::reading(&instrument, &setup, &dark, entry))
        .collect::<Result<Vec<_>, _>>()?;
    let runs = runs::of(&readings, &args.flicker_hz);
    Ok(Report { colors: instrument.colors, setup, readings, runs })
}
