//! What a study finds: tables of figures that are the same on every machine, and of times that are not.

use std::borrow::Cow;

/// One table of the report.
pub struct Table {
    /// The name of the table in the JSON and in checks, such as `xyz` or `math`.
    pub id: &'static str,
    /// The title in one line.
    pub title: String,
    /// A few sentences that say what was measured, and with what it is compared.
    pub about: String,
    pub columns: Vec<Column>,
    pub rows: Vec<Vec<Cell>>,
}

/// A column of a table: what its cells mean.
#[derive(Clone)]
pub struct Column {
    /// The name in the JSON, such as `mean_de2000` or `m4f_instructions`.
    pub id: Cow<'static, str>,
    /// The heading for readers.
    pub heading: Cow<'static, str>,
    pub kind: Kind,
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A name of the choice. All keys together differ from row to row.
    Key,
    /// An error, a count of instructions or of bytes, which is the same on every machine. Less is better.
    Figure,
    /// Nanoseconds on this machine, which are shown and never compared.
    Time,
}

pub enum Cell {
    Key(String),
    Figure(f64),
    Time(f64),
    /// An empty cell: nothing was measured, or there is nothing to measure.
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

    /// A figure, rounded to the four digits that a report shows and a check compares.
    pub fn figure(value: f64) -> Self {
        Cell::Figure(rounded(value))
    }

    /// A count, which keeps all its digits.
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
