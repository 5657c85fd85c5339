#![doc = include_str!("../README.md")]

mod curves;
mod grid;
mod layout;
mod options;
mod reading;
mod refusal;
mod table;
mod text;
mod unit;

pub use options::{Choice, Options};
pub use reading::{By, Curve, Fact, Reading};
pub use refusal::{Kind, Note, Refusal, Setting};
pub use unit::{AxisUnit, Quantity, Unit};

use grid::Grid;
use std::collections::HashSet;
use text::encoding::{self, Encoding};

/// Reads the spectra of a file.
///
/// # Errors
/// The file holds no spectrum, or it leaves a question open that only the user can answer; the refusal says which
/// option does.
pub fn read(bytes: &[u8], options: &Options) -> Result<Reading, Refusal> {
    let (text, encoding) = encoding::decode(bytes)?;
    let mut reading = Reading::default();
    if encoding == Encoding::Windows1252 {
        reading.notes.push(Note::assumed("the text is in Windows-1252, because it is not UTF-8", None));
    }
    let tables = table::read(&text)?;
    let grids: Vec<Grid> =
        tables.grids.into_iter().flat_map(|grid| layout::arrange(grid, &mut reading.notes)).collect();
    curves::add(&grids, options, &mut reading)?;
    let mut seen = HashSet::new();
    reading.notes.retain(|note| seen.insert(note.what.clone()));
    reading.facts = tables.facts;
    if reading.curves.is_empty() {
        return Err(Refusal::of("no column holds a spectrum").settled_by(Setting::Column));
    }
    Ok(reading)
}
