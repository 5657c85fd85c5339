//! Finds the rows of numbers in a text.

use super::dialect::{Dialect, Shape};
use crate::refusal::Refusal;
use crate::text::lines::Line;
use crate::text::number::number;
use crate::unit::names_axis;
use std::ops::Range;

/// Lines that belong to one table: rows of numbers, with comments and empty lines between them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Block {
    /// Their places among the lines of the text.
    pub lines: Range<usize>,
    /// How many of them are rows.
    pub rows: usize,
    /// The most cells that a row has.
    pub cells: usize,
    /// The shape of the first row.
    pub first: Shape,
}

/// What is said of a line that would be lost.
const NO_ROW: &str = "this line stands in a table and is no row of it; correct it or take it out";

/// The fewest rows of a table beside a longer one.
const FEWEST: usize = 5;

/// Returns the tables of a text, of which there is at least one.
pub fn find(lines: &[Line], dialect: Dialect) -> Result<Vec<Block>, Refusal> {
    let mut blocks: Vec<Block> = Vec::new();
    let mut cells = Vec::new();
    // The last block grows until a line is no row.
    let mut open = false;
    for (place, line) in lines.iter().enumerate() {
        if is_comment(line.text) {
            continue;
        }
        dialect.split(line.text, &mut cells);
        if cells.is_empty() {
            continue;
        }
        let shape = dialect.shape(&cells);
        if let Some(block) = blocks.last_mut().filter(|_| open)
            && block.continues(&shape)
        {
            block.lines.end = place + 1;
            block.rows += 1;
            block.cells = block.cells.max(shape.cells);
            continue;
        }
        // A line that looks like the next row and is none would be lost.
        if let Some(block) = blocks.last().filter(|_| open)
            && place == block.lines.end
            && block.rows > 1
            && shape.cells == block.cells
            && shape.texts > 0
            && !shape.is_row()
            && starts_with_number(line.text)
        {
            return Err(Refusal::at(line.number, NO_ROW));
        }
        open = shape.is_row();
        if open {
            blocks.push(Block { lines: place..place + 1, rows: 1, cells: shape.cells, first: shape });
        }
    }
    let Some(longest) = blocks.iter().map(|block| block.rows * block.cells).max() else {
        return Err(Refusal::of(
            "there is no row of numbers; a spectrum has a wavelength and a value in each row",
        ));
    };
    check_gaps(lines, &blocks, longest)?;
    blocks.iter_mut().for_each(|block| block.give_heading_back(lines, dialect));
    blocks.retain(|block| block.rows * block.cells == longest || block.rows >= FEWEST);
    Ok(blocks)
}

/// Refuses a text where a few lines that are no rows tear a table apart, because the rest would be lost.
fn check_gaps(lines: &[Line], blocks: &[Block], longest: usize) -> Result<(), Refusal> {
    for pair in blocks.windows(2) {
        let [above, below] = pair else { continue };
        let between = above.lines.end..below.lines.start;
        let alike = above.first == below.first && (above.rows + below.rows) * above.cells > longest / 2;
        let broken =
            lines[between].iter().find(|line| !line.text.trim().is_empty() && !is_comment(line.text));
        if let Some(broken) = broken
            && alike
            && below.lines.start - above.lines.end < 3
            && starts_with_number(broken.text)
        {
            return Err(Refusal::at(broken.number, NO_ROW));
        }
    }
    Ok(())
}

fn starts_with_number(line: &str) -> bool {
    line.trim_start_matches([' ', '"', '\t'])
        .starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '.'))
}

impl Block {
    /// Takes the first line out of the block if it is a heading whose names are numbers: `wavelength,1,2,3`.
    fn give_heading_back(&mut self, lines: &[Line], dialect: Dialect) {
        let rows = lines[self.lines.clone()].iter().enumerate();
        let mut rows = rows.filter(|(_, line)| !is_comment(line.text) && !line.text.trim().is_empty());
        let (Some((_, first)), Some((second, row))) = (rows.next(), rows.next()) else { return };
        let is_heading = dialect.first(first.text).is_some_and(|cell| names_axis(&cell));
        let starts = dialect.first(row.text).is_some_and(|cell| number(&cell, dialect.decimal).is_some());
        if is_heading && starts {
            let mut cells = Vec::new();
            dialect.split(row.text, &mut cells);
            self.first = dialect.shape(&cells);
            self.lines.start += second;
            self.rows -= 1;
        }
    }

    /// Returns whether a line of this shape is a row of the block.
    fn continues(&self, shape: &Shape) -> bool {
        if self.first.labeled || shape.labeled {
            return self.first.labeled && shape.labeled;
        }
        // A row without its wavelength is a row still, and is found to be wrong later.
        let is_alike = shape.first == self.first.first || (shape.texts == 0 && shape.cells == self.cells);
        let enough = shape.is_row() || (shape.numbers >= 1 && is_alike);
        enough
            && (shape.cells <= self.cells || self.rows < 2)
            && shape.texts <= self.first.texts.max(shape.numbers)
    }
}

/// Returns whether a line is a remark, by its first sign.
pub fn is_comment(line: &str) -> bool {
    remark(line).is_some()
}

/// Returns what a remark says.
pub fn remark(line: &str) -> Option<&str> {
    let line = line.trim_start();
    let rest = line.trim_start_matches(['#', ';', '%', '!', '\'']);
    let is_rule =
        line.len() > 2 && line.chars().all(|c| matches!(c, '|' | '-' | '=' | '_' | ':' | '+' | ' '));
    (rest.len() < line.len() || is_rule).then(|| rest.trim())
}
