//! Which command is run.

use crate::failure::{Failure, exit_code, short};
use crate::{measure, paint, scene, sensor, usage};
use clap::error::{ContextKind, Error, ErrorKind};
use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use std::process::ExitCode;

/// Light and color, measured and predicted from spectra.
#[derive(Debug, Parser)]
#[command(
    name = "nanospectra",
    version,
    propagate_version = true,
    disable_help_subcommand = true,
    after_help = "Without a command it measures the lamp that it brings, CIE L41, a white LED.\n\
                  'nanospectra COMMAND --help' explains the options, the input and the output of a command."
)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Debug, Subcommand)]
enum Command {
    Measure(measure::Args),
    Sensor(sensor::Args),
    Paint(paint::Args),
    Scene(scene::Args),
}

/// Runs what the command line asks for.
pub fn main() -> ExitCode {
    exit_code(run().map(|()| ExitCode::SUCCESS))
}

fn run() -> Result<(), Failure> {
    let matches = Cli::command().try_get_matches().map_err(refused)?;
    match Cli::from_arg_matches(&matches).map_err(refused)?.command {
        None => measure::run(&measure::Args::default()),
        Some(Command::Measure(args)) => measure::run(&args),
        Some(Command::Sensor(args)) => sensor::run(&args),
        Some(Command::Paint(args)) => paint::run(&args.in_order_of(&matches)),
        Some(Command::Scene(args)) => scene::run(&args),
    }
}

/// A failure that begins with the name of the command it is about.
fn refused(error: Error) -> Failure {
    let word = std::env::args_os().nth(1).unwrap_or_default();
    let word = word.to_string_lossy();
    let cli = Cli::command();
    let command = cli.find_subcommand(word.as_ref()).map_or("nanospectra", |command| command.get_name());
    if error.kind() == ErrorKind::InvalidSubcommand {
        let word = short(usage::context(&error, ContextKind::InvalidSubcommand).unwrap_or_default());
        let names: Vec<&str> = cli.get_subcommands().map(|command| command.get_name()).collect();
        let what = format!("'{word}' is no command; use {}, or see --help", names.join(", "));
        return Failure::of(command, what);
    }
    let negative = if command == "paint" { paint::negative(&error) } else { None };
    negative.unwrap_or_else(|| usage::refused(command, &error))
}
