//! Defines the failure that stops the program, with one line for a person and exit code 2.

use std::fmt;
use std::io::{self, Write};
use std::process::ExitCode;

/// A failure, as one line that says where it is, what is wrong and what to do.
#[derive(Debug)]
pub struct Failure(String);

impl Failure {
    /// Returns a failure of `place`, which is a file, an option or a directory.
    pub fn of(place: impl fmt::Display, what: impl fmt::Display) -> Self {
        Failure(format!("{place}: {what}"))
    }

    /// Returns a failure at a line of a file, counted from 1.
    pub fn at(file: &str, line: usize, what: impl fmt::Display) -> Self {
        Failure(format!("{file}:{line}: {what}"))
    }
}

impl fmt::Display for Failure {
    /// Writes one line, whatever characters file names and cells contain.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&printable(&self.0))
    }
}

/// Returns the exit code of a program's outcome, after writing the failure, if there is one, to stderr.
pub fn exit_code(outcome: Result<ExitCode, Failure>) -> ExitCode {
    outcome.unwrap_or_else(|failure| {
        // If stderr cannot be written, there is nothing else to report to.
        let _ = writeln!(io::stderr(), "{failure}");
        ExitCode::from(2)
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
