//! Reads the text of a file or of standard input.

use crate::failure::Failure;
use std::io::{self, ErrorKind, Read};
use std::path::{Path, PathBuf};
use std::{fs, str};

const BYTE_ORDER_MARK: &[u8] = "\u{feff}".as_bytes();

/// Returns the name that messages use for a file, and the file's text.
///
/// The text is UTF-8 with or without a byte order mark. The path `-` is standard input.
pub fn read(path: &Path) -> Result<(String, String), Failure> {
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
    let text = match read {
        Ok(bytes) => text(&file, &bytes)?,
        Err(error) => {
            let what = match error.kind() {
                ErrorKind::NotFound => "there is no such file; check the name".into(),
                ErrorKind::PermissionDenied => "the file may not be read; check its permissions".into(),
                other => format!("the file cannot be read ({other}); check it"),
            };
            return Err(Failure::of(file, what));
        }
    };
    Ok((file, text))
}

fn text(file: &str, bytes: &[u8]) -> Result<String, Failure> {
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        return Err(Failure::at(file, 1, "the text is UTF-16; save it as UTF-8"));
    }
    let bytes = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(bytes);
    str::from_utf8(bytes).map(str::to_owned).map_err(|error| {
        let before = &bytes[..error.valid_up_to()];
        let line = before.iter().filter(|byte| **byte == b'\n').count() + 1;
        Failure::at(
            file,
            line,
            "the file is not text in UTF-8; save it as UTF-8, or name another file if it is binary",
        )
    })
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
