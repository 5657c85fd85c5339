//! Collects spectra into grids.

use crate::grid::{Column, Grid, Said};
use crate::reading::Fact;
use crate::refusal::{Note, Setting};
use crate::table::Tables;
use std::ops::RangeInclusive;

/// What a file holds, before its units are looked at.
#[derive(Debug, Default)]
pub struct Contents {
    pub grids: Vec<Grid>,
    pub facts: Vec<Fact>,
    pub notes: Vec<Note>,
    /// The number of spectra that were added.
    count: usize,
}

/// One spectrum of a file.
#[derive(Clone, Debug)]
pub struct Spectrum {
    pub name: Option<String>,
    /// What the axis is, such as `wavelength (nm)`.
    pub axis: String,
    pub places: Vec<f64>,
    /// A value for each place, where NaN stands for one that is missing.
    pub values: Vec<f64>,
    /// What the file says of the values, in words that state a unit.
    pub unit: Option<Said>,
    /// The lines where it stands, counted from 1.
    pub lines: RangeInclusive<usize>,
}

/// The axis of the kinds of files that are always in nm.
pub const NANOMETERS: &str = "wavelength (nm)";

impl From<Tables> for Contents {
    fn from(tables: Tables) -> Self {
        Contents { grids: tables.grids, facts: tables.facts, ..Contents::default() }
    }
}

impl Contents {
    /// Adds a spectrum: as a column beside the one before it if they share their axis.
    pub fn add(&mut self, spectrum: Spectrum) {
        let Spectrum { name, axis, places, values, unit, lines } = spectrum;
        let shared = self.grids.last().is_some_and(|grid| {
            grid.columns[0].name.as_ref() == Some(&axis) && grid.columns[0].values == places
        });
        if !shared {
            let column = Column { name: Some(axis), values: places, ..Column::default() };
            let all = vec![*lines.start(); column.values.len()];
            self.grids.push(Grid { columns: vec![column], lines: all, is_known: true, ..Grid::default() });
        }
        if let Some(grid) = self.grids.last_mut() {
            self.count += 1;
            let place = self.count;
            grid.columns.push(Column { name, unit, values, lines: Some(lines), place, ..Column::default() });
        }
    }

    /// Adds something that the file says, unless it is too long to be of use.
    pub fn fact(&mut self, line: usize, name: &str, value: &str) {
        let (name, value) = (name.trim(), value.trim());
        if !name.is_empty() && !value.is_empty() && name.len() <= 60 && value.len() <= 200 {
            self.facts.push(Fact { line, name: name.to_owned(), value: value.to_owned() });
        }
    }
}

/// A reflectance or transmittance above this is in percent, because no sample returns twice the light that it gets.
pub const TWICE: f64 = 2.0;

/// Returns the largest of all values that are not missing.
pub fn highest<'a>(values: impl IntoIterator<Item = &'a f64>) -> f64 {
    values.into_iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

/// Returns the unit of reflectances or transmittances that reach `high`, and says if they seem to be in percent.
pub fn part(quantity: &str, high: f64, limit: f64, notes: &mut Vec<Note>) -> String {
    if high <= limit {
        return quantity.to_owned();
    }
    notes.push(Note::assumed(
        format!("the {quantity}s are in percent, because they reach {high}"),
        Some(Setting::Percent),
    ));
    format!("{quantity} (percent)")
}
