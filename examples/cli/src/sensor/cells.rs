//! Reads CSV with a heading into cells that know their lines.
//!
//! Parsing is strict: whatever is not clearly such a table is an error.

use crate::failure::{Failure, short};
use crate::input::{lines, text};
use std::fmt::Display;
use std::path::Path;

/// A table of texts.
pub struct Table {
    /// The name of the file, for messages.
    pub file: String,
    /// The line of the heading, counted from 1.
    pub line: usize,
    /// The names of the columns, in lower case and without blanks around them.
    pub heading: Vec<String>,
    pub rows: Vec<Row>,
}

pub struct Row {
    pub line: usize,
    /// The cells, as many as the heading has.
    pub cells: Vec<String>,
}

/// Reads a table from a file, or from standard input for `-`.
pub fn read(path: &Path) -> Result<Table, Failure> {
    let (file, text) = text::read(path)?;
    parse(&file, &text)
}

/// Parses the table in a text, where `file` is the name of the text in messages.
pub fn parse(file: &str, text: &str) -> Result<Table, Failure> {
    let mut rows_of_text = lines::rows(text);
    let Some((heading, line)) = rows_of_text.next() else {
        return Err(Failure::at(file, 1, "there is nothing in the file; give a heading and rows of numbers"));
    };
    let mark = [';', '\t', ','].into_iter().find(|mark| heading.contains(*mark)).unwrap_or(',');
    let at = |line: usize| move |what: String| Failure::at(file, line, what);
    let heading: Vec<String> =
        cells(heading, mark).map_err(at(line))?.into_iter().map(|cell| cell.to_lowercase()).collect();
    for (place, name) in heading.iter().enumerate() {
        if name.is_empty() {
            return Err(at(line)(format!("column {} has no name; give it one, or remove it", place + 1)));
        }
        if heading[..place].contains(name) {
            return Err(at(line)(format!("two columns are called '{}'; rename or remove one", short(name))));
        }
    }
    let mut rows = Vec::new();
    for (text, line) in rows_of_text {
        let cells = cells(text, mark).map_err(at(line))?;
        if cells.len() != heading.len() {
            let (found, wanted) = (cells.len(), heading.len());
            return Err(at(line)(format!(
                "the row has {found} cells, but the heading has {wanted}; complete or correct the row"
            )));
        }
        rows.push(Row { line, cells });
    }
    if rows.is_empty() {
        return Err(at(line)("there is only a heading; add rows of numbers".into()));
    }
    Ok(Table { file: file.to_owned(), line, heading, rows })
}

fn cells(line: &str, mark: char) -> Result<Vec<String>, String> {
    lines::check(line)?;
    lines::cells(line, mark)
}

impl Table {
    /// Returns a failure of the table as a whole, at its heading.
    pub fn wrong(&self, what: impl Display) -> Failure {
        Failure::at(&self.file, self.line, what)
    }

    /// Returns a failure at a row.
    pub fn wrong_at(&self, row: &Row, what: impl Display) -> Failure {
        Failure::at(&self.file, row.line, what)
    }

    /// Returns the place of a column, if there is one of this name.
    pub fn place(&self, name: &str) -> Option<usize> {
        self.heading.iter().position(|column| column == name)
    }

    /// Returns the places of columns, all of which must be there.
    pub fn places(&self, names: &[&str]) -> Result<Vec<usize>, Failure> {
        let wanted = |name: &&str| {
            self.place(name).ok_or_else(|| {
                let all = names.iter().map(|name| short(name)).collect::<Vec<_>>().join(", ");
                self.wrong(format_args!("there is no column '{}'; name the columns {all}", short(name)))
            })
        };
        names.iter().map(wanted).collect()
    }

    /// Returns the finite number in a cell.
    pub fn number(&self, row: &Row, place: usize) -> Result<f64, Failure> {
        let cell = &row.cells[place];
        let wrong =
            |what: String| self.wrong_at(row, format_args!("'{}' is {what}", short(&self.heading[place])));
        if cell.is_empty() {
            return Err(wrong("empty; fill it in, or remove the row".into()));
        }
        match cell.parse::<f64>() {
            Ok(number) if number.is_finite() && (number as f32).is_finite() => Ok(number),
            Ok(_) => {
                let what = "which is not a finite number; correct it, or remove the row";
                Err(wrong(format!("{}, {what}", short(cell))))
            }
            Err(_) if cell.replacen(',', ".", 1).parse::<f64>().is_ok() => {
                Err(wrong(format!("'{}'; write the decimal point as '.'", short(cell))))
            }
            Err(_) => Err(wrong(format!("'{}', which is not a number; correct it", short(cell)))),
        }
    }
}
