//! The text of a file or of standard input.

use crate::failure::Failure;
use std::io::{ErrorKind, Read};
use std::path::Path;
use std::{fs, io};

/// What messages call it, and its bytes; `-` is standard input.
pub fn read(path: &Path) -> Result<(String, Vec<u8>), Failure> {
    let stdin = path.as_os_str() == "-";
    let file = if stdin { "stdin".into() } else { path.to_string_lossy().into_owned() };
    let mut bytes = Vec::new();
    let read = if stdin {
        io::stdin().lock().read_to_end(&mut bytes).map(|_| bytes)
    } else if path.is_dir() {
        return Err(Failure::of(file, "is a directory; name the files in it"));
    } else {
        fs::read(path)
    };
    match read {
        Ok(bytes) => Ok((file, bytes)),
        Err(error) => Err(Failure::of(
            file,
            match error.kind() {
                ErrorKind::NotFound => "no such file; check the name".into(),
                ErrorKind::PermissionDenied => "may not be read; check its permissions".into(),
                other => format!("cannot be read ({other}); check the file"),
            },
        )),
    }
}

/// UTF-8 with or without a byte order mark; `file` is its name for messages.
pub fn text<'a>(file: &str, bytes: &'a [u8]) -> Result<&'a str, Failure> {
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        return Err(Failure::at(file, 1, "the text is UTF-16; save it as UTF-8"));
    }
    let bytes = bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes);
    std::str::from_utf8(bytes).map_err(|error| {
        let before = &bytes[..error.valid_up_to()];
        let line = before.iter().filter(|byte| **byte == b'\n').count() + 1;
        Failure::at(file, line, "not UTF-8 text; save it as UTF-8 (or is it a binary file?)")
    })
}
