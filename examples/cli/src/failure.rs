//! Defines the failure that stops the program, with one line for a person and an exit code.

use std::fmt;
use std::io::{self, Write};
use std::process::ExitCode;

/// The exit code if standard output cannot be written, and for any other failure.
const UNWRITTEN: u8 = 1;
const REFUSED: u8 = 2;

/// A failure, as one line that says where it is, what is wrong and what to do.
#[derive(Debug)]
pub struct Failure {
    message: String,
    code: u8,
}

impl Failure {
    /// Returns a failure of `place`, which is a file, an option or a directory.
    pub fn of(place: impl fmt::Display, what: impl fmt::Display) -> Self {
        Failure { message: format!("{place}: {what}"), code: REFUSED }
    }

    /// Returns a failure at a line of a file, counted from 1.
    pub fn at(file: &str, line: usize, what: impl fmt::Display) -> Self {
        Failure::of(format_args!("{file}:{line}"), what)
    }

    /// Returns the failure of standard output.
    pub fn of_stdout(error: &io::Error) -> Self {
        let what =
            format_args!("the output cannot be written ({}); check that its disk is not full", error.kind());
        Failure { code: UNWRITTEN, ..Failure::of("stdout", what) }
    }
}

impl fmt::Display for Failure {
    /// Writes one line, whatever characters file names and cells contain.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&printable(&self.message))
    }
}

/// Returns the exit code of a program's outcome, after writing the failure, if there is one, to stderr.
pub fn exit_code(outcome: Result<ExitCode, Failure>) -> ExitCode {
    outcome.unwrap_or_else(|failure| {
        // If stderr cannot be written, there is nothing else to report to.
        let _ = writeln!(io::stderr(), "{failure}");
        ExitCode::from(failure.code)
    })
}

/// Returns the first forty characters of a user's text, for messages.
pub fn short(text: &str) -> String {
    match text.char_indices().nth(40) {
        Some((end, _)) => format!("{}..", &text[..end]),
        None => text.to_owned(),
    }
}

/// Returns a text with its control characters escaped, so that it holds no line breaks or terminal escapes.
pub fn printable(text: &str) -> String {
    text.chars()
        .map(|c| if c.is_control() { c.escape_default().to_string() } else { c.to_string() })
        .collect()
}
