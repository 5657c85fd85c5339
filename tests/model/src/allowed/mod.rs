//! What the library may be off by, against references in f64, and checks by it.
//!
//! Each entry of `tests/data/allowances.txt` is used by one test, which fails when an error is larger than
//! allowed, and also when the largest error is less than half of what is allowed: then the entry claims too
//! little. Within these two, what was measured is on record, and may not grow by more than 2 %.

pub mod record;
mod table;

use crate::check::{Check, EPS};
use std::sync::LazyLock;
use table::Table;

/// The whole table: absolute and relative error by the name of the check.
pub fn all() -> &'static Table {
    static ALL: LazyLock<Table> = LazyLock::new(|| table::read("allowances.txt"));
    &ALL
}

/// A check with the allowance of this name.
pub fn check(what: &'static str) -> Check {
    let [absolute, relative] =
        all().get(what).unwrap_or_else(|| panic!("no entry '{what}' in tests/data/allowances.txt"));
    Check::new(what, *absolute, *relative).held_to(record::hold)
}

/// Numbers as the crate has them, in f32, singly and in triples.
pub trait Singles {
    fn add(&mut self, place: &str, got: f32, expected: f64);

    /// The relative error, in units of rounding.
    fn in_eps(&mut self, place: &str, got: f32, exact: f64);

    fn add_all(&mut self, place: &str, got: [f32; 3], expected: [f64; 3]) {
        got.into_iter().zip(expected).for_each(|(got, expected)| self.add(place, got, expected));
    }
}

impl Singles for Check {
    fn add(&mut self, place: &str, got: f32, expected: f64) {
        self.value(place, f64::from(got), expected);
    }
    fn in_eps(&mut self, place: &str, got: f32, exact: f64) {
        self.value(place, (f64::from(got) - exact).abs() / (exact * EPS), 0.0);
    }
}
