//! Reads spectra from files, from standard input or from the lamp that comes with the program.

use crate::failure::Failure;
use crate::input::{table, text};
use crate::measure::source::Source;
use std::path::Path;
use std::rc::Rc;

/// The CIE reference spectrum L41, a measured phosphor-converted white LED, whose header names the source.
const LAMP: &str = include_str!("../../data/l41_white_led.csv");

/// The spectra of a file, each of which is made when it is its turn.
pub type Sources = Box<dyn ExactSizeIterator<Item = Source>>;

/// Returns the lamp that is measured if no file is given.
pub fn bundled() -> Result<Sources, Failure> {
    sources("l41_white_led.csv", "l41_white_led", LAMP)
}

/// Returns all spectra of a file, or of standard input for `-`.
pub fn read(path: &Path) -> Result<Sources, Failure> {
    let (file, text) = text::read(path)?;
    let stem = text::stem(Path::new(&file)).unwrap_or_else(|| file.clone());
    sources(&file, &stem, &text)
}

/// Returns the only spectrum of a file, where `option` is the option that names the file.
pub fn read_one(path: &Path, option: &str) -> Result<Source, Failure> {
    let mut sources = read(path)?;
    match (sources.len(), sources.next()) {
        (1, Some(only)) => Ok(only),
        (count, _) => Err(Failure::of(
            path.display(),
            format!(
                "the file has {count} spectra, but {option} takes one; save that one to a file of its own"
            ),
        )),
    }
}

fn sources(file: &str, stem: &str, text: &str) -> Result<Sources, Failure> {
    let table = table::parse(file, text)?;
    let (file, stem): (Rc<str>, _) = (file.into(), stem.to_owned());
    let lines: Rc<[usize]> = table.lines.into();
    let several = table.columns.len() > 1;
    Ok(Box::new(table.columns.into_iter().enumerate().map(move |(k, column)| Source {
        file: Rc::clone(&file),
        name: column.name.unwrap_or_else(|| if several { format!("{stem}:{}", k + 1) } else { stem.clone() }),
        lines: Rc::clone(&lines),
        are_averages: table.are_averages,
        samples: table.wavelengths.iter().copied().zip(column.values).collect(),
    })))
}
