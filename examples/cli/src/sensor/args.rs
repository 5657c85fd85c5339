//! Defines the options of the command `sensor` and their help.

use crate::failure::Failure;
use crate::input::text::check_stdin;
use crate::sensor::chip::Chip;
use clap::ValueEnum;
use nanospectra::sensor::chip::{ALL, as7341};
use std::path::PathBuf;

const INPUT: &str = "\
The log:
  A log is CSV in UTF-8. It has a heading, and then a row of raw counts for each reading. A line that starts with '#'
  is a comment. The columns may be in any order. Each chip has its own:
CHIPS
    custom         gain, time_ms, full_scale; every other column is a channel
  gain is the factor (0.5, 1, 2 and so on), not the code in the register. These columns may be added:
    time           in seconds, for flicker
    label          names a reading; readings in a row with the same label are one run
    temperature_c  is passed on to the JSON
    dark_NAME      for each channel NAME, its count in the dark at the same exposure
  Other columns are not used, and a note names them.
  Nothing is dropped or guessed. If something is wrong, the program ends with exit code 2 and one line that says where
  it is, what it is and what to do.

What is known of the chip:
  Without these options, the program uses the nominal peaks and widths of the data sheet and marks the result NOMINAL.
  That is good for a first look, but it gives no unit: lux and PPFD are empty, and Y is on a scale of its own.
  --responsivity FILE has a heading (nm and the names of the channels) and then rows of a wavelength and the
  responsivity of each channel, at any step. With --unit absolute, responsivities are basic counts (counts per ms at
  gain 1) for each W/m2, and the program computes lux and PPFD.
  --calibration FILE is one of two tables:
    a matrix       the rows X, Y and Z, by which basic counts are multiplied (heading: row and the channels)
    patches        rows of basic counts and of the XYZ that they should give (heading: the channels, X, Y, Z); the
                   program fits a matrix to them, with errors relative to Y
  With a calibration, Y is in lux unless --unit relative is given.
  If the maker of a chip publishes a matrix, the program uses that.

Conventions:
  Colors are those of the CIE 1931 2 degree observer. Uncertainties are standard uncertainties (k = 1) that include
  noise alone. Without --electrons-per-count and --read-counts they include only the rounding to whole counts.
  The spectrum is the smoothest one that explains the basic counts, in bins of 10 nm, where a channel is sensitive.
  The column 'next' is the exposure for the next reading of the same light.";

/// Returns [`INPUT`] with a line for each chip that the library knows.
fn help() -> String {
    let line = |chip: &'static nanospectra::sensor::chip::Chip| {
        let settings = Chip(Some(chip)).settings().join(", ");
        let mark = if settings.is_empty() { "" } else { "; " };
        let (name, channels) = (chip.name.to_lowercase(), chip.channels.join(", "));
        format!("    {name:<14} {settings}{mark}{channels}   ({})\n", chip.summary)
    };
    INPUT.replace("CHIPS\n", &ALL.into_iter().map(line).collect::<String>())
}

/// Computes color, illuminance, spectrum, uncertainty and flicker from a log of a color sensor's
/// counts.
#[derive(Debug, clap::Args)]
#[command(after_help = help())]
pub struct Args {
    /// The log of counts; '-' is standard input. Without one, the program reads a simulated log of an
    /// AS7341 under known lamps
    #[arg(value_name = "LOG")]
    pub log: Option<PathBuf>,

    /// The chip that made the log
    #[arg(long, value_enum, default_value = "as7341")]
    pub sensor: Chip,

    /// A table with the responsivities of the channels, to use in place of the nominal ones
    #[arg(long, value_name = "FILE")]
    pub responsivity: Option<PathBuf>,

    /// A table with a matrix to XYZ, or with measured patches to fit one to
    #[arg(long, value_name = "FILE")]
    pub calibration: Option<PathBuf>,

    /// A log of counts in the dark, with one row for all exposures or with a row for each
    #[arg(long, value_name = "FILE")]
    pub dark: Option<PathBuf>,

    /// The unit of the calibration or of the responsivities [default: absolute for a calibration,
    /// relative for responsivities]
    #[arg(long, value_enum)]
    pub unit: Option<Unit>,

    /// The electrons for one count at a gain of 1, from which shot noise follows
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub electrons_per_count: Option<f32>,

    /// The read noise besides the rounding, as root mean square in counts
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub read_counts: Option<f32>,

    /// The sum of all channels, in counts above dark, below which a reading is too dark
    #[arg(long, value_name = "N", allow_negative_numbers = true, default_value_t = 10.0)]
    pub floor: f32,

    /// The frequencies at which to look for flicker
    #[arg(long, value_name = "HZ", allow_negative_numbers = true, value_delimiter = ',', default_values = ["100", "120"])]
    pub flicker_hz: Vec<f32>,

    /// Print one JSON object per line, for each reading and then for each run, with numbers that are
    /// not rounded
    #[arg(long)]
    pub json: bool,

    /// Print the simulated log instead of reading it
    #[arg(long, conflicts_with_all = ["log", "json"])]
    pub simulate: bool,
}

/// The value of `--unit`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Unit {
    Relative,
    Absolute,
}

impl Args {
    /// Returns a failure for what is wrong with the command line alone.
    pub fn check(&self) -> Result<(), Failure> {
        let inputs = [&self.log, &self.responsivity, &self.calibration, &self.dark];
        check_stdin(inputs.into_iter().flatten())?;
        if self.log.is_none() && self.sensor.title() != as7341::CHIP.name {
            return Err(Failure::of(
                "--sensor",
                "the simulated log is one of an AS7341; give the LOG of your sensor",
            ));
        }
        if self.responsivity.is_some() && self.calibration.is_some() && self.unit.is_some() {
            let what = "with --calibration, --responsivity only shapes the spectrum; leave out one of the three options";
            return Err(Failure::of("--unit", what));
        }
        let positive = |option: &str, value: Option<f32>, zero_too: bool| match value {
            Some(value) if !(value > 0.0 && value.is_finite() || zero_too && value == 0.0) => {
                let so = if zero_too { "a number of 0 or more" } else { "a number above 0" };
                Err(Failure::of(option, format_args!("{value} is not allowed; give {so}")))
            }
            _ => Ok(()),
        };
        positive("--electrons-per-count", self.electrons_per_count, false)?;
        positive("--floor", Some(self.floor), true)?;
        positive("--read-counts", self.read_counts, true)?;
        self.flicker_hz.iter().try_for_each(|hz| positive("--flicker-hz", Some(*hz), false))
    }
}
