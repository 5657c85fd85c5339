//! Builds a report for people from rows of a label and a value, plots and patches of color.

use super::{plot, tint};
use crate::failure::printable;
use nanospectra::{Fine, Power};
use std::fmt::Display;
use std::path::Path;

pub struct Report {
    text: String,
    /// The column in which the values begin.
    indent: usize,
    truecolor: bool,
}

impl Report {
    /// Returns an empty report, with terminal escapes for colors if `truecolor`.
    pub fn new(indent: usize, truecolor: bool) -> Self {
        Report { text: String::new(), indent, truecolor }
    }

    pub fn line(&mut self, line: impl Display) {
        self.text += &format!("{line}\n");
    }

    pub fn row(&mut self, label: &str, value: impl Display) {
        let indent = self.indent;
        self.line(format_args!("  {label:<indent$}{value}"));
    }

    /// Adds a row with the name of a file or of a directory.
    pub fn path(&mut self, label: &str, path: &Path) {
        self.row(label, printable(&path.to_string_lossy()));
    }

    /// Adds the plot of a spectrum and an empty line.
    pub fn plot(&mut self, curve: &Fine<Power>) {
        for line in plot::lines(curve, self.truecolor) {
            self.line(format_args!("  {line}"));
        }
        self.line("");
    }

    /// Returns blanks on a background of this color, or nothing without `truecolor`.
    pub fn patch(&self, [r, g, b]: [u8; 3], width: usize) -> String {
        if self.truecolor { format!("\x1b[48;2;{r};{g};{b}m{:width$}\x1b[0m", "") } else { String::new() }
    }

    /// Returns the code of a color after a patch of it.
    pub fn swatch(&self, color: [u8; 3], width: usize) -> String {
        self.patch(color, width) + &tint::hex(color)
    }

    pub fn into_text(self) -> String {
        self.text
    }
}
