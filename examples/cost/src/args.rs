//! The options of the command line.

use clap::{Parser, builder::PossibleValuesParser};
use nanospectra_cli::failure::Failure;
use nanospectra_cli::usage;
use std::path::PathBuf;

/// What accuracy costs in time: every choice with its error, instructions, bytes and nanoseconds.
#[derive(Debug, Parser)]
#[command(name = "cost", version)]
pub struct Args {
    /// Measure times in fewer runs; all other figures stay the same
    #[arg(long)]
    pub quick: bool,

    /// Run only these studies, named with commas between; the default is all
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub only: Vec<String>,

    /// Also write all tables as JSON
    #[arg(long, value_name = "FILE")]
    pub json: Option<PathBuf>,

    /// Compare all figures but times with the record, and the README, the guides and the pictures with what
    /// the record makes of them; the exit code is 1 if anything differs
    #[arg(long)]
    pub check: bool,

    /// Record what is measured, and renew the pictures and the tables of the README and the guides
    #[arg(long, conflicts_with = "check")]
    pub bless: bool,

    /// Measure nothing, and renew the pictures and the tables of the README and the guides
    /// from the record
    #[arg(long, conflicts_with_all = ["check", "bless", "only", "json"])]
    pub docs: bool,

    /// Measure nothing, and choose the grid, the scheme and the bands for lamps and limits from the record
    #[arg(long, conflicts_with_all = ["check", "bless", "only", "json", "docs"])]
    pub advise: bool,

    #[command(flatten)]
    pub limits: Limits,
}

/// The lamps that a choice is for, and what it may cost.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "With --advise")]
pub struct Limits {
    /// Classes of lamps, with commas between: smooth, halophosphate, triphosphor, led, hid, lines; or fl
    /// (both fluorescent classes), rooms (all but lines), all
    #[arg(long, value_name = "NAMES", value_delimiter = ',', default_value = "rooms", requires = "advise")]
    pub lamps: Vec<String>,

    /// The most instructions that one XYZ may take
    #[arg(long, value_name = "COUNT", value_parser = limit, requires = "advise")]
    pub most_instructions: Option<f64>,

    /// The core on which the instructions are counted
    #[arg(long, value_name = "CORE", value_parser = PossibleValuesParser::new(["m4f", "m0"]),
        default_value = "m4f", requires = "advise")]
    pub core: String,

    /// The most bytes that the constants may take
    #[arg(long, value_name = "COUNT", value_parser = limit, requires = "advise")]
    pub most_bytes: Option<f64>,

    /// The largest mean CIEDE2000 of a class; the cheapest choice that keeps it is taken
    #[arg(long, value_name = "CIEDE2000", value_parser = limit, requires = "advise")]
    pub most_error: Option<f64>,

    /// Only choices without negative weights, so that X, Y and Z are never negative
    #[arg(long, requires = "advise")]
    pub never_negative: bool,

    /// The light changes, or is not known before the program runs
    #[arg(long, requires = "advise")]
    pub light_changes: bool,
}

impl Args {
    /// Reads the command line. With `--help` and `--version` it prints and ends the program.
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
