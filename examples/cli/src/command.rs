//! Parses the command line and runs the command that it names.

use crate::failure::{Failure, exit_code, short};
use crate::{flicker, measure, paint, scene, sensor, usage};
use clap::error::{ContextKind, Error, ErrorKind};
use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use std::process::ExitCode;

/// Computes color, illuminance and color rendering from spectra, sensor counts, RGB colors and scenes.
#[derive(Debug, Parser)]
#[command(
    name = "nanospectra",
    version,
    propagate_version = true,
    disable_help_subcommand = true,
    after_help = "Without a command, the program measures the lamp that comes with it: CIE L41, a white LED.\n\
                  'nanospectra COMMAND --help' explains the options, the input and the output of a command.\n\
                  The exit code is 0 after an answer, 1 if standard output cannot be written, and else 2."
)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Debug, Subcommand)]
enum Command {
    Measure(measure::Args),
    Sensor(sensor::Args),
    Flicker(flicker::Args),
    Paint(paint::Args),
    Scene(scene::Args),
}

/// Runs the command that the command line names, and reports its outcome as an exit code.
pub fn main() -> ExitCode {
    exit_code(run().map(|()| ExitCode::SUCCESS))
}

fn run() -> Result<(), Failure> {
    let matches = Cli::command().try_get_matches().map_err(refused)?;
    match Cli::from_arg_matches(&matches).map_err(refused)?.command {
        None => measure::run(&measure::Args::default()),
        Some(Command::Measure(args)) => measure::run(&args),
        Some(Command::Sensor(args)) => sensor::run(&args),
        Some(Command::Flicker(args)) => flicker::run(&args),
        Some(Command::Paint(args)) => paint::run(&args.in_order_of(&matches)),
        Some(Command::Scene(args)) => scene::run(&args),
    }
}

/// Turns an error of clap into a failure that begins with the name of the command.
fn refused(error: Error) -> Failure {
    let word = std::env::args_os().nth(1).unwrap_or_default();
    let word = word.to_string_lossy();
    let cli = Cli::command();
    let command = cli.find_subcommand(word.as_ref()).map_or("nanospectra", |command| command.get_name());
    if error.kind() == ErrorKind::InvalidSubcommand {
        let word = short(usage::context(&error, ContextKind::InvalidSubcommand).unwrap_or_default());
        let names: Vec<&str> = cli.get_subcommands().map(|command| command.get_name()).collect();
        let what = format!("'{word}' is not a command; use {}, or see --help", names.join(", "));
        return Failure::of(command, what);
    }
    let negative = if command == "paint" { paint::negative(&error) } else { None };
    negative.unwrap_or_else(|| usage::refused(command, &error))
}
