//! What a user says of a file.

use crate::unit::{AxisUnit, Unit};

/// A column that a user names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Choice {
    /// Its place, counted from 1, where 1 is the first column of the file.
    Number(usize),
    /// Its name in the heading.
    Name(String),
}

/// What a user says of a file, where the file does not say it or says something else.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    /// The columns to read as curves; all if there is none.
    pub columns: Vec<Choice>,
    /// The column of the axis.
    pub axis_column: Option<Choice>,
    /// The unit of the values.
    pub unit: Option<Unit>,
    /// The unit of the axis.
    pub axis: Option<AxisUnit>,
    /// Whether the values are shares of light, such as a reflectance, and not light.
    pub is_ratio: bool,
    /// Whether the values are such shares in percent.
    pub percent: bool,
    /// A number that stands for a value that is missing.
    pub missing: Option<f64>,
}
