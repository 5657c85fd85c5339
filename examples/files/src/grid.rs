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
    /// The edges of the bands over which the values are averages, in the unit of the axis: one more than rows.
    pub edges: Option<Vec<f64>>,
    /// Whether the kind of the file says that the first column is the axis and all others are curves, whatever their
    /// names are.
    pub is_known: bool,
}

/// One column.
#[derive(Clone, Debug, Default)]
pub struct Column {
    pub name: Option<String>,
    /// The line of the name.
    pub heading: usize,
    /// What a line of units, or the words in its cells, say of it.
    pub unit: Option<Said>,
    /// Whether its cells have words, which hold for the whole row.
    pub labeled: bool,
    /// The values, where NaN stands for one that is missing.
    pub values: Vec<f64>,
    /// The first cell that is neither a number nor missing, with its line.
    pub text: Option<Said>,
    /// How many such cells there are.
    pub texts: usize,
    /// The different words of such cells, and which of them each row has, as long as there are few.
    pub words: Words,
    /// Where it stands in the file, counted from 1: which column, or which row of a transposed table.
    pub place: usize,
    /// Its line in the file, if it is a row.
    pub line: Option<usize>,
    /// The lines where the column stands, if they are not those of the grid.
    pub lines: Option<RangeInclusive<usize>>,
}

/// The words of a column.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Words {
    pub all: Vec<String>,
    /// The place among all words, for each row; it is 65,535 where a row has none.
    pub rows: Vec<u16>,
}

/// The most different words that are kept of a column.
const MOST_WORDS: usize = 4096;

impl Words {
    /// Adds the word of a row. Nothing is kept once there are too many words.
    pub fn push(&mut self, row: usize, text: &str) {
        if self.all.len() > MOST_WORDS {
            return;
        }
        let last = self
            .rows
            .last()
            .copied()
            .filter(|place| self.all.get(usize::from(*place)).is_some_and(|word| word == text));
        let known = last.or_else(|| self.all.iter().position(|word| word == text).map(|place| place as u16));
        let place = known.unwrap_or_else(|| {
            self.all.push(text.to_owned());
            (self.all.len() - 1) as u16
        });
        self.rows.resize(row, u16::MAX);
        self.rows.push(place);
        if self.all.len() > MOST_WORDS {
            self.rows = Vec::new();
        }
    }

    /// Returns the word of a row.
    pub fn of(&self, row: usize) -> Option<&str> {
        self.all.get(usize::from(*self.rows.get(row)?)).map(String::as_str)
    }
}

/// A text of the file with its line, counted from 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Said {
    pub text: String,
    pub line: usize,
}

impl Column {
    /// Returns a column of the same name and place that has other values.
    pub fn with(&self, values: Vec<f64>) -> Self {
        Column {
            name: self.name.clone(),
            heading: self.heading,
            unit: self.unit.clone(),
            labeled: self.labeled,
            values,
            text: self.text.clone(),
            texts: self.texts,
            words: Words::default(),
            place: self.place,
            line: self.line,
            lines: self.lines.clone(),
        }
    }

    /// Returns how messages name the column.
    pub fn title(&self) -> String {
        match (&self.name, self.line) {
            (Some(name), _) => quoted(name),
            (None, Some(line)) => format!("the row of line {line}"),
            (None, None) => format!("column {}", self.place),
        }
    }

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

    /// Returns whether the values change in equal steps.
    pub fn is_regular(&self) -> bool {
        let step = self.values.get(1).copied().unwrap_or(f64::NAN) - self.values[0];
        step != 0.0 && self.values.windows(2).all(|pair| ((pair[1] - pair[0]) / step - 1.0).abs() < 1e-3)
    }

    /// Returns whether the values count 0, 1, 2, .. or 1, 2, 3, ..
    pub fn counts(&self) -> bool {
        let first = self.values.first().copied().unwrap_or(f64::NAN);
        (first == 0.0 || first == 1.0) && self.values.windows(2).all(|pair| pair[1] - pair[0] == 1.0)
    }
}

/// Returns a text of the file in quotes, of which a message needs only the beginning.
pub fn quoted(text: &str) -> String {
    const LONGEST: usize = 40;
    let text = text.trim();
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("'{}..'", &text[..end]),
        None => format!("'{text}'"),
    }
}
