//! The command line.

use crate::failure::Failure;
use crate::input::text::check_stdin;
use crate::sensor::chip::Chip;
use clap::ValueEnum;
use nanospectra::sensor::chip::{ALL, as7341};
use std::path::PathBuf;

const INPUT: &str = "\
The log:
  CSV in UTF-8 with a heading: one row a reading, raw counts. '#' starts a comment line. Columns in any order:
CHIPS
    custom         gain, time_ms, full_scale; every other column is a channel
  gain is the factor (0.5, 1, 2, ..), not the register's code. Also known: time (seconds, for flicker), label
  (readings in a row with the same label are one run), temperature_c (passed on), dark_NAME for each channel: its count in
  the dark at the same exposure. Other columns are not used, and named in a note.
  Nothing is dropped or guessed: what is wrong ends the program with exit code 2 and one line that says where.

What is known of the chip:
  Without more the nominal peaks and widths of the data sheet: good for a first look, marked NOMINAL. No unit comes
  from them: lux and PPFD stay empty, and Y is on a scale of its own.
  --responsivity FILE: a heading nm, NAME, ..; then rows of a wavelength and the responsivity of each channel, at any
  step. With --unit absolute they are basic counts (counts per ms at gain 1) for each W/m2, and lux and PPFD follow.
  --calibration FILE: either three rows X, Y, Z (heading row, NAME, ..) that basic counts are multiplied by, or
  patches (heading NAME, .., X, Y, Z): rows of basic counts and the XYZ that they should come to, fitted with errors
  relative to Y. Y is in lux unless --unit relative says otherwise.
  Chips whose maker publishes a matrix are measured by that.

Conventions:
  CIE 1931 2 degree observer. Uncertainties are standard ones (k = 1) and of noise alone: without --electrons-per-count
  and --read-counts of the rounding to whole counts alone.
  Basic counts to light: the smoothest spectrum that explains them, in bins of 10 nm; only where a channel sees.
  'next' is the exposure for the next reading of the same light.";

/// [`INPUT`] with a line for each chip that the library knows.
fn help() -> String {
    let line = |chip: &'static nanospectra::sensor::chip::Chip| {
        let settings = Chip(Some(chip)).settings().join(", ");
        let mark = if settings.is_empty() { "" } else { "; " };
        let (name, channels) = (chip.name.to_lowercase(), chip.channels.join(", "));
        format!("    {name:<14} {settings}{mark}{channels}   ({})\n", chip.summary)
    };
    INPUT.replace("CHIPS\n", &ALL.into_iter().map(line).collect::<String>())
}

/// Color, illuminance, spectrum, uncertainty and flicker from a log of a color sensor's counts.
#[derive(Debug, clap::Args)]
#[command(after_help = help())]
pub struct Args {
    /// The log of counts; '-' is standard input. Without one: simulated readings of known lamps by an AS7341
    #[arg(value_name = "LOG")]
    pub log: Option<PathBuf>,

    /// The chip
    #[arg(long, value_enum, default_value = "as7341")]
    pub sensor: Chip,

    /// Responsivities of its channels, in place of the nominal ones
    #[arg(long, value_name = "FILE")]
    pub responsivity: Option<PathBuf>,

    /// A matrix to XYZ, or patches to make one from
    #[arg(long, value_name = "FILE")]
    pub calibration: Option<PathBuf>,

    /// Counts in the dark: a log without time; one row for all exposures, or rows with their exposures
    #[arg(long, value_name = "FILE")]
    pub dark: Option<PathBuf>,

    /// Whether responsivities or calibration are absolute [default: a calibration is, responsivities are not]
    #[arg(long, value_enum)]
    pub unit: Option<Unit>,

    /// Shot noise: electrons for one count at unit gain
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub electrons_per_count: Option<f32>,

    /// Read noise: counts, rms, besides the rounding
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub read_counts: Option<f32>,

    /// A reading is too dark when its channels together are fewer counts above their dark levels
    #[arg(long, value_name = "N", allow_negative_numbers = true, default_value_t = 10.0)]
    pub floor: f32,

    /// Frequencies at which to look for flicker
    #[arg(long, value_name = "HZ", allow_negative_numbers = true, value_delimiter = ',', default_values = ["100", "120"])]
    pub flicker_hz: Vec<f32>,

    /// Print JSON, one object a line: each reading, then each run of readings; numbers unrounded
    #[arg(long)]
    pub json: bool,

    /// Print the simulated log itself
    #[arg(long, conflicts_with_all = ["log", "json"])]
    pub simulate: bool,
}

/// `--unit`
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Unit {
    Relative,
    Absolute,
}

impl Args {
    /// What the command line alone shows to be wrong.
    pub fn check(&self) -> Result<(), Failure> {
        let inputs = [&self.log, &self.responsivity, &self.calibration, &self.dark];
        check_stdin(inputs.into_iter().flatten())?;
        if self.log.is_none() && self.sensor.title() != as7341::CHIP.name {
            return Err(Failure::of("--sensor", "the simulated log is of an AS7341; give the LOG of yours"));
        }
        if self.responsivity.is_some() && self.calibration.is_some() && self.unit.is_some() {
            let what =
                "with a calibration the responsivities only shape the spectrum; leave out one of the three";
            return Err(Failure::of("--unit", what));
        }
        let positive = |option: &str, value: Option<f32>, zero_too: bool| match value {
            Some(value) if !(value > 0.0 && value.is_finite() || zero_too && value == 0.0) => {
                let so = if zero_too { "0 or more" } else { "one above 0" };
                Err(Failure::of(option, format_args!("{value} is no such number; give {so}")))
            }
            _ => Ok(()),
        };
        positive("--electrons-per-count", self.electrons_per_count, false)?;
        positive("--floor", Some(self.floor), true)?;
        positive("--read-counts", self.read_counts, true)?;
        self.flicker_hz.iter().try_for_each(|hz| positive("--flicker-hz", Some(*hz), false))
    }
}
