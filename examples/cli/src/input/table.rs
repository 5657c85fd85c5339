//! Converts text to columns of numbers.
//!
//! Parsing is strict: whatever is not clearly a table of numbers is an error.

use super::{bands, lines, text};
use crate::failure::{Failure, short};
use std::path::Path;

/// A column of wavelengths and the columns beside it.
#[derive(Debug)]
pub struct Table {
    /// The line from which each row was read, counted from 1.
    pub lines: Vec<usize>,
    /// The wavelengths in nm, of which there are at least two, in increasing order.
    pub wavelengths: Vec<f64>,
    /// The columns of values, of which there is at least one.
    pub columns: Vec<Column>,
    /// Whether the values are averages over bands around the wavelengths, as the heading says.
    pub are_averages: bool,
}

/// One column of values.
#[derive(Debug)]
pub struct Column {
    /// The name in the heading, if there is one.
    pub name: Option<String>,
    /// The values, which are finite, one for each wavelength.
    pub values: Vec<f64>,
}

/// The separator between the cells of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Separator {
    Mark(char),
    Blanks,
}

/// Returns the table of a file, or of standard input for `-`, with the name that messages use for it.
fn read(path: &Path) -> Result<(String, Table), Failure> {
    let (file, text) = text::read(path)?;
    let table = parse(&file, &text)?;
    Ok((file, table))
}

/// Returns the pairs (wavelength in nm, value) of a file with one column beside the wavelengths.
pub fn samples(path: &Path) -> Result<Vec<(f32, f32)>, Failure> {
    let (file, table) = read(path)?;
    let [column] = &table.columns[..] else {
        let count = table.columns.len();
        let what = "columns of values where one is wanted; save that one to a file of its own";
        let name =
            table.columns[0].name.as_ref().map_or(String::new(), |name| format!(" ({}, ..)", short(name)));
        return Err(Failure::of(file + &name, format_args!("the file has {count} {what}")));
    };
    if table.are_averages {
        return Ok(bands::steps(&table.wavelengths, &column.values));
    }
    let values = column.values.iter();
    Ok(table.wavelengths.iter().zip(values).map(|(nm, value)| (*nm as f32, *value as f32)).collect())
}

/// Parses the table in a text, where `file` is the name of the text in messages.
pub fn parse(file: &str, text: &str) -> Result<Table, Failure> {
    let rows = lines::rows(text);
    let at = |number: usize| move |what: String| Failure::at(file, number, what);

    let Some((separator, first_row)) = rows.clone().find_map(|(line, number)| {
        let cell = line.trim_start().trim_start_matches('"');
        let cell = cell.split([',', ';', '\t', ' ', '"']).next()?;
        number_in(cell).map(|_| (Separator::of(line), number))
    }) else {
        let line = rows.clone().next().map_or(1, |(_, number)| number);
        let what = "there is no row of numbers; give rows with a wavelength in nm and one or more values";
        return Err(at(line)(what.into()));
    };

    let mut heading: Option<(Vec<String>, usize)> = None;
    let mut table =
        Table { lines: Vec::new(), wavelengths: Vec::new(), columns: Vec::new(), are_averages: false };
    for (line, number) in rows {
        let cells = separator.cells(line).map_err(at(number))?;
        if number < first_row {
            if heading.is_some() {
                let what =
                    "this is neither a heading nor a row of numbers; begin the line with '#' to skip it";
                return Err(at(number)(what.into()));
            }
            check_heading(&cells).map_err(at(number))?;
            table.are_averages = cells.first().is_some_and(|cell| cell.eq_ignore_ascii_case(bands::HEADING));
            heading = Some((cells, number));
            continue;
        }
        if table.lines.is_empty() {
            table.columns = columns(&cells, heading.as_ref()).map_err(at(number))?;
        }
        table.push(&cells, number).map_err(at(number))?;
    }
    match table.lines[..] {
        [only] => Err(at(only)("one sample is not a spectrum; give two or more".into())),
        _ => Ok(table),
    }
}

impl Separator {
    /// Finds the separator of a row of numbers.
    ///
    /// A semicolon takes precedence over a tab, and a tab over a comma, because a comma may be meant as a
    /// decimal point (which is then refused as a number).
    fn of(row: &str) -> Self {
        let bare: String = row.split('"').step_by(2).collect();
        let mark = [';', '\t', ','].into_iter().find(|mark| bare.contains(*mark));
        mark.map_or(Separator::Blanks, Separator::Mark)
    }

    fn cells(self, line: &str) -> Result<Vec<String>, String> {
        lines::check(line)?;
        if line.contains('"') {
            return self.quoted(line);
        }
        Ok(match self {
            Separator::Mark(mark) => line.split(mark).map(|cell| cell.trim().to_owned()).collect(),
            Separator::Blanks => line.split_whitespace().map(str::to_owned).collect(),
        })
    }

    fn quoted(self, line: &str) -> Result<Vec<String>, String> {
        let delimiter = match self {
            Separator::Mark(mark) => mark,
            Separator::Blanks => ' ',
        };
        // CSV requires quotes directly beside the separators, but `nm, "a"` has a blank between them.
        let mut parts: Vec<&str> = line.split('"').collect();
        let last = parts.len() - 1;
        for (k, part) in parts.iter_mut().enumerate().step_by(2) {
            let outside = if delimiter == ' ' { *part } else { part.trim_matches(' ') };
            let apart =
                (k == 0 || outside.starts_with(delimiter)) && (k == last || outside.ends_with(delimiter));
            if !outside.is_empty() && !apart {
                return Err("there is text beside a quoted cell; put the quotes around the whole cell".into());
            }
            *part = outside;
        }
        let mut cells = lines::cells(&parts.join("\""), delimiter)?;
        cells.retain(|cell| self != Separator::Blanks || !cell.is_empty());
        Ok(cells)
    }
}

/// Checks that a first line without a wavelength looks like a heading.
///
/// Otherwise a mistake in the first row of numbers would turn that row into names.
fn check_heading(cells: &[String]) -> Result<(), String> {
    let first = cells.first().map_or("", String::as_str);
    let plain = first.to_lowercase();
    let names_wavelengths = ["nm", "wave", "lambda", "λ", "wl"].iter().any(|word| plain.contains(word));
    let starts_like_number = first.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c));
    let numbers_follow = cells.len() > 1 && cells[1..].iter().all(|cell| number_in(cell).is_some());
    if starts_like_number || (numbers_follow && !names_wavelengths) {
        return Err(format!(
            "'{}' is not a wavelength; correct it, or begin the line with 'nm' if it is a heading",
            short(first)
        ));
    }
    Ok(())
}

/// Returns the columns of the first row, named by the heading.
fn columns(row: &[String], heading: Option<&(Vec<String>, usize)>) -> Result<Vec<Column>, String> {
    if row.len() < 2 {
        let what = "there is no value beside the wavelength; give rows with a wavelength in nm and one or more values";
        return Err(what.into());
    }
    let mut names = vec![None; row.len() - 1];
    if let Some((cells, line)) = heading {
        if cells.len() != row.len() {
            return Err(format!(
                "the row has {}, but the heading in line {line} has {}; \
                 make both agree, with quotes around names that contain a separator",
                count(row.len()),
                cells.len()
            ));
        }
        for (name, cell) in names.iter_mut().zip(&cells[1..]) {
            *name = (!cell.is_empty()).then(|| cell.clone());
        }
    }
    Ok(names.into_iter().map(|name| Column { name, values: Vec::new() }).collect())
}

impl Table {
    fn push(&mut self, cells: &[String], line: usize) -> Result<(), String> {
        if cells.len() > 1 && cells.last().is_some_and(String::is_empty) {
            return Err("the row ends with an empty cell; fill it in, or remove the last separator".into());
        }
        if cells.len() != self.columns.len() + 1 {
            let wanted = self.columns.len() + 1;
            let found = count(cells.len());
            return Err(format!("the row has {found}, but the rows before it have {wanted}; complete it"));
        }
        let nm = number(&cells[0], "the wavelength")?;
        self.check_wavelength(nm)?;
        for (k, (cell, column)) in cells[1..].iter().zip(&mut self.columns).enumerate() {
            let what =
                column.name.as_ref().map_or(format!("cell {}", k + 2), |name| format!("'{}'", short(name)));
            column.values.push(number(cell, &what)?);
        }
        self.wavelengths.push(nm);
        self.lines.push(line);
        Ok(())
    }

    fn check_wavelength(&self, nm: f64) -> Result<(), String> {
        if nm <= 0.0 {
            return Err(format!("{nm} is not a wavelength; give nanometers above 0"));
        }
        let (Some(&before), Some(line)) = (self.wavelengths.last(), self.lines.last()) else {
            return Ok(());
        };
        if nm == before {
            return Err(format!("{nm} nm is in line {line} too; keep one of the two rows"));
        }
        if nm < before {
            return Err(format!("{nm} nm comes after {before} nm; sort the rows by wavelength"));
        }
        if nm as f32 == before as f32 {
            return Err(format!("{nm} nm is too near to {before} nm to tell them apart; use wider steps"));
        }
        Ok(())
    }
}

fn number(cell: &str, what: &str) -> Result<f64, String> {
    if cell.is_empty() {
        return Err(format!("{what} is empty; fill it in (with 0 only if 0 was measured)"));
    }
    let said = short(cell);
    match number_in(cell) {
        Some(number) if number.is_finite() => Ok(number),
        Some(_) => Err(format!("{what} is {said}, which is not a finite number; correct it")),
        None if number_in(&cell.replacen(',', ".", 1)).is_some() => {
            Err(format!("{what} is '{said}'; write the decimal point as '.'"))
        }
        None => Err(format!("{what} is '{said}', which is not a number; correct it")),
    }
}

fn number_in(cell: &str) -> Option<f64> {
    cell.parse().ok()
}

fn count(cells: usize) -> String {
    if cells == 1 { "1 cell".into() } else { format!("{cells} cells") }
}
