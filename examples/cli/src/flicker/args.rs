//! Defines the options of the command `flicker` and their help.

use crate::failure::Failure;
use std::path::PathBuf;

const INPUT: &str = "\
The waveform:
  A file has one reading in each row, at equal steps of time, such as the counts of a converter behind a photodiode. It
  may have a heading. A line that starts with '#' is a comment. The readings may have any unit that is proportional to
  the light, and darkness must be 0.

The measures:
  Pst LM             how severe the flicker is that is seen as such, by IEC TR 61547-1; at 1, half of all people see it.
                     It needs 400 to 50000 readings a second for 30 s or more, of which the first 20 s do not count; a
                     measurement takes 180 s
  The others are those of the first second, for each frequency:
  percent flicker    100 (max - min) / (max + min) of whole periods of the frequency
  flicker index      the share of the light that is above the mean
  amplitude          of the part that swings with the frequency, from its crest to the mean, as a part of the mean
  SVM                how clearly things that move are seen to jump, by IEC TR 63158, from the frequency and its multiples
                     up to 2000 Hz; at 1, half of all people see it. It needs 4000 or more readings a second";

/// Computes how much a light flickers, and how visible that is, from the waveform of a photodiode.
#[derive(Debug, clap::Args)]
#[command(after_help = INPUT)]
pub struct Args {
    /// The file with the readings; '-' is standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,

    /// How many readings there are in a second
    #[arg(long, value_name = "HZ", allow_negative_numbers = true)]
    pub rate_hz: f32,

    /// The frequencies with which the light may repeat
    #[arg(long, value_name = "HZ", allow_negative_numbers = true, value_delimiter = ',', default_values = ["100", "120"])]
    pub flicker_hz: Vec<f32>,

    /// Print a JSON object with numbers that are not rounded
    #[arg(long)]
    pub json: bool,
}

impl Args {
    /// Returns a failure for what is wrong with the command line alone.
    pub fn check(&self) -> Result<(), Failure> {
        positive("--rate-hz", &[self.rate_hz])?;
        positive("--flicker-hz", &self.flicker_hz)
    }
}

fn positive(option: &str, values: &[f32]) -> Result<(), Failure> {
    match values.iter().find(|value| !(**value > 0.0 && value.is_normal())) {
        Some(value) => {
            Err(Failure::of(option, format_args!("{value} is not allowed; give a number above 0")))
        }
        None => Ok(()),
    }
}
