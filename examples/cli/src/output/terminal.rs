//! Writes to standard output, which may be a terminal with colors or a pipe that is closed early.

use crate::failure::Failure;
use std::env;
use std::io::{self, ErrorKind, IsTerminal, Write};

/// Writes a text, of which a pipe such as `| head` may read only the beginning.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    printed(out.write_all(text.as_bytes()).and_then(|()| out.flush()))
}

/// Writes a message of clap to standard output, with styles if that is a terminal.
pub fn print_message(message: &clap::Error) -> Result<(), Failure> {
    printed(message.print().and_then(|()| io::stdout().flush()))
}

fn printed(outcome: io::Result<()>) -> Result<(), Failure> {
    match outcome {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Failure::of_stdout(&error)),
        _ => Ok(()),
    }
}

/// Returns whether standard output is a terminal that wants colors.
///
/// It follows <https://no-color.org> and the variable `TERM`.
pub fn is_colorful() -> bool {
    io::stdout().is_terminal()
        && env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
        && env::var_os("TERM").is_none_or(|value| value != "dumb")
}
