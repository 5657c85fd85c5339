//! Keeps what is needed later: in memory while it is short, and then in a temporary file.

use crate::failure::Failure;
use crate::output::terminal::{Out, Stop};
use std::io::{Read, Seek, Write};
use tempfile::{SpooledData, SpooledTempFile};

/// The size in bytes above which the text moves to a temporary file.
const IN_MEMORY: usize = 1 << 16;

/// A text that grows at its end. Its temporary file has no name, and is gone when the program ends.
pub struct Spool(SpooledTempFile);

impl Spool {
    pub fn new() -> Self {
        Spool(SpooledTempFile::new(IN_MEMORY))
    }

    /// Adds bytes, where `place` is what they belong to, for messages.
    pub fn add(&mut self, place: &str, bytes: &[u8]) -> Result<(), Failure> {
        self.0.write_all(bytes).map_err(|error| failed(place, &error))
    }

    /// Prints the whole text.
    pub fn print(mut self, out: &mut Out) -> Result<(), Stop> {
        self.0.rewind().map_err(|error| failed("stdout", &error))?;
        let mut buffer = [0; 1 << 14];
        loop {
            match self.0.read(&mut buffer).map_err(|error| failed("stdout", &error))? {
                0 => return Ok(()),
                count => out.write_bytes(&buffer[..count])?,
            }
        }
    }

    /// Returns the text where it is.
    pub fn into_data(self) -> SpooledData {
        self.0.into_inner()
    }
}

fn failed(place: &str, error: &std::io::Error) -> Failure {
    let what = format!("the temporary file for it cannot be used ({}); free some space", error.kind());
    Failure::of(place, what)
}
