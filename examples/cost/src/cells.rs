//! The cells and columns that several studies share.

use crate::counts::{Core, instructions};
use crate::report::{Cell, Column};

/// The columns of the instructions on both cores.
pub const COUNTED: [Column; 2] =
    [Column::figure("m4f_instructions", "M4F instr."), Column::figure("m0_instructions", "M0 instr.")];

/// The column of the nanoseconds on this machine.
pub const TIME: Column = Column::time("ns", "ns here");

/// Appends the columns of the instructions on record and of the time, which [`priced`] fills.
pub fn with_price(mut columns: Vec<Column>) -> Vec<Column> {
    columns.extend(COUNTED);
    columns.push(TIME);
    columns
}

/// Appends to a row the instructions that are on record for `what`, and its time on this machine.
pub fn priced(mut row: Vec<Cell>, what: &str, time: f64) -> Vec<Cell> {
    row.extend(counted(what));
    row.push(Cell::time(time));
    row
}

/// The columns of the mean, the 95th percentile and the largest CIEDE2000.
pub const DIFFERENCES: [Column; 3] = [
    Column::figure("mean_de2000", "mean CIEDE2000"),
    Column::figure("p95_de2000", "95 %"),
    Column::figure("max_de2000", "max"),
];

/// The columns of the least, the mean and the largest CIEDE2000, where there are too few for a percentile.
pub const RANGE: [Column; 3] = [
    Column::figure("min_de2000", "CIEDE2000: least"),
    Column::figure("mean_de2000", "mean"),
    Column::figure("max_de2000", "most"),
];

/// The cells of the columns [`COUNTED`]; what is not on record is empty.
pub fn counted(what: &str) -> [Cell; 2] {
    [Core::M4F, Core::M0].map(|core| Cell::count(instructions(core, what)))
}

/// The mean, the 95th percentile and the largest of some sizes; empty if there are none.
pub fn summary(mut sizes: Vec<f64>) -> [Cell; 3] {
    sizes.sort_by(f64::total_cmp);
    [Some(mean(&sizes)), sizes.get(sizes.len() * 95 / 100).copied(), sizes.last().copied()]
        .map(|size| size.filter(|size| size.is_finite()).map_or(Cell::Nothing, Cell::figure))
}

/// A number of bytes with all its digits.
pub fn bytes(count: usize) -> Cell {
    Cell::count(u32::try_from(count).ok())
}

/// The least, the mean and the largest of some sizes; empty if there are none.
pub fn range(sizes: &[f64]) -> [Cell; 3] {
    let least = sizes.iter().copied().min_by(f64::total_cmp);
    let most = sizes.iter().copied().max_by(f64::total_cmp);
    [least, least.map(|_| mean(sizes)), most].map(|size| size.map_or(Cell::Nothing, Cell::figure))
}

/// Sorts rows into the order in which `names` has their first cells; rows of one name keep their order.
pub fn in_order<'a>(rows: &mut [Vec<Cell>], names: impl Iterator<Item = &'a str> + Clone) {
    rows.sort_by_key(|row| match &row[0] {
        Cell::Key(name) => names.clone().position(|known| known == name),
        _ => None,
    });
}

pub fn mean(sizes: &[f64]) -> f64 {
    sizes.iter().sum::<f64>() / sizes.len() as f64
}

/// For each choice (error, cost) the number of other choices that have a smaller error and cost no more.
pub fn beaten(choices: &[(f64, f64)]) -> Vec<Cell> {
    let better = |&(error, cost): &(f64, f64)| {
        choices.iter().filter(|other| other.0 < error && other.1 <= cost).count()
    };
    choices.iter().map(|choice| Cell::count(u32::try_from(better(choice)).ok())).collect()
}
