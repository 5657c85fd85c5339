//! The files in the repository that are made from the record.

use crate::{docs, picture};
use nanospectra_cli::failure::Failure;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};

/// The pictures of the guide, which README.md shows too.
const CHAIN: &str = "src/guide/chain.svg";
const FRONTIER: &str = "src/guide/frontier.svg";
/// The pages with tables of the record are the README and every guide.
const README: &str = "README.md";
const GUIDES: &str = "src/guide";

/// The path of each file, and the text that it should have.
pub type Made = Vec<(String, String)>;

/// Where a path from the root of the repository is on this machine.
pub fn in_repository(path: &str) -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join(path)
}

/// Makes the files from the record.
pub fn of(record: &Value) -> Result<Made, Failure> {
    let mut made = vec![
        (CHAIN.to_owned(), picture::chain::chain()),
        (FRONTIER.to_owned(), picture::frontier::frontier(record)),
    ];
    for page in pages()? {
        let text = docs::rewritten(&page, &read(&page)?, record)?;
        made.push((page, text));
    }
    Ok(made)
}

/// Lists README.md and every guide.
fn pages() -> Result<Vec<String>, Failure> {
    let unreadable = |error: std::io::Error| {
        Failure::of(GUIDES, format_args!("cannot be read ({}); restore it", error.kind()))
    };
    let mut pages = vec![README.to_owned()];
    for entry in fs::read_dir(in_repository(GUIDES)).map_err(unreadable)? {
        let name = entry.map_err(unreadable)?.file_name().to_string_lossy().into_owned();
        if name.ends_with(".md") {
            pages.push(format!("{GUIDES}/{name}"));
        }
    }
    pages.sort();
    Ok(pages)
}

/// Writes the files.
pub fn save(made: &Made) -> Result<(), Failure> {
    made.iter().try_for_each(|(path, text)| write(&in_repository(path), text))
}

/// Returns a line for each file that differs from what the record makes of it.
pub fn stale(made: &Made) -> Result<Vec<String>, Failure> {
    let mut stale = Vec::new();
    for (path, text) in made {
        if read(path)? != *text {
            stale.push(format!("{path}: not what the record makes of it; run with --docs"));
        }
    }
    Ok(stale)
}

fn read(path: &str) -> Result<String, Failure> {
    fs::read_to_string(in_repository(path))
        .map_err(|error| Failure::of(path, format_args!("cannot be read ({}); restore it", error.kind())))
}

/// Writes one file.
pub fn write(path: &Path, text: &str) -> Result<(), Failure> {
    fs::write(path, text).map_err(|error| {
        Failure::of(path.display(), format_args!("cannot be written ({}); name another place", error.kind()))
    })
}
