//! What stops the program: one line for a person, exit code 2.

use std::fmt;
use std::io::{self, Write};
use std::process::ExitCode;

/// One line: where, what is wrong, what to do.
#[derive(Debug)]
pub struct Failure(String);

impl Failure {
    /// A failure of `place`, which is a file, an option or a directory.
    pub fn of(place: impl fmt::Display, what: impl fmt::Display) -> Self {
        Failure(format!("{place}: {what}"))
    }

    /// A failure at a line of a file, counted from 1.
    pub fn at(file: &str, line: usize, what: impl fmt::Display) -> Self {
        Failure(format!("{file}:{line}: {what}"))
    }
}

impl fmt::Display for Failure {
    /// Stays one line, whatever file names and cells hold.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&printable(&self.0))
    }
}

/// Ends a program: says why if it failed, on stderr.
pub fn exit_code(outcome: Result<ExitCode, Failure>) -> ExitCode {
    outcome.unwrap_or_else(|failure| {
        // Nobody may be there to read it.
        let _ = writeln!(io::stderr(), "{failure}");
        ExitCode::from(2)
    })
}

/// The first forty characters of somebody's text, for messages.
pub fn short(text: &str) -> String {
    match text.char_indices().nth(40) {
        Some((end, _)) => format!("{}..", &text[..end]),
        None => text.to_owned(),
    }
}

/// `text` with control characters spelled out: no line breaks, no terminal escapes.
pub fn printable(text: &str) -> String {
    text.chars()
        .map(|c| if c.is_control() { c.escape_default().to_string() } else { c.to_string() })
        .collect()
}
