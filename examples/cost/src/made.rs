//! The files in the repository that are made from the record.

use crate::{picture, readme};
use nanospectra_cli::failure::Failure;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};

/// The pictures of the guide. README.md shows them too.
const CHAIN: &str = "src/guide/chain.svg";
const FRONTIER: &str = "src/guide/frontier.svg";
const README: &str = "README.md";

/// Each file, and its text as it should be.
pub type Made = [(&'static str, String); 3];

/// From the repository's root.
pub fn in_repository(path: &str) -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join(path)
}

/// What the record makes of them.
pub fn of(record: &Value) -> Result<Made, Failure> {
    let readme = read(README)?;
    Ok([
        (CHAIN, picture::chain::chain()),
        (FRONTIER, picture::frontier::frontier(record)),
        (README, readme::rewritten(&readme, record)?),
    ])
}

pub fn save(made: &Made) -> Result<(), Failure> {
    made.iter().try_for_each(|(path, text)| write(&in_repository(path), text))
}

/// One line for each file that is not as it should be.
pub fn stale(made: &Made) -> Result<Vec<String>, Failure> {
    let mut stale = Vec::new();
    for (path, text) in made {
        if read(path)? != *text {
            stale.push(format!("{path}: not what the record makes of it; run with --readme"));
        }
    }
    Ok(stale)
}

fn read(path: &str) -> Result<String, Failure> {
    fs::read_to_string(in_repository(path))
        .map_err(|error| Failure::of(path, format_args!("cannot be read ({}); restore it", error.kind())))
}

pub fn write(path: &Path, text: &str) -> Result<(), Failure> {
    fs::write(path, text).map_err(|error| {
        Failure::of(path.display(), format_args!("cannot be written ({}); name another place", error.kind()))
    })
}
