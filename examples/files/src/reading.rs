//! What a file holds.

use crate::refusal::Note;
use crate::unit::{AxisUnit, Unit};
use std::ops::RangeInclusive;

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
    /// What the file, or the user, says of the values. It is `None` if neither does.
    pub unit: Option<Unit>,
    /// The edges in nm of the bands over which the values are averages, one more than values, or `None` if the
    /// values are points of a curve.
    pub edges: Option<Vec<f64>>,
    /// The unit of the axis in the file.
    pub axis: AxisUnit,
    /// The lines of the file where it stands, counted from 1.
    pub lines: RangeInclusive<usize>,
    /// Which column of the file it is, counted from 1, or which row if each row is a spectrum, and of how many.
    pub place: (usize, usize),
    /// Whether it is a row of the file.
    pub is_row: bool,
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
