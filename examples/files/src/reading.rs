//! What a file holds.

use crate::grid::quoted;
use crate::refusal::Note;
use crate::unit::{AxisUnit, Unit};
use std::ops::RangeInclusive;
use std::sync::Arc;

/// The curves of a file, and how they were understood.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reading {
    /// The spectra, in the order of the file. There is at least one.
    pub curves: Vec<Curve>,
    /// What the file says beside the spectra, such as the color temperature that an instrument found.
    pub facts: Vec<Fact>,
    /// What was stated, assumed and left out.
    pub notes: Vec<Note>,
}

/// One spectrum.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Its name in the file.
    pub name: Option<String>,
    /// The wavelengths in nm, of which there are at least two, in increasing order.
    pub wavelengths: Vec<f64>,
    /// A finite value for each wavelength, in the unit of the quantity.
    pub values: Vec<f64>,
    /// The line of the file for each sample, counted from 1, or 0 if the file has no lines.
    pub lines: Arc<[usize]>,
    /// What the file, or the user, says of the values. It is `None` if neither does.
    pub unit: Option<Unit>,
    /// Who says it.
    pub unit_by: By,
    /// The edges in nm of the bands over which the values are averages, one more than values, or `None` if the
    /// values are points of a curve.
    pub edges: Option<Vec<f64>>,
    /// The unit of the axis in the file.
    pub axis: AxisUnit,
    /// Which part of the file it is, counted from 1, and of how many.
    pub place: (usize, usize),
    /// What the part is.
    pub part: Part,
}

/// A part of a file that holds one spectrum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// A column of a table.
    Column,
    /// A row of a table.
    Row,
    /// A spectrum of a file that names its spectra.
    Spectrum,
}

/// Who says what something is.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum By {
    /// Nobody does.
    #[default]
    Nobody,
    /// The user, by an option.
    User,
    /// These words of the file.
    File(String),
}

impl Curve {
    /// Returns the first and the last line where it stands, or 0 if the file has no lines.
    #[must_use]
    pub fn line_range(&self) -> RangeInclusive<usize> {
        let first = self.lines.iter().min().copied().unwrap_or(0);
        let last = self.lines.iter().max().copied().unwrap_or(0);
        first..=last
    }

    /// Returns where it was read and what its values are, as `lines 44..444, column 3 of 5, mW/m2/nm by
    /// 'Irradiance (mW/m2/nm)'`.
    #[must_use]
    pub fn origin(&self) -> String {
        let mut origin = String::new();
        let (first, last) = self.line_range().into_inner();
        if first == last && first > 0 {
            origin += &format!("line {first}, ");
        } else if first > 0 {
            origin += &format!("lines {first}..{last}, ");
        }
        let part = match self.part {
            Part::Column => "column",
            Part::Row => "row",
            Part::Spectrum => "spectrum",
        };
        origin += &format!("{part} {} of {}, ", self.place.0, self.place.1);
        if self.axis != AxisUnit::Nanometer {
            origin += &format!("axis in {}, ", self.axis.sign());
        }
        let unit = self.unit.map_or("no unit".into(), |unit| unit.written());
        origin += &unit;
        match &self.unit_by {
            By::Nobody => {}
            By::User => origin += " by the option",
            By::File(text) => origin += &format!(" by {}", quoted(text)),
        }
        origin
    }
}

/// Something that a file says beside its spectra.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fact {
    /// The line, counted from 1.
    pub line: usize,
    /// What is said, such as `CCT(K)`.
    pub name: String,
    /// What it is, such as `4000`.
    pub value: String,
}
