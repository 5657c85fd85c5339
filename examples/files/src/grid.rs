//! Columns of numbers, from whatever kind of file they come.

use std::ops::RangeInclusive;

/// Columns of equal length. Curves are made of them.
#[derive(Clone, Debug, Default)]
pub struct Grid {
    pub columns: Vec<Column>,
    /// The line of each row, counted from 1.
    pub lines: Vec<usize>,
    /// What the file says of the unit of all values.
    pub unit: Option<Said>,
    /// What the file says of the axis.
    pub axis: Option<Said>,
    /// Whether each column was a row of the file.
    pub transposed: bool,
    /// Whether the kind of the file says that the first column is the axis and all others are curves, whatever their
    /// names are.
    pub is_known: bool,
}

/// One column.
#[derive(Clone, Debug, Default)]
pub struct Column {
    pub name: Option<String>,
    /// What a line of units says of it.
    pub unit: Option<Said>,
    /// The values, where NaN stands for one that is missing.
    pub values: Vec<f64>,
    /// The first cell that is neither a number nor missing, with its line.
    pub text: Option<Said>,
    /// How many such cells there are.
    pub texts: usize,
    /// The lines where the column stands, if they are not those of the grid.
    pub lines: Option<RangeInclusive<usize>>,
}

/// A text of the file with its line, counted from 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Said {
    pub text: String,
    pub line: usize,
}

impl Column {
    /// Returns how many values are missing.
    pub fn missing(&self) -> usize {
        self.values.iter().filter(|value| value.is_nan()).count()
    }

    /// Returns whether every value is above the one before it, or every value is below it.
    pub fn is_monotone(&self) -> bool {
        let steps = || self.values.windows(2).map(|pair| pair[1] - pair[0]);
        self.texts == 0
            && self.values.len() > 1
            && (steps().all(|step| step > 0.0) || steps().all(|step| step < 0.0))
    }

    /// Returns whether the values count 0, 1, 2, .. or 1, 2, 3, ..
    pub fn counts(&self) -> bool {
        let first = self.values.first().copied().unwrap_or(f64::NAN);
        (first == 0.0 || first == 1.0) && self.values.windows(2).all(|pair| pair[1] - pair[0] == 1.0)
    }
}
