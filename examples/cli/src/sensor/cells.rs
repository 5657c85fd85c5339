//! Reads CSV with a heading, row by row, into cells that know their lines.
//!
//! Parsing is strict: whatever is not clearly such a table is an error.

use crate::failure::{Failure, short};
use crate::input::lines;
use crate::input::stream::{Rows, Stream};
use csv::StringRecord;
use std::collections::HashMap;
use std::fmt::Display;
use std::path::Path;
use std::rc::Rc;

/// A table of texts, of which the heading is in memory. Its rows are read when they are asked for.
pub struct Table {
    /// The line of the heading, counted from 1.
    pub line: usize,
    /// The names of the columns, in lower case and without blanks around them.
    pub heading: Vec<Rc<str>>,
    places: HashMap<Rc<str>, usize>,
    mark: char,
    text: Stream,
}

pub struct Row {
    pub line: usize,
    /// The cells, as many as the heading has.
    pub cells: StringRecord,
}

impl Table {
    /// Opens the table in a file, or in standard input for `-`, and checks the form of all rows.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        Table::of(Stream::open(path)?)
    }

    /// Opens the table in a text that comes with the program, where `file` is its name in messages.
    pub fn bundled(file: &str, text: &str) -> Result<Self, Failure> {
        Table::of(Stream::of(file, text))
    }

    fn of(text: Stream) -> Result<Self, Failure> {
        let file = &text.file;
        let mut rows = text.rows()?;
        let Some((heading, line)) = rows.next()? else {
            let what = "there is nothing in the file; give a heading and rows of numbers";
            return Err(Failure::at(file, 1, what));
        };
        let at = |what: String| Failure::at(file, line, what);
        let mark = [';', '\t', ','].into_iter().find(|mark| heading.contains(*mark)).unwrap_or(',');
        let heading: Vec<Rc<str>> =
            cells(heading, mark).map_err(at)?.iter().map(|cell| cell.to_lowercase().into()).collect();
        let mut places = HashMap::with_capacity(heading.len());
        for (place, name) in heading.iter().enumerate() {
            if name.is_empty() {
                return Err(at(format!("column {} has no name; give it one, or remove it", place + 1)));
            }
            if places.insert(Rc::clone(name), place).is_some() {
                return Err(at(format!("two columns are called '{}'; rename or remove one", short(name))));
            }
        }
        drop(rows);
        let table = Table { line, heading, places, mark, text };
        let mut count = 0;
        for row in table.rows()? {
            row?;
            count += 1;
        }
        if count == 0 { Err(table.wrong("there is only a heading; add rows of numbers")) } else { Ok(table) }
    }

    /// The name of the file, for messages.
    pub fn file(&self) -> &str {
        &self.text.file
    }

    /// Reads the rows from the first one. One iterator is in use at a time.
    pub fn rows(&self) -> Result<impl Iterator<Item = Result<Row, Failure>>, Failure> {
        let mut rows = self.text.rows()?;
        rows.next()?;
        Ok(std::iter::from_fn(move || self.row(&mut rows).transpose()))
    }

    fn row(&self, rows: &mut Rows) -> Result<Option<Row>, Failure> {
        let Some((text, line)) = rows.next()? else { return Ok(None) };
        let at = |what: String| Failure::at(self.file(), line, what);
        let cells = cells(text, self.mark).map_err(at)?;
        if cells.len() != self.heading.len() {
            let (found, wanted) = (cells.len(), self.heading.len());
            return Err(at(format!(
                "the row has {found} cells, but the heading has {wanted}; complete or correct the row"
            )));
        }
        Ok(Some(Row { line, cells }))
    }

    /// Returns a failure of the table as a whole, at its heading.
    pub fn wrong(&self, what: impl Display) -> Failure {
        Failure::at(self.file(), self.line, what)
    }

    /// Returns a failure at a row.
    pub fn wrong_at(&self, row: &Row, what: impl Display) -> Failure {
        Failure::at(self.file(), row.line, what)
    }

    /// Returns the place of a column, if there is one of this name.
    pub fn place(&self, name: &str) -> Option<usize> {
        self.places.get(name).copied()
    }

    /// Returns the places of columns, all of which must be there.
    pub fn places<S: AsRef<str>>(&self, names: &[S]) -> Result<Vec<usize>, Failure> {
        let wanted = |name: &S| {
            self.place(name.as_ref()).ok_or_else(|| {
                let all = names.iter().map(|name| short(name.as_ref())).collect::<Vec<_>>().join(", ");
                let name = short(name.as_ref());
                self.wrong(format_args!("there is no column '{name}'; name the columns {all}"))
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

fn cells(line: &str, mark: char) -> Result<StringRecord, String> {
    lines::check(line)?;
    if line.contains('"') {
        return Ok(lines::cells(line, mark)?.into());
    }
    // Without quotes every mark is a separator. (Like the crate csv, this leaves out a byte order mark.)
    Ok(line.strip_prefix('\u{feff}').unwrap_or(line).split(mark).map(str::trim).collect())
}
