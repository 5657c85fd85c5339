//! Finds what separates the cells of a table, and how its decimals are written.

use crate::text::lines::Line;
use crate::text::number::{Cell, Decimal, Labeled, cell, labeled};
use crate::unit::{AxisUnit, Unit};
use std::borrow::Cow;

/// What stands between the cells of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Separator {
    Mark(char),
    Blanks,
}

/// How the rows of a table are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dialect {
    pub separator: Separator,
    pub decimal: Decimal,
}

/// What the cells of a line are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Shape {
    /// How many cells there are, without empty ones at the end.
    pub cells: usize,
    /// The place of the first number.
    pub first: usize,
    pub numbers: usize,
    pub missing: usize,
    pub texts: usize,
    /// Whether the first cell is a wavelength with words around it.
    pub labeled: bool,
}

/// The length in bytes of the longest cell that may be a wavelength with words.
const LONGEST_LABEL: usize = 100;

/// How many lines are looked at.
const LOOKED_AT: usize = 5000;

/// In the order in which they are preferred when they read equally much.
const MARKS: [Separator; 5] = [
    Separator::Mark('\t'),
    Separator::Mark(';'),
    Separator::Mark(','),
    Separator::Mark('|'),
    Separator::Blanks,
];

impl Dialect {
    /// Returns the dialect in which most cells are numbers, or `None` if no line is a row of numbers.
    pub fn find(lines: &[Line]) -> Option<Self> {
        let said = lines.iter().find_map(|line| said(line.text));
        let marks: Vec<Separator> = said.map_or(MARKS.to_vec(), |mark| vec![Separator::Mark(mark)]);
        let all = marks.iter().flat_map(|separator| {
            [Decimal::Point, Decimal::Comma].map(|decimal| Dialect { separator: *separator, decimal })
        });
        let sensible = all.filter(|dialect| {
            *dialect != Dialect { separator: Separator::Mark(','), decimal: Decimal::Comma }
        });
        let mut best: Option<(i64, Dialect)> = None;
        for dialect in sensible {
            let score = dialect.score(lines);
            if score > 0 && best.is_none_or(|(known, _)| score > known) {
                best = Some((score, dialect));
            }
        }
        best.map(|(_, dialect)| dialect)
    }

    fn score(self, lines: &[Line]) -> i64 {
        let mut cells = Vec::new();
        let mut score = 0;
        for line in lines.iter().take(LOOKED_AT) {
            self.split(line.text, &mut cells);
            let shape = self.shape(&cells);
            if shape.is_row() {
                score +=
                    3 * (shape.numbers.min(64) as i64 + i64::from(shape.labeled)) - 2 * shape.texts as i64;
            }
        }
        score
    }

    /// Splits a line into its cells, without blanks around them and without empty ones at the end.
    pub fn split<'a>(self, line: &'a str, cells: &mut Vec<Cow<'a, str>>) {
        cells.clear();
        match self.separator {
            _ if line.contains('"') => quoted(line, self.separator, cells),
            // The rows of tables in Markdown begin with the mark.
            Separator::Mark('|') => {
                let line = line.trim().trim_start_matches('|');
                cells.extend(line.split('|').map(|cell| Cow::Borrowed(cell.trim())));
            }
            Separator::Mark(mark) => cells.extend(line.split(mark).map(|cell| Cow::Borrowed(cell.trim()))),
            Separator::Blanks => cells.extend(line.split_whitespace().map(Cow::Borrowed)),
        }
        while cells.last().is_some_and(|cell| cell.is_empty()) {
            cells.pop();
        }
    }

    /// Returns the first cell of a line.
    pub fn first(self, line: &str) -> Option<String> {
        let mut cells = Vec::new();
        self.split(line, &mut cells);
        cells.first().map(|cell| cell.to_string())
    }

    /// Returns what the cells of a line are.
    pub fn shape(self, cells: &[Cow<str>]) -> Shape {
        let mut shape = Shape { cells: cells.len(), first: usize::MAX, ..Shape::default() };
        for (place, text) in cells.iter().enumerate() {
            match cell(text, self.decimal) {
                Cell::Number(_) => {
                    shape.numbers += 1;
                    shape.first = shape.first.min(place);
                }
                Cell::Missing => shape.missing += 1,
                Cell::Text(text) if place == 0 && self.wavelength(text).is_some() => {
                    shape.labeled = true;
                    shape.first = 0;
                }
                Cell::Text(_) => shape.texts += 1,
            }
        }
        shape
    }

    /// Returns the number of a cell such as `380nm`, `Spectral Data 380[nm]` or `380(mW/m2/nm)`, and the words around
    /// it, if they say something of units.
    pub fn wavelength(self, text: &str) -> Option<Labeled<'_>> {
        // A whole line, which another separator would split.
        if text.len() > LONGEST_LABEL {
            return None;
        }
        let label = labeled(text, self.decimal)?;
        let says = |text: &str| {
            Unit::in_heading(text).is_some() || AxisUnit::in_heading(text).is_some() && !text.contains('/')
        };
        says(label.said()).then_some(label)
    }
}

impl Shape {
    /// Returns whether a line may be a row of a spectrum.
    pub fn is_row(&self) -> bool {
        let values = self.numbers + self.missing;
        if self.labeled { self.numbers >= 1 } else { self.numbers >= 2 || (self.numbers == 1 && values >= 3) }
    }
}

/// Returns the separator that a line such as `sep=;` states for a spreadsheet.
pub fn said(line: &str) -> Option<char> {
    let rest =
        line.trim_matches(['"', ' ']).strip_prefix("sep=").or_else(|| line.trim().strip_prefix("SEP="))?;
    let mut characters = rest.chars();
    characters.next().filter(|_| characters.next().is_none_or(|c| c == '"'))
}

/// Splits a line with quotes by the rules of CSV.
fn quoted<'a>(line: &str, separator: Separator, cells: &mut Vec<Cow<'a, str>>) {
    let delimiter = match separator {
        Separator::Mark(mark) if mark.is_ascii() => mark as u8,
        _ => b' ',
    };
    // CSV wants quotes directly beside the separators, but `nm, "a"` has a blank between them.
    let mut parts: Vec<&str> = line.trim().split('"').collect();
    if separator != Separator::Blanks {
        parts.iter_mut().step_by(2).for_each(|part| *part = part.trim_matches(' '));
    }
    let line = parts.join("\"");
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .delimiter(delimiter)
        .flexible(true)
        .from_reader(line.as_bytes());
    let mut record = csv::StringRecord::new();
    if reader.read_record(&mut record).unwrap_or(false) {
        let is_wanted = |cell: &&str| separator != Separator::Blanks || !cell.trim().is_empty();
        cells.extend(record.iter().filter(is_wanted).map(|cell| Cow::Owned(cell.trim().to_owned())));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::lines::lines;

    fn find(text: &str) -> Option<Dialect> {
        Dialect::find(&lines(text).collect::<Vec<_>>())
    }

    #[test]
    fn dialects_are_found() {
        use Decimal::{Comma, Point};
        for (text, mark, decimal) in [
            ("380,0.5\n381,0.6", Some(','), Point),
            ("380;0,5\n381;0,6", Some(';'), Comma),
            ("380;0.5\n381;0.6", Some(';'), Point),
            ("380\t0,5\n381\t0,6", Some('\t'), Comma),
            ("380 0,5\n381 0,6", None, Comma),
            ("380,5 0,5\n381,5 0,6", None, Comma),
            ("380, 0.5\n381, 0.6", Some(','), Point),
            ("380,\t0.5\n381,\t0.6", Some(','), Point),
            ("380nm\t0.5\n381nm\t0.6", Some('\t'), Point),
            ("sep=;\n380;1\n381;2", Some(';'), Point),
            ("\"1\",380,0.5\n\"2\",381,0.6", Some(','), Point),
            ("380 | 0.5\n381 | 0.6", Some('|'), Point),
        ] {
            let separator = mark.map_or(Separator::Blanks, Separator::Mark);
            assert_eq!(find(text), Some(Dialect { separator, decimal }), "{text}");
        }
        assert_eq!(find("no numbers\nat all"), None);
    }
}
