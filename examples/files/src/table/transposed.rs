//! Reads tables whose wavelengths stand beside each other, with one spectrum in each row.

use super::body::{self, Block};
use super::dialect::Dialect;
use super::heading::Heading;
use crate::grid::{Column, Grid, Said};
use crate::text::lines::Line;
use crate::text::number::{Cell, Decimal, cell, labeled, number};
use crate::unit::{AxisUnit, LIKELY, names_axis};

/// The fewest wavelengths that are taken for the axis of a transposed table.
const FEWEST: usize = 6;

/// The heading of a transposed table.
struct Axis {
    /// The line of the wavelengths.
    line: usize,
    /// The first column of them.
    from: usize,
    wavelengths: Vec<f64>,
    /// The words around them.
    said: Option<Said>,
}

/// Reads a block if its wavelengths stand in one row: the line above it, or its first row.
pub fn read(lines: &[Line], block: &Block, heading: &Heading, dialect: Dialect) -> Option<Grid> {
    let mut cells = Vec::new();
    let mut rows = lines[block.lines.clone()].iter().filter(|line| !body::is_comment(line.text));
    let above = heading.names.first().and_then(|cell| lines.get(cell.line - 1));
    if is_upright(lines, block, above, dialect) {
        return None;
    }
    let (axis, skipped) = match above.and_then(|line| Axis::of(line, dialect)) {
        Some(axis) => (axis, 0),
        None => (Axis::of(rows.find(|line| !line.text.trim().is_empty())?, dialect)?, 1),
    };
    let count = axis.wavelengths.len();
    let mut grid = Grid { unit: heading.unit.clone(), transposed: true, ..Grid::default() };
    grid.axis = axis.said.clone().or_else(|| heading.axis.clone());
    grid.lines = vec![axis.line; count];
    grid.columns.push(Column { values: axis.wavelengths.clone(), ..Column::default() });
    let rows = lines[block.lines.clone()].iter().filter(|line| !body::is_comment(line.text));
    for line in rows.filter(|line| !line.text.trim().is_empty()).skip(skipped) {
        dialect.split(line.text, &mut cells);
        // Where the heading of the row names is missing, the rows have one cell more.
        let from = axis.from + usize::from(cells.len() == axis.from + count + 1);
        let name = cells[..from.min(cells.len())].iter().map(AsRef::as_ref).collect::<Vec<&str>>().join(" ");
        let mut column = Column {
            name: Some(name).filter(|name| !name.trim().is_empty()),
            place: grid.columns.len(),
            line: Some(line.number),
            ..Column::default()
        };
        for place in from..from + count {
            column.push(cells.get(place).map_or("", |text| text.as_ref()), line.number, false, dialect);
        }
        grid.columns.push(column);
    }
    (grid.columns.len() > 1).then_some(grid)
}

/// Returns whether the first column is an axis, by its heading and by its numbers.
fn is_upright(lines: &[Line], block: &Block, above: Option<&Line>, dialect: Dialect) -> bool {
    if !above.and_then(|line| dialect.first(line.text)).is_some_and(|cell| names_axis(&cell)) {
        return false;
    }
    let rows = lines[block.lines.clone()].iter().filter(|line| !body::is_comment(line.text));
    let mut cells = Vec::new();
    let mut before = 0.0;
    rows.filter(|line| !line.text.trim().is_empty()).all(|line| {
        dialect.split(line.text, &mut cells);
        let first = cells.first().and_then(|cell| number(cell.trim(), dialect.decimal));
        let rises = first.is_some_and(|first| LIKELY.contains(&first) && first > before);
        before = first.unwrap_or(before);
        rises
    })
}

impl Axis {
    /// Finds the wavelengths of a line: numbers in equal steps, or with the same words around each of them.
    fn of(line: &Line, dialect: Dialect) -> Option<Self> {
        let mut cells = Vec::new();
        dialect.split(body::remark(line.text).unwrap_or(line.text), &mut cells);
        let numbers: Vec<Option<(f64, &str, &str)>> =
            cells.iter().map(|text| wavelength(text, dialect.decimal)).collect();
        let from = (0..numbers.len()).find(|from| is_axis(&numbers[*from..]))?;
        let wavelengths: Vec<f64> = numbers[from..].iter().map_while(|number| Some((*number)?.0)).collect();
        let words =
            numbers[from].map_or("", |(_, before, after)| if after.is_empty() { before } else { after });
        let first = cells[..from].last().map_or("", |cell| cell.as_ref());
        let text = if words.is_empty() { first } else { words };
        let said = (!text.is_empty()).then(|| Said { text: text.to_owned(), line: line.number });
        Some(Axis { line: line.number, from, wavelengths, said })
    }
}

fn wavelength(text: &str, decimal: Decimal) -> Option<(f64, &str, &str)> {
    match cell(text, decimal) {
        Cell::Number(number) => Some((number, "", "")),
        Cell::Missing => None,
        Cell::Text(text) => labeled(text, decimal).map(|label| (label.number, label.before, label.after)),
    }
}

/// Returns whether all of these are wavelengths.
fn is_axis(numbers: &[Option<(f64, &str, &str)>]) -> bool {
    let Some(axis) = numbers.iter().copied().collect::<Option<Vec<_>>>() else { return false };
    if axis.len() < FEWEST || axis.iter().any(|number| (number.1, number.2) != (axis[0].1, axis[0].2)) {
        return false;
    }
    let labeled = !(axis[0].1.is_empty() && axis[0].2.is_empty());
    // Words without a meaning, such as those of `sample 1`, say nothing of wavelengths.
    let is_said = AxisUnit::in_heading(axis[0].1).or(AxisUnit::in_heading(axis[0].2)).is_some();
    if labeled && !is_said && !axis.iter().all(|number| LIKELY.contains(&number.0)) {
        return false;
    }
    let step = axis[1].0 - axis[0].0;
    let equal = |pair: &[(f64, &str, &str)]| ((pair[1].0 - pair[0].0) / step - 1.0).abs() < 0.01;
    let ordered = |pair: &[(f64, &str, &str)]| (pair[1].0 - pair[0].0) * step > 0.0;
    // Numbers that count 1, 2, 3, .. are places.
    let places = axis[0].0 <= 1.0 && step == 1.0;
    // Numbers without a word must be wavelengths in nm, or in um.
    let likely = |number: &(f64, &str, &str)| LIKELY.contains(&number.0) || (0.12..=4.5).contains(&number.0);
    if !labeled && !axis.iter().all(likely) {
        return false;
    }
    step != 0.0 && !places && axis.windows(2).all(|pair| if labeled { ordered(pair) } else { equal(pair) })
}
