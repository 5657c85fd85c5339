//! Reads what stands above a table: names, units, and facts about the measurement.

use super::body::{Block, remark};
use super::dialect::{Dialect, Separator, said};
use crate::grid::Said;
use crate::reading::Fact;
use crate::text::lines::Line;
use crate::text::number::{Cell, Decimal, cell};
use crate::unit::{AxisUnit, Unit, names_axis, plain};
use std::borrow::Cow;

/// What the lines above a table say of it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Heading {
    /// The names of the columns.
    pub names: Vec<Said>,
    /// The units of the columns.
    pub units: Vec<Said>,
    /// The unit of all values.
    pub unit: Option<Said>,
    /// The unit of the axis.
    pub axis: Option<Said>,
}

impl Heading {
    /// Returns the lines of the names and of the units, or 0 where there are none.
    pub fn lines(&self) -> [usize; 2] {
        [&self.names, &self.units].map(|cells| cells.first().map_or(0, |cell| cell.line))
    }
}

/// What begins the lines that say what was measured.
const KINDS: [&str; 5] = ["technique", "mode", "measurement", "data type", "spectrum type"];

/// How far above a table its heading may stand, with empty lines between.
const REACH: usize = 4;

/// Reads the heading of a table, whose lines do not reach above `from`.
pub fn read(lines: &[Line], from: usize, block: &Block, dialect: Dialect) -> Heading {
    let mut heading = Heading::default();
    let above = &lines[from..block.lines.start];
    let counts = counts_rows(&lines[block.lines.clone()], dialect);
    let mut looked_at = 0;
    for line in above.iter().rev() {
        let (text, is_remark) = match remark(line.text) {
            Some(text) => (text, true),
            None => (line.text, false),
        };
        if text.trim().is_empty() || said(line.text).is_some() {
            continue;
        }
        looked_at += 1;
        if looked_at > REACH {
            break;
        }
        let cells = match columns(text, line.number, block, counts, dialect, is_remark) {
            Some(cells) => cells,
            None if is_remark => continue,
            None => break,
        };
        let units = cells.iter().filter(|cell| is_unit(&cell.text)).count();
        let filled = cells.iter().filter(|cell| !cell.text.is_empty()).count();
        if heading.units.is_empty()
            && units > 0
            && units == filled
            && !cells.iter().any(|cell| names(&cell.text))
        {
            heading.units = cells;
        } else {
            heading.names = cells;
            break;
        }
    }
    if heading.names.is_empty() {
        // Such a line may stand anywhere among the facts.
        let names =
            above.iter().filter(|line| dialect.first(line.text).is_some_and(|cell| names_names(&cell)));
        let mut cells =
            names.filter_map(|line| columns(line.text, line.number, block, counts, dialect, false));
        heading.names = cells.next_back().unwrap_or_default();
    }
    // What stands in the heading of a column is said of that column alone.
    let of_columns = heading.lines();
    for line in above.iter().filter(|line| !of_columns.contains(&line.number)) {
        general(line, &mut heading);
    }
    heading
}

/// Splits a line into one cell for each column, if it can be a heading.
fn columns(
    text: &str,
    line: usize,
    block: &Block,
    counts: bool,
    dialect: Dialect,
    is_remark: bool,
) -> Option<Vec<Said>> {
    let mut cells = Vec::new();
    dialect.split(text, &mut cells);
    if dialect.separator == Separator::Blanks {
        join_units(&mut cells, block.cells);
    }
    let names_columns = cells.len() <= block.cells && cells.first().is_some_and(|cell| names_names(cell));
    let about_axis = names_columns || cells.iter().any(|cell| names_axis(cell));
    let numbers = cells.iter().filter(|text| matches!(cell(text, dialect.decimal), Cell::Number(_))).count();
    if cells.len() < 2 || (numbers > 0 && !about_axis) || (is_remark && !about_axis) {
        return None;
    }
    let missing = block.cells as isize - cells.len() as isize;
    let mut cells: Vec<Said> = cells.iter().map(|cell| Said { text: cell.to_string(), line }).collect();
    match missing {
        // R leaves the heading of the row names away.
        1 if block.first.texts > 0
            || counts
            || block.first.first == 0 && about_axis && !names_axis(&cells[0].text) =>
        {
            cells.insert(0, Said { text: String::new(), line });
        }
        0 => {}
        _ if missing > 0 && about_axis => {}
        _ if missing < 0 && about_axis && dialect.separator != Separator::Blanks => {}
        _ => return None,
    }
    cells.resize(block.cells, Said { text: String::new(), line });
    Some(cells)
}

/// Returns whether the first cells of the rows count 0, 1, .. or 1, 2, ..
fn counts_rows(lines: &[Line], dialect: Dialect) -> bool {
    let first = |line: &Line| dialect.first(line.text).and_then(|cell| cell.parse::<u64>().ok());
    let mut firsts =
        lines.iter().filter(|line| remark(line.text).is_none() && !line.text.trim().is_empty()).map(first);
    matches!((firsts.next(), firsts.next()), (Some(Some(a @ (0 | 1))), Some(Some(b))) if b == a + 1)
}

/// Joins the units of a heading such as `Wavelength (nm) Flux (W/nm)` to the names before them.
fn join_units(cells: &mut Vec<Cow<str>>, wanted: usize) {
    let mut place = 1;
    while cells.len() > wanted && place < cells.len() {
        if cells[place].starts_with(['(', '[']) {
            let unit = cells.remove(place);
            let name = cells[place - 1].to_mut();
            name.push(' ');
            name.push_str(&unit);
        } else {
            place += 1;
        }
    }
}

/// Returns whether the first cell of a line says that the names of the spectra follow.
fn names_names(cell: &str) -> bool {
    matches!(
        plain(cell).trim_end_matches(':'),
        "name" | "names" | "data name" | "sample" | "samples" | "sample name" | "title"
    )
}

/// Returns whether a cell is a unit and nothing else. A letter without brackets is more often a name.
fn is_unit(text: &str) -> bool {
    let bare = text.trim_matches(['[', ']', '(', ')', ' ']);
    if text.chars().count() == 1 && text != "%" {
        return false;
    }
    AxisUnit::parse(bare).is_some() || Unit::parse(bare).is_some() || plain(text) == "%"
}

/// Returns whether a cell names something beside a unit.
fn names(text: &str) -> bool {
    names_axis(text) && !is_unit(text)
}

/// Looks for what is said of all values or of the axis, such as `Y Units: Reflectance (percent)`.
fn general(line: &Line, heading: &mut Heading) {
    let text = remark(line.text).unwrap_or(line.text);
    let low = plain(text);
    let said = || Some(Said { text: text.trim().to_owned(), line: line.number });
    if low.contains("unit") {
        let about = low.split(['=', ':', ',', ';', '\t']).next().unwrap_or("");
        let value = text.split_once(['=', ':', ',', ';', '\t']).map_or("", |(_, value)| value);
        if (about.contains('x') || about.contains("wave") || names_axis(value)) && !about.contains('y') {
            heading.axis = heading.axis.take().or_else(said);
        } else if Unit::in_heading(value).is_some() {
            heading.unit = heading.unit.take().or_else(said);
        }
    } else if KINDS.iter().any(|word| low.starts_with(word)) {
        // `Technique, Absorbance` says what all values are.
        let value = text.split_once(['=', ':', ',', ';', '\t']).map_or("", |(_, value)| value);
        if Unit::parse(value.trim_matches([' ', ',', ';', '"'])).is_some_and(|unit| unit.is_ratio()) {
            heading.unit = heading.unit.take().or_else(said);
        }
    } else if Unit::in_heading(text).is_some_and(|unit| unit.per.is_some()) {
        heading.unit = heading.unit.take().or_else(said);
    }
}

/// Returns the facts that lines state as a name and a value, without the lines of a heading.
pub fn facts(lines: &[Line], heading: [usize; 2]) -> Vec<Fact> {
    let mut facts = Vec::new();
    for line in lines.iter().filter(|line| !heading.contains(&line.number)) {
        let text = remark(line.text).unwrap_or(line.text).trim();
        let Some((name, value)) = text.split_once(['\t', '=', ';', ',']).or_else(|| text.split_once(':'))
        else {
            continue;
        };
        let (name, value) =
            (name.trim_matches([' ', '"', ':']), value.trim_matches([' ', '"', ',', ';', '\t']));
        let is_word = |text: &str| matches!(cell(text, Decimal::Point), Cell::Text(_));
        let is_name = name.contains(char::is_alphabetic) && is_word(name);
        if is_name && cell(value, Decimal::Point) != Cell::Missing && name.len() <= 60 && value.len() <= 200 {
            facts.push(Fact { line: line.number, name: name.to_owned(), value: value.to_owned() });
        }
    }
    facts
}
