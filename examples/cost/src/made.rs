//! The files in the repository that are made from the record.

use crate::{docs, picture};
use nanospectra_cli::failure::Failure;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};

/// Where the chart is that the documentation shows.
const CHART: &str = "examples/cost/data/frontier.svg";
/// What has tables of the record, besides the guides.
const README: &str = "README.md";
const GUIDES: &str = "src/guide";

/// Each file, and its text as it should be.
pub type Made = Vec<(String, String)>;

/// From the repository's root.
pub fn in_repository(path: &str) -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join(path)
}

/// What the record makes of them.
pub fn of(record: &Value) -> Result<Made, Failure> {
    let mut made = vec![(CHART.to_owned(), picture::frontier(record))];
    for page in pages()? {
        let text = docs::rewritten(&page, &read(&page)?, record)?;
        made.push((page, text));
    }
    Ok(made)
}

/// README.md and every guide.
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

pub fn save(made: &Made) -> Result<(), Failure> {
    made.iter().try_for_each(|(path, text)| write(&in_repository(path), text))
}

/// One line for each file that is not as it should be.
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

pub fn write(path: &Path, text: &str) -> Result<(), Failure> {
    fs::write(path, text).map_err(|error| {
        Failure::of(path.display(), format_args!("cannot be written ({}); name another place", error.kind()))
    })
}
