#![doc = include_str!("../README.md")]

mod curves;
mod formats;
mod grid;
mod layout;
mod options;
mod reading;
mod refusal;
mod table;
mod text;
mod unit;

pub use options::{Choice, Options};
pub use reading::{By, Curve, Fact, Part, Reading};
pub use refusal::{Kind, Note, Refusal, Setting};
pub use unit::{AxisUnit, Quantity, Unit};

use formats::Contents;
use grid::Grid;
use std::collections::HashSet;
use text::encoding::{self, Encoding};

/// Reads the spectra of a file.
///
/// # Errors
/// The file holds no spectrum, or it leaves a question open that only the user can answer; the refusal says which
/// option does.
pub fn read(bytes: &[u8], options: &Options) -> Result<Reading, Refusal> {
    let contents = contents(bytes)?;
    let mut reading = Reading { facts: contents.facts, notes: contents.notes, ..Reading::default() };
    let grids: Vec<Grid> =
        contents.grids.into_iter().flat_map(|grid| layout::arrange(grid, &mut reading.notes)).collect();
    curves::add(&grids, options, &mut reading)?;
    let mut seen = HashSet::new();
    reading.notes.retain(|note| seen.insert(note.what.clone()));
    if reading.curves.is_empty() {
        return Err(Refusal::of("no column holds a spectrum").settled_by(Setting::Column));
    }
    Ok(reading)
}

/// Returns the tables of a file of any kind.
fn contents(bytes: &[u8]) -> Result<Contents, Refusal> {
    #[cfg(feature = "xlsx")]
    if let Some(contents) = formats::xlsx::read(bytes) {
        return contents;
    }
    let (text, encoding) = encoding::decode(bytes)?;
    let mut contents = match formats::read(&text) {
        Some(contents) => contents?,
        None => table::read(&text)?.into(),
    };
    if encoding == Encoding::Windows1252 {
        contents.notes.insert(0, Note::assumed("the text is in Windows-1252, because it is not UTF-8", None));
    }
    Ok(contents)
}
