//! Why a file is not read, and what was assumed of one that is.

use std::fmt;

/// What a user may set to settle a question that a file leaves open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Setting {
    /// Which column is the axis, or which are the curves.
    Column,
    /// The unit of the values.
    Unit,
    /// Whether the values are absorbances, which become shares of light then.
    Absorbance,
    /// Whether the values are per nm or per unit of an axis that is no wavelength.
    Density,
    /// The unit of the axis.
    AxisUnit,
    /// Whether values are in percent.
    Percent,
    /// Which number stands for a value that is missing.
    Missing,
}

/// The reason why a file was not read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// The line where the reason stands, counted from 1, if it is in one.
    pub line: Option<usize>,
    /// What is wrong, and what to do about it in the file.
    pub what: String,
    /// What to set instead.
    pub setting: Option<Setting>,
}

impl Refusal {
    /// Returns a refusal of the whole file.
    pub(crate) fn of(what: impl Into<String>) -> Self {
        Refusal { line: None, what: what.into(), setting: None }
    }

    /// Returns a refusal because of a line.
    pub(crate) fn at(line: usize, what: impl Into<String>) -> Self {
        Refusal { line: Some(line), ..Self::of(what) }
    }

    /// Says what a user may set.
    pub(crate) fn settled_by(self, setting: Setting) -> Self {
        Refusal { setting: Some(setting), ..self }
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(line) = self.line {
            write!(f, "line {line}: ")?;
        }
        f.write_str(&self.what)
    }
}

impl std::error::Error for Refusal {}

/// What a note says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The file says so.
    Stated,
    /// The file does not say it, and it was taken to be so.
    Assumed,
    /// Something in the file was left out.
    LeftOut,
}

/// Something that a user should know of how a file was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// Whether it was stated, assumed or left out.
    pub kind: Kind,
    /// What it is, as a part of a sentence.
    pub what: String,
    /// What to set if it is not right.
    pub setting: Option<Setting>,
}

impl Note {
    pub(crate) fn stated(what: impl Into<String>) -> Self {
        Note { kind: Kind::Stated, what: what.into(), setting: None }
    }

    pub(crate) fn assumed(what: impl Into<String>, setting: Option<Setting>) -> Self {
        Note { kind: Kind::Assumed, what: what.into(), setting }
    }

    pub(crate) fn left_out(what: impl Into<String>) -> Self {
        Note { kind: Kind::LeftOut, what: what.into(), setting: None }
    }
}
