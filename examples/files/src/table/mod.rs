//! Reads tables of text, with whatever stands above and below them.

mod body;
mod dialect;
mod heading;
mod transposed;

use crate::grid::{Column, Grid, Said};
use crate::reading::Fact;
use crate::refusal::Refusal;
use crate::text::lines::{Line, lines};
use crate::text::number::{Cell, cell};
use body::Block;
use dialect::{Dialect, Separator};
use heading::Heading;

/// The tables of a text, and the facts above and below them.
#[derive(Debug, Default)]
pub struct Tables {
    pub grids: Vec<Grid>,
    pub facts: Vec<Fact>,
}

/// Reads the tables of a text.
pub fn read(text: &str) -> Result<Tables, Refusal> {
    let lines: Vec<Line> = lines(text).collect();
    let Some(dialect) = Dialect::find(&lines) else {
        return Err(Refusal::of(
            "there is no row of numbers; a spectrum has a wavelength and a value in each row",
        ));
    };
    let blocks = body::find(&lines, dialect)?;
    let mut tables = Tables::default();
    let mut from = 0;
    for block in &blocks {
        check_commas(&lines[block.lines.clone()], dialect)?;
        let heading = heading::read(&lines, from, block, dialect);
        let of_columns = heading.lines();
        let grid = match transposed::read(&lines, block, &heading, dialect) {
            Some(grid) => grid,
            None => columns(&lines[block.lines.clone()], block, heading, dialect),
        };
        tables.grids.push(grid);
        tables.facts.extend(heading::facts(&lines[from..block.lines.start], of_columns));
        from = block.lines.end;
    }
    tables.facts.extend(heading::facts(&lines[from..], [0; 2]));
    Ok(tables)
}

/// Reads the columns of a block.
fn columns(lines: &[Line], block: &Block, heading: Heading, dialect: Dialect) -> Grid {
    let mut columns = vec![Column::default(); block.cells];
    for (column, said) in columns.iter_mut().zip(heading.names) {
        column.heading = said.line;
        column.name = Some(said.text).filter(|text| cell(text, dialect.decimal) != Cell::Missing);
    }
    for (place, column) in columns.iter_mut().enumerate() {
        column.place = place + 1;
    }
    for (column, said) in columns.iter_mut().zip(heading.units) {
        column.unit = Some(said).filter(|said| !said.text.is_empty());
    }
    let mut grid = Grid { columns, unit: heading.unit, axis: heading.axis, ..Grid::default() };
    let mut cells = Vec::new();
    for line in lines.iter().filter(|line| !body::is_comment(line.text)) {
        dialect.split(line.text, &mut cells);
        if cells.is_empty() {
            continue;
        }
        grid.lines.push(line.number);
        for (place, column) in grid.columns.iter_mut().enumerate() {
            let text = cells.get(place).map_or("", |text| text.as_ref());
            column.push(text, line.number, place == 0 && block.first.labeled, dialect);
        }
    }
    grid
}

impl Column {
    fn push(&mut self, text: &str, line: usize, labeled: bool, dialect: Dialect) {
        let said = || Said { text: text.to_owned(), line };
        if labeled && let Some(label) = dialect.wavelength(text) {
            if self.values.is_empty() {
                self.labeled = true;
                self.unit = Some(Said { text: label.said().to_owned(), line });
            }
            self.values.push(label.number);
            return;
        }
        self.values.push(match cell(text, dialect.decimal) {
            Cell::Number(number) => number,
            Cell::Missing => f64::NAN,
            Cell::Text(text) => {
                self.texts += 1;
                self.words.push(self.values.len(), text);
                self.text.get_or_insert_with(said);
                f64::NAN
            }
        });
    }
}

/// Refuses a table where commas are both separators and decimal points: `380,0,604`.
///
/// A number that begins with a zero and has more digits is a fraction whose comma was taken for a separator.
fn check_commas(lines: &[Line], dialect: Dialect) -> Result<(), Refusal> {
    if dialect.separator != Separator::Mark(',') {
        return Ok(());
    }
    let is_digits = |cell: &str| !cell.is_empty() && cell.bytes().all(|byte| byte.is_ascii_digit());
    let rows = || lines.iter().filter(|line| !body::is_comment(line.text) && !line.text.trim().is_empty());
    let all_digits = rows()
        .all(|line| line.text.trim().trim_end_matches(',').split(',').all(|cell| is_digits(cell.trim())));
    let fraction = |line: &&Line| {
        line.text.split(',').skip(1).any(|cell| cell.trim().len() > 1 && cell.trim().starts_with('0'))
    };
    match rows().find(fraction) {
        Some(line) if all_digits => Err(Refusal::at(
            line.number,
            "commas separate the cells and also seem to be the decimal points; save the file with points, or with \
             semicolons between the cells",
        )),
        _ => Ok(()),
    }
}
