//! Reads the text of a file or of standard input.

use crate::failure::Failure;
use std::fs;
use std::io::{self, ErrorKind, Read};
use std::path::{Path, PathBuf};

pub const BYTE_ORDER_MARK: &[u8] = "\u{feff}".as_bytes();

/// Returns the name that messages use for a file, and the file's text.
///
/// The text is UTF-8 with or without a byte order mark. The path `-` is standard input.
pub fn read(path: &Path) -> Result<(String, String), Failure> {
    let (file, bytes) = read_bytes(path)?;
    let text = text(&file, bytes)?;
    Ok((file, text))
}

/// Returns the name that messages use for a file, and what the file holds. The path `-` is standard input.
pub fn read_bytes(path: &Path) -> Result<(String, Vec<u8>), Failure> {
    let stdin = path.as_os_str() == "-";
    let file = if stdin { "stdin".into() } else { path.to_string_lossy().into_owned() };
    let mut bytes = Vec::new();
    let read = if stdin {
        io::stdin().lock().read_to_end(&mut bytes).map(|_| bytes)
    } else if path.is_dir() {
        return Err(Failure::of(file, "this is a directory; name the files in it"));
    } else {
        fs::read(path)
    };
    match read {
        Ok(bytes) => Ok((file, bytes)),
        Err(error) => Err(unreadable(&file, &error)),
    }
}

fn text(file: &str, mut bytes: Vec<u8>) -> Result<String, Failure> {
    if let Some(failure) = wrong_start(file, &bytes) {
        return Err(failure);
    }
    if bytes.starts_with(BYTE_ORDER_MARK) {
        bytes.drain(..BYTE_ORDER_MARK.len());
    }
    String::from_utf8(bytes).map_err(|error| {
        let before = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        not_utf8(file, before.iter().filter(|byte| **byte == b'\n').count() + 1)
    })
}

/// Returns the failure of a file that cannot be read.
pub fn unreadable(file: &str, error: &io::Error) -> Failure {
    let what = match error.kind() {
        ErrorKind::NotFound => "there is no such file; check the name".into(),
        ErrorKind::PermissionDenied => "the file may not be read; check its permissions".into(),
        other => format!("the file cannot be read ({other}); check it"),
    };
    Failure::of(file, what)
}

/// Returns the failure of a text whose first bytes show that it is UTF-16.
pub fn wrong_start(file: &str, bytes: &[u8]) -> Option<Failure> {
    let marks = [[0xff, 0xfe], [0xfe, 0xff]];
    let is_utf16 = marks.iter().any(|mark| bytes.starts_with(mark));
    is_utf16.then(|| Failure::at(file, 1, "the text is UTF-16; save it as UTF-8"))
}

/// Returns the failure of a file that is not text.
pub fn not_utf8(file: &str, line: usize) -> Failure {
    let what = "the file is not text in UTF-8; save it as UTF-8, or name another file if it is binary";
    Failure::at(file, line, what)
}

/// Returns a failure if more than one input is standard input.
pub fn check_stdin<'a>(inputs: impl IntoIterator<Item = &'a PathBuf>) -> Result<(), Failure> {
    if inputs.into_iter().filter(|path| path.as_os_str() == "-").count() > 1 {
        return Err(Failure::of("-", "standard input can be read only once; save it to a file first"));
    }
    Ok(())
}

/// Returns the name of a file without its folder and its extension.
pub fn stem(path: &Path) -> Option<String> {
    path.file_stem().map(|stem| stem.to_string_lossy().into_owned())
}
