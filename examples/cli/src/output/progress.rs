//! A count on stderr while many spectra are measured; silent when nobody watches or it is quick.

use std::io::{self, IsTerminal, Write};
use std::time::{Duration, Instant};

const PATIENCE: Duration = Duration::from_millis(500);
const PAUSE: Duration = Duration::from_millis(100);

pub struct Progress {
    done: usize,
    all: usize,
    /// When to say something next; never if stderr is not a terminal.
    next: Option<Instant>,
    spoke: bool,
}

impl Progress {
    /// Of `all` spectra none is done.
    pub fn of(all: usize) -> Self {
        let next = io::stderr().is_terminal().then(|| Instant::now() + PATIENCE);
        Progress { done: 0, all, next, spoke: false }
    }

    /// One more is begun.
    pub fn step(&mut self) {
        self.done += 1;
        let now = Instant::now();
        if self.next.is_some_and(|next| now >= next) {
            self.next = Some(now + PAUSE);
            self.spoke = true;
            // Progress that cannot be shown is no reason to stop.
            let _ = write!(io::stderr(), "\rspectrum {} of {}", self.done, self.all);
        }
    }
}

impl Drop for Progress {
    /// Takes the line back.
    fn drop(&mut self) {
        if self.spoke {
            let _ = write!(io::stderr(), "\r\x1b[K");
        }
    }
}
