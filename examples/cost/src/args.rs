//! The command line.

use clap::{Parser, builder::PossibleValuesParser};
use nanospectra_cli::failure::Failure;
use nanospectra_cli::usage;
use std::path::PathBuf;

/// What accuracy costs in time: every choice with its error, instructions, bytes and nanoseconds.
#[derive(Debug, Parser)]
#[command(name = "cost", version)]
pub struct Args {
    /// Times by fewer runs; figures stay the same
    #[arg(long)]
    pub quick: bool,

    /// Only these studies, by name, commas between; without it all
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub only: Vec<String>,

    /// Also write everything as JSON
    #[arg(long, value_name = "FILE")]
    pub json: Option<PathBuf>,

    /// Compare all but times with what is on record, and the README and the guides with that; exit code 1 if anything
    /// differs
    #[arg(long)]
    pub check: bool,

    /// Put what is measured on record: the JSON, the chart, the tables of the README and the guides
    #[arg(long, conflicts_with = "check")]
    pub bless: bool,

    /// Only write the tables of the README, those of the guides and the chart anew, from what is on record
    #[arg(long, conflicts_with_all = ["check", "bless", "only", "json"])]
    pub docs: bool,

    /// Only choose: the grid, the scheme and the bands for lamps and limits, from what is on record
    #[arg(long, conflicts_with_all = ["check", "bless", "only", "json", "docs"])]
    pub advise: bool,

    #[command(flatten)]
    pub limits: Limits,
}

/// What a choice is for, and what it may cost.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "With --advise")]
pub struct Limits {
    /// Classes of lamps, commas between: smooth, halophosphate, triphosphor, led, hid, lines; fl: both kinds;
    /// rooms: all but lines; all
    #[arg(long, value_name = "NAMES", value_delimiter = ',', default_value = "rooms", requires = "advise")]
    pub lamps: Vec<String>,

    /// Instructions for one XYZ
    #[arg(long, value_name = "COUNT", value_parser = limit, requires = "advise")]
    pub most_instructions: Option<f64>,

    /// The core that they are counted on
    #[arg(long, value_name = "CORE", value_parser = PossibleValuesParser::new(["m4f", "m0"]), default_value = "m4f",
        requires = "advise")]
    pub core: String,

    /// Bytes of constants
    #[arg(long, value_name = "COUNT", value_parser = limit, requires = "advise")]
    pub most_bytes: Option<f64>,

    /// CIEDE2000 in the mean of each class; the cheapest choice within it is taken
    #[arg(long, value_name = "CIEDE2000", value_parser = limit, requires = "advise")]
    pub most_error: Option<f64>,

    /// No weight below 0: no X, Y or Z below 0 under any filter
    #[arg(long, requires = "advise")]
    pub never_negative: bool,

    /// The light is not known before the program runs, or changes
    #[arg(long, requires = "advise")]
    pub light_changes: bool,
}

impl Args {
    /// The command line, or what is wrong with it. `--help` and `--version` print and end here.
    pub fn read() -> Result<Self, Failure> {
        Args::try_parse().map_err(|error| usage::refused("cost", &error))
    }
}

fn limit(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value > 0.0 && value.is_finite() => Ok(value),
        _ => Err("not a number above 0".to_owned()),
    }
}
