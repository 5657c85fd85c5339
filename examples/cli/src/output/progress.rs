//! Shows progress on stderr while many spectra are measured.
//!
//! Nothing is shown if stderr is not a terminal, or if the work is done quickly.

use std::io::{self, IsTerminal, Write};
use std::time::{Duration, Instant};

const PATIENCE: Duration = Duration::from_millis(500);
const PAUSE: Duration = Duration::from_millis(100);

pub struct Progress {
    done: usize,
    all: usize,
    /// The time of the next message, which is `None` if stderr is not a terminal.
    next: Option<Instant>,
    spoke: bool,
}

impl Progress {
    /// Starts the count, with none of `all` spectra done.
    pub fn of(all: usize) -> Self {
        let next = io::stderr().is_terminal().then(|| Instant::now() + PATIENCE);
        Progress { done: 0, all, next, spoke: false }
    }

    /// Counts one more spectrum.
    pub fn step(&mut self) {
        self.done += 1;
        let now = Instant::now();
        if self.next.is_some_and(|next| now >= next) {
            self.next = Some(now + PAUSE);
            self.spoke = true;
            // If progress cannot be shown, the work still goes on.
            let _ = write!(io::stderr(), "\rspectrum {} of {}", self.done, self.all);
        }
    }
}

impl Drop for Progress {
    /// Removes the line.
    fn drop(&mut self) {
        if self.spoke {
            let _ = write!(io::stderr(), "\r\x1b[K");
        }
    }
}
