//! Turns clap's messages about a command line into messages of this program.

use crate::failure::{Failure, short};
use crate::output::terminal;
use clap::ValueEnum;
use clap::error::{ContextKind, ContextValue, Error};
use std::process;

/// Turns an error of clap into a failure of `program`, on one line.
///
/// Requests for the help or the version are errors too; they are printed, and the program ends here.
pub fn refused(program: &str, error: &Error) -> Failure {
    if !error.use_stderr() {
        match terminal::print_message(error) {
            Ok(()) => process::exit(0),
            Err(unwritten) => return unwritten,
        }
    }
    let mut message = error.to_string();
    for kind in [ContextKind::InvalidArg, ContextKind::InvalidValue] {
        if let Some(word) = context(error, kind) {
            message = message.replace(word, &short(word));
        }
    }
    Failure::of(program, one_line(&message))
}

/// Returns the word of the command line that an error is about.
pub fn context(error: &Error, kind: ContextKind) -> Option<&str> {
    if let Some(ContextValue::String(word)) = error.get(kind) { Some(word) } else { None }
}

/// Returns the name of an option's value on the command line.
pub fn name_of(value: impl ValueEnum) -> String {
    value.to_possible_value().map_or_else(String::new, |value| value.get_name().to_owned())
}

/// Returns clap's message without its headings and its usage, on one line.
fn one_line(message: &str) -> String {
    let said = message
        .lines()
        .map(str::trim)
        .take_while(|line| !line.starts_with("Usage:") && !line.starts_with("For more"))
        .filter(|line| !line.is_empty())
        .collect::<Vec<_>>()
        .join(" ")
        .replace(" tip:", "; tip:")
        .replace("invalid float literal", "not a number");
    format!("{}; see --help", said.trim_start_matches("error: "))
}
