//! From a log of a color sensor's counts to every number that can be had from them.
//!
//! A file becomes [`cells`], these the entries of a [`log`], each of them a [`measure`]d reading by an
//! [`instrument`], and that [`text`] or [`json`]. Without a log it reads one that was [`simulate`]d.

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

/// What is printed: made in full before the first line, so that an error leaves no half report.
pub struct Report {
    pub setup: Setup,
    /// What was made of responsivities or of a calibration.
    pub colors: Vec<String>,
    pub readings: Vec<Reading>,
    pub runs: Vec<Run>,
}

/// Reports on the log, or on the bundled one.
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

/// The number of channels is a type: one of these.
fn report(args: &Args, setup: Setup, log: Log) -> Result<Report, Failure> {
    macro_rules! with_channels {
        ($($count:literal)*) => {
            match log.channels.len() {
                $($count => with_channels_of::<$count>(args, setup, log),)*
                other => Err(Failure::of(
                    "--sensor custom",
                    format_args!("{other} channels; give a log of 1 to 18, leave out the others"),
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
