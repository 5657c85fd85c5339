//! Standard output, which may be a terminal with colors or a pipe that is closed early.

use super::tint;
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

/// Blanks on a background.
pub fn patch([r, g, b]: [u8; 3], width: usize) -> String {
    format!("\x1b[48;2;{r};{g};{b}m{:width$}\x1b[0m", "")
}

/// The code of a color, behind a patch of it if there is `truecolor`.
pub fn swatch(color: [u8; 3], width: usize, truecolor: bool) -> String {
    (if truecolor { patch(color, width) } else { String::new() }) + &tint::hex(color)
}
