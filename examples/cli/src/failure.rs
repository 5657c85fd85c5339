//! Defines the failure that stops the program, with one line for a person and an exit code.

use std::fmt;
use std::io::{self, Write};
use std::process::ExitCode;

/// The exit code if standard output cannot be written, and for any other failure.
const UNWRITTEN: u8 = 1;
const REFUSED: u8 = 2;
/// The length in characters above which a message is cut in its middle: it begins with the place, and ends
/// with what to do.
const LONGEST: usize = 600;

/// A failure, as one line that says where it is, what is wrong and what to do, or several such lines.
#[derive(Debug)]
pub struct Failure {
    message: String,
    code: u8,
    /// The failures that came with it.
    more: Vec<Failure>,
}

impl Failure {
    /// Returns a failure of `place`, which is a file, an option or a directory.
    pub fn of(place: impl fmt::Display, what: impl fmt::Display) -> Self {
        Failure { message: format!("{place}: {what}"), code: REFUSED, more: Vec::new() }
    }

    /// Returns a failure at a line of a file, counted from 1.
    pub fn at(file: &str, line: usize, what: impl fmt::Display) -> Self {
        Failure::of(format_args!("{file}:{line}"), what)
    }

    /// Returns failures as one, with a line for each, or `None` if there is none.
    pub fn all(failures: Vec<Failure>) -> Option<Self> {
        let mut failures = failures.into_iter();
        let first = failures.next()?;
        Some(Failure { more: failures.collect(), ..first })
    }

    /// Returns the failure of standard output.
    pub fn of_stdout(error: &io::Error) -> Self {
        let what =
            format!("the output cannot be written ({}); check that its disk is not full", error.kind());
        Failure { code: UNWRITTEN, ..Failure::of("stdout", what) }
    }
}

impl fmt::Display for Failure {
    /// Writes one short line for each failure, whatever file names and cells contain.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let message: Vec<char> = printable(&self.message).chars().collect();
        if message.len() <= LONGEST {
            f.write_str(&String::from_iter(message))?;
        } else {
            let [start, end] =
                [&message[..LONGEST / 2], &message[message.len() - LONGEST / 2..]].map(String::from_iter);
            write!(f, "{start}..{end}")?;
        }
        self.more.iter().try_for_each(|failure| write!(f, "\n{failure}"))
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

/// Returns the beginning of a name, for reports: `most` characters, of which none [`is_unsafe`].
pub fn shown(name: &str, most: usize) -> String {
    // Escapes are longer than what they stand for, so that no more than this is needed.
    let name: String = name.chars().take(most + 1).collect();
    let name = printable(&name);
    if name.chars().count() > most { name.chars().take(most - 1).chain(['…']).collect() } else { name }
}

/// Returns a text with its unsafe characters escaped.
pub fn printable(text: &str) -> String {
    text.chars().map(|c| if is_unsafe(c) { c.escape_default().to_string() } else { c.to_string() }).collect()
}

/// Returns whether a character can disturb what stands around it.
///
/// Controls (C0, DEL and C1) and line separators break lines or command a terminal, and bidirectional
/// controls change the order of what is shown. U+FFFE and U+FFFF are not allowed in XML, and most controls
/// are not either.
pub fn is_unsafe(c: char) -> bool {
    let bidirectional =
        matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{206f}');
    c.is_control() || bidirectional || matches!(c, '\u{2028}' | '\u{2029}' | '\u{fffe}' | '\u{ffff}')
}
