//! Compares the color difference that leaving out an effect makes with what the effect costs.

mod bands;
mod films;
mod others;
mod scenes;

use crate::report::Table;

pub fn tables(runs: usize) -> Vec<Table> {
    vec![scenes::table(), bands::table(), others::table(), films::table(runs)]
}
