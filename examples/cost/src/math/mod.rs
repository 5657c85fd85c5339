//! Compares the backends for the elementary functions, and the colors that are computed with them.

mod backends;
mod composites;
mod functions;

use crate::report::Table;

pub fn tables(runs: usize) -> Vec<Table> {
    vec![functions::table(runs), composites::table(runs)]
}
