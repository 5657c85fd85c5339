//! What a study found: tables of figures that anyone can measure again, beside times that only this machine
//! has.

use std::borrow::Cow;

/// One table of the report.
pub struct Table {
    /// A word for the JSON, the pictures and the checks: `xyz`, `math`.
    pub id: &'static str,
    /// One line above it.
    pub title: String,
    /// What was measured, against what, in a few sentences.
    pub about: String,
    pub columns: Vec<Column>,
    pub rows: Vec<Vec<Cell>>,
}

/// What one number of each row means.
#[derive(Clone)]
pub struct Column {
    /// As the JSON calls it: `mean_de2000`, `m4f_instructions`.
    pub id: Cow<'static, str>,
    /// As the table is headed.
    pub heading: Cow<'static, str>,
    pub kind: Kind,
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Names the choice; all keys together are different in every row.
    Key,
    /// Measured; the same on every machine: an error, a count of instructions or of bytes. Less is better.
    Figure,
    /// Nanoseconds here and now: shown, and never compared.
    Time,
}

pub enum Cell {
    Key(String),
    Figure(f64),
    Time(f64),
    /// Not measured, or there is no such thing.
    Nothing,
}

impl Column {
    const fn of(id: &'static str, heading: &'static str, kind: Kind) -> Self {
        Column { id: Cow::Borrowed(id), heading: Cow::Borrowed(heading), kind }
    }

    pub const fn key(id: &'static str, heading: &'static str) -> Self {
        Column::of(id, heading, Kind::Key)
    }

    pub const fn figure(id: &'static str, heading: &'static str) -> Self {
        Column::of(id, heading, Kind::Figure)
    }

    pub const fn time(id: &'static str, heading: &'static str) -> Self {
        Column::of(id, heading, Kind::Time)
    }
}

impl Cell {
    pub fn key(name: impl ToString) -> Self {
        Cell::Key(name.to_string())
    }

    /// To the four digits that a report shows and a check compares.
    pub fn figure(value: f64) -> Self {
        Cell::Figure(rounded(value))
    }

    /// A count, of which all digits are kept.
    pub fn count(value: Option<u32>) -> Self {
        value.map_or(Cell::Nothing, |count| Cell::Figure(f64::from(count)))
    }

    pub fn time(nanoseconds: f64) -> Self {
        Cell::Time(nanoseconds)
    }
}

fn rounded(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}
