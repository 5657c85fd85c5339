//! Writes to standard output, which may be a terminal with colors or a pipe that is closed early.

use crate::failure::Failure;
use std::env;
use std::io::{self, BufWriter, ErrorKind, IsTerminal, StdoutLock, Write};

/// Standard output, to which a report is written piece by piece.
pub struct Out(BufWriter<StdoutLock<'static>>);

/// The reason why a report is not written to its end.
pub enum Stop {
    Failed(Failure),
    /// Nobody reads on, which is no failure.
    Unread,
}

impl From<Failure> for Stop {
    fn from(failure: Failure) -> Self {
        Stop::Failed(failure)
    }
}

impl Out {
    pub fn write(&mut self, text: &str) -> Result<(), Stop> {
        self.write_bytes(text.as_bytes())
    }

    pub fn write_bytes(&mut self, bytes: &[u8]) -> Result<(), Stop> {
        self.0.write_all(bytes).map_err(|error| stopped(&error))
    }
}

/// Writes what a function writes, of which a pipe such as `| head` may read only the beginning.
pub fn stream(write: impl FnOnce(&mut Out) -> Result<(), Stop>) -> Result<(), Failure> {
    let mut out = Out(BufWriter::new(io::stdout().lock()));
    ended(write(&mut out).and_then(|()| out.0.flush().map_err(|error| stopped(&error))))
}

/// Writes a text.
pub fn print(text: &str) -> Result<(), Failure> {
    stream(|out| out.write(text))
}

/// Writes texts one after the other, each of which is made when it is its turn.
pub fn print_all(texts: impl IntoIterator<Item = String>) -> Result<(), Failure> {
    stream(|out| texts.into_iter().try_for_each(|text| out.write(&text)))
}

/// Writes a message of clap to standard output, with styles if that is a terminal.
pub fn print_message(message: &clap::Error) -> Result<(), Failure> {
    ended(message.print().and_then(|()| io::stdout().flush()).map_err(|error| stopped(&error)))
}

fn ended(outcome: Result<(), Stop>) -> Result<(), Failure> {
    match outcome {
        Err(Stop::Failed(failure)) => Err(failure),
        Ok(()) | Err(Stop::Unread) => Ok(()),
    }
}

fn stopped(error: &io::Error) -> Stop {
    match error.kind() {
        ErrorKind::BrokenPipe => Stop::Unread,
        _ => Stop::Failed(Failure::of_stdout(error)),
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
