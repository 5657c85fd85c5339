//! Standard output, which may be a terminal with colors or a pipe that is closed early.

use crate::failure::Failure;
use std::env;
use std::io::{self, ErrorKind, IsTerminal, Write};

/// Writes all of it, unless whoever reads the pipe has had enough: `| head`.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::of("stdout", format_args!("cannot be written ({}); free its disk", error.kind())))
        }
        _ => Ok(()),
    }
}

/// Whether standard output is a terminal that wants colors, by <https://no-color.org> and by its own name.
pub fn is_colorful() -> bool {
    io::stdout().is_terminal()
        && env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
        && env::var_os("TERM").is_none_or(|value| value != "dumb")
}
