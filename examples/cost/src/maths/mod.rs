//! The elementary functions, and what is made of them in colour, by every backend.

mod backends;
mod composites;
mod functions;

use crate::report::Table;
use crate::studies::Effort;

pub fn tables(effort: &Effort) -> Vec<Table> {
    vec![functions::table(effort), composites::table(effort)]
}
