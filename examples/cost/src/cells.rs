//! Cells and columns that several studies have.

use crate::counts::{Core, instructions};
use crate::report::{Cell, Column};

/// Instructions on the two cores.
pub const COUNTED: [Column; 2] =
    [Column::figure("m4f_instructions", "M4F instr."), Column::figure("m0_instructions", "M0 instr.")];

/// Nanoseconds here.
pub const TIME: Column = Column::time("ns", "ns here");

/// With columns for the instructions on record and the time, which [`priced`] fills.
pub fn with_price(mut columns: Vec<Column>) -> Vec<Column> {
    columns.extend(COUNTED);
    columns.push(TIME);
    columns
}

/// A row with the instructions that are on record for `what`, and its time here.
pub fn priced(mut row: Vec<Cell>, what: &str, time: f64) -> Vec<Cell> {
    row.extend(counted(what));
    row.push(Cell::time(time));
    row
}

/// Of CIEDE2000.
pub const DIFFERENCES: [Column; 3] = [
    Column::figure("mean_de2000", "mean CIEDE2000"),
    Column::figure("p95_de2000", "95 %"),
    Column::figure("max_de2000", "max"),
];

/// The same, where there are too few for a percentile.
pub const RANGE: [Column; 3] = [
    Column::figure("min_de2000", "CIEDE2000: least"),
    Column::figure("mean_de2000", "mean"),
    Column::figure("max_de2000", "most"),
];

/// What [`COUNTED`] heads, as far as it is on record.
pub fn counted(what: &str) -> [Cell; 2] {
    [Core::M4F, Core::M0].map(|core| Cell::count(instructions(core, what)))
}

/// Mean, 95th percentile and largest of some sizes; nothing of none.
pub fn summary(mut sizes: Vec<f64>) -> [Cell; 3] {
    sizes.sort_by(f64::total_cmp);
    [Some(mean(&sizes)), sizes.get(sizes.len() * 95 / 100).copied(), sizes.last().copied()]
        .map(|size| size.filter(|size| size.is_finite()).map_or(Cell::Nothing, Cell::figure))
}

/// A number of bytes, to the last.
pub fn bytes(count: usize) -> Cell {
    Cell::count(u32::try_from(count).ok())
}

/// Least, mean and largest of some sizes; nothing of none.
pub fn range(sizes: &[f64]) -> [Cell; 3] {
    let least = sizes.iter().copied().min_by(f64::total_cmp);
    let most = sizes.iter().copied().max_by(f64::total_cmp);
    [least, least.map(|_| mean(sizes)), most].map(|size| size.map_or(Cell::Nothing, Cell::figure))
}

/// Puts rows in the order of the names in their first cells; those of one name stay as they are.
pub fn in_order<'a>(rows: &mut [Vec<Cell>], names: impl Iterator<Item = &'a str> + Clone) {
    rows.sort_by_key(|row| match &row[0] {
        Cell::Key(name) => names.clone().position(|known| known == name),
        _ => None,
    });
}

pub fn mean(sizes: &[f64]) -> f64 {
    sizes.iter().sum::<f64>() / sizes.len() as f64
}

/// The largest; nothing of none.
pub fn largest(sizes: impl IntoIterator<Item = f64>) -> Cell {
    sizes.into_iter().max_by(f64::total_cmp).map_or(Cell::Nothing, Cell::figure)
}

/// Of choices by (error, cost): by how many that cost no more each is beaten, in error.
pub fn beaten(choices: &[(f64, f64)]) -> Vec<Cell> {
    let better = |&(error, cost): &(f64, f64)| {
        choices.iter().filter(|other| other.0 < error && other.1 <= cost).count()
    };
    choices.iter().map(|choice| Cell::count(u32::try_from(better(choice)).ok())).collect()
}
