//! Files, standard input and the lamp that comes with the program.

use crate::failure::Failure;
use crate::source::Source;
use crate::table;
use std::io::{ErrorKind, Read};
use std::path::Path;
use std::rc::Rc;
use std::{fs, io};

/// CIE reference spectrum L41, a measured phosphor-converted white LED; source in its header.
const LAMP: &str = include_str!("data/l41_white_led.csv");

/// The lamp that is reported on when no file is given.
pub fn bundled() -> Result<Vec<Source>, Failure> {
    sources("l41_white_led.csv", "l41_white_led", LAMP)
}

/// All spectra of a file, or of standard input for `-`.
pub fn read(path: &Path) -> Result<Vec<Source>, Failure> {
    let stdin = path.as_os_str() == "-";
    let file = if stdin { "stdin".into() } else { path.to_string_lossy().into_owned() };
    let bytes = bytes(path, stdin).map_err(|what| Failure::of(&file, what))?;
    let text = text(&bytes).map_err(|(line, what)| Failure::at(&file, line, what))?;
    let stem = Path::new(&file).file_stem().map_or(file.clone(), |stem| stem.to_string_lossy().into_owned());
    sources(&file, &stem, text)
}

/// The one spectrum of a file; `option` is what asked for it.
pub fn read_one(path: &Path, option: &str) -> Result<Source, Failure> {
    let mut sources = read(path)?;
    match (sources.pop(), sources.len()) {
        (Some(only), 0) => Ok(only),
        (_, more) => Err(Failure::of(
            path.display(),
            format!("{} spectra where {option} wants one; save that one to a file of its own", more + 1),
        )),
    }
}

fn bytes(path: &Path, stdin: bool) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    let read = if stdin {
        io::stdin().lock().read_to_end(&mut bytes).map(|_| bytes)
    } else if path.is_dir() {
        return Err("is a directory; name the files in it".into());
    } else {
        fs::read(path)
    };
    read.map_err(|error| match error.kind() {
        ErrorKind::NotFound => "no such file; check the name".into(),
        ErrorKind::PermissionDenied => "may not be read; check its permissions".into(),
        other => format!("cannot be read ({other}); check the file"),
    })
}

/// UTF-8 with or without a byte order mark; the error has a line.
fn text(bytes: &[u8]) -> Result<&str, (usize, &'static str)> {
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        return Err((1, "the text is UTF-16; save it as UTF-8"));
    }
    let bytes = bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes);
    std::str::from_utf8(bytes).map_err(|error| {
        let before = &bytes[..error.valid_up_to()];
        let line = before.iter().filter(|byte| **byte == b'\n').count() + 1;
        (line, "not UTF-8 text; save it as UTF-8 (or is it a binary file?)")
    })
}

fn sources(file: &str, stem: &str, text: &str) -> Result<Vec<Source>, Failure> {
    let table = table::parse(file, text)?;
    let lines: Rc<[usize]> = table.lines.into();
    let several = table.columns.len() > 1;
    let spectra = table.columns.into_iter().zip(1..).map(|(column, k)| Source {
        file: file.to_owned(),
        name: column.name.unwrap_or_else(|| if several { format!("{stem}:{k}") } else { stem.to_owned() }),
        lines: Rc::clone(&lines),
        samples: table.wavelengths.iter().copied().zip(column.values).collect(),
    });
    Ok(spectra.collect())
}
