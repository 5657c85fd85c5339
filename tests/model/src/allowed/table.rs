//! Tables of errors by name, as they stand in `tests/data`: a line for each check with two numbers, absolute
//! and relative, and its name.

use std::collections::BTreeMap;
use std::fs;

pub type Table = BTreeMap<String, [f64; 2]>;

/// Where the tables are.
pub const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../data/");

/// Reads a table; panics if a line is no entry, or a name stands there twice.
pub fn read(file: &str) -> Table {
    let text = fs::read_to_string(format!("{FOLDER}{file}"))
        .unwrap_or_else(|error| panic!("tests/data/{file}: {error}"));
    let mut table = Table::new();
    for line in text.lines().filter(|line| !line.is_empty() && !line.starts_with('#')) {
        let mut parts = line.splitn(3, ' ');
        let mut part = || parts.next().unwrap_or_else(|| panic!("tests/data/{file}: not an entry: {line}"));
        let mut number =
            || part().parse().unwrap_or_else(|_| panic!("tests/data/{file}: not a number: {line}"));
        let errors = [number(), number()];
        assert!(table.insert(part().to_string(), errors).is_none(), "tests/data/{file}: twice: {line}");
    }
    table
}
