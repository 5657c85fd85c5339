//! Reads a text line by line, as often as it is needed, without holding all of it in memory.
//!
//! A file is read again from its beginning. What can be read only once, such as a pipe, is copied first: into
//! memory if it is short, and else into a temporary file.

use super::lines::is_row;
use super::text::{BYTE_ORDER_MARK, not_utf8, unreadable, wrong_start};
use crate::failure::Failure;
use crate::output::Spool;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Seek};
use std::path::Path;
use std::str;

/// A text in UTF-8, with or without a byte order mark.
pub struct Stream {
    /// The name that messages use for it.
    pub file: String,
    bytes: Bytes,
}

enum Bytes {
    Memory(Vec<u8>),
    Disk {
        file: File,
        /// How much of the file is read. What a program adds to it meanwhile is left alone.
        length: u64,
    },
}

/// The lines of a text that are neither empty nor comments.
pub struct Rows<'a> {
    stream: &'a Stream,
    reader: Box<dyn BufRead + 'a>,
    line: String,
    number: usize,
}

impl Stream {
    /// Opens a file, or standard input for `-`, and checks that it is text.
    pub fn open(path: &Path) -> Result<Self, Failure> {
        let stdin = path.as_os_str() == "-";
        let file = if stdin { "stdin".into() } else { path.to_string_lossy().into_owned() };
        let bytes = if stdin {
            copy(&file, io::stdin().lock())?
        } else if path.is_dir() {
            return Err(Failure::of(file, "this is a directory; name the files in it"));
        } else {
            let opened = File::open(path).map_err(|error| unreadable(&file, &error))?;
            match opened.metadata() {
                Ok(found) if found.is_file() => Bytes::Disk { file: opened, length: u64::MAX },
                _ => copy(&file, opened)?,
            }
        };
        let mut stream = Stream { file, bytes };
        let checked = stream.check()?;
        if let Bytes::Disk { length, .. } = &mut stream.bytes {
            *length = checked;
        }
        Ok(stream)
    }

    /// Returns a text that comes with the program, where `file` is its name in messages.
    pub fn of(file: &str, text: &str) -> Self {
        Stream { file: file.to_owned(), bytes: Bytes::Memory(text.as_bytes().to_vec()) }
    }

    /// Returns the rows from the beginning. One reader is in use at a time.
    pub fn rows(&self) -> Result<Rows<'_>, Failure> {
        Ok(Rows { stream: self, reader: self.reader()?, line: String::new(), number: 0 })
    }

    fn reader(&self) -> Result<Box<dyn BufRead + '_>, Failure> {
        match &self.bytes {
            Bytes::Memory(bytes) => Ok(Box::new(bytes.as_slice())),
            Bytes::Disk { file, length } => {
                let mut file = file;
                file.rewind().map_err(|error| unreadable(&self.file, &error))?;
                Ok(Box::new(BufReader::with_capacity(1 << 16, file.take(*length))))
            }
        }
    }

    /// Checks that every line is UTF-8, and returns the number of bytes.
    fn check(&self) -> Result<u64, Failure> {
        let mut reader = self.reader()?;
        let mut line = Vec::new();
        let mut length = 0;
        for number in 1.. {
            line.clear();
            let count =
                reader.read_until(b'\n', &mut line).map_err(|error| unreadable(&self.file, &error))?;
            if count == 0 {
                break;
            }
            length += count as u64;
            if number == 1
                && let Some(failure) = wrong_start(&self.file, &line)
            {
                return Err(failure);
            }
            str::from_utf8(&line).map_err(|_| not_utf8(&self.file, number))?;
        }
        Ok(length)
    }
}

/// Copies what can be read only once.
fn copy(file: &str, mut from: impl Read) -> Result<Bytes, Failure> {
    let mut spool = Spool::new();
    let mut buffer = vec![0; 1 << 16];
    loop {
        match from.read(&mut buffer) {
            Ok(0) => break,
            Ok(count) => spool.add(file, &buffer[..count])?,
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(error) => return Err(unreadable(file, &error)),
        }
    }
    Ok(match spool.into_data() {
        tempfile::SpooledData::InMemory(cursor) => Bytes::Memory(cursor.into_inner()),
        tempfile::SpooledData::OnDisk(file) => Bytes::Disk { file, length: u64::MAX },
    })
}

impl Rows<'_> {
    /// Returns the next row without its line end, and its number, counted from 1.
    pub fn next(&mut self) -> Result<Option<(&str, usize)>, Failure> {
        loop {
            self.line.clear();
            let count = self
                .reader
                .read_line(&mut self.line)
                .map_err(|error| unreadable(&self.stream.file, &error))?;
            if count == 0 {
                return Ok(None);
            }
            self.number += 1;
            if self.line.ends_with('\n') {
                self.line.pop();
                if self.line.ends_with('\r') {
                    self.line.pop();
                }
            }
            let start = if self.number == 1 && self.line.as_bytes().starts_with(BYTE_ORDER_MARK) {
                BYTE_ORDER_MARK.len()
            } else {
                0
            };
            if is_row(&self.line[start..]) {
                return Ok(Some((&self.line[start..], self.number)));
            }
        }
    }
}
