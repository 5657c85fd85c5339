//! The elementary functions, and what is made of them in color, by every backend.

mod backends;
mod composites;
mod functions;

use crate::report::Table;

pub fn tables(runs: usize) -> Vec<Table> {
    vec![functions::table(runs), composites::table(runs)]
}
