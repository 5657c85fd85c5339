//! Responsivities from a table, read while compiling.

use crate::grid::{Grid, Layout};
use crate::observer::Observer;
use crate::sensor::calibrate::decimal::decimal;
use crate::spectrum::Power;
use ResponsivityErrorKind as Kind;
use core::fmt;

/// Reads a sensor's responsivities while compiling, from CSV text that [`include_str!`] takes from a file.
///
/// The program then has the weights and not the text, and a wrong table does not build. There is one row for
/// each node of the grid `G`, in order and complete: the wavelength in nm, then `C` columns, separated by
/// commas, semicolons or tabs. The first line may be a heading. Blank lines and lines that begin with `#` do
/// not count. On a grid wider than 1 nm the numbers are averages over the bins.
///
/// # Example
///
/// ```
/// use nanospectra::{Nodes, Observer, Power, sensor::responsivities};
///
/// # const CSV: &str = "nm,blue,red\n400,0.5,0.01\n500,0.25,0.1\n600,0,0.75\n";
/// // const CSV: &str = include_str!("my_chip.csv");
/// static CHIP: Observer<2, 3, Power, Nodes<400, 600>> = responsivities(CSV);
/// assert_eq!(CHIP.weights()[1], [1.0, 10.0, 75.0]); // times the 100 nm of a bin
/// ```
///
/// # Accuracy
/// The f32 nearest to what is written.
///
/// # Cost
/// None at run time. While compiling, 8 channels of 471 rows take 310 thousand steps of evaluation and 0.6 s,
/// of 95 rows 63 thousand. Rustc stops with `long_running_const_eval` at two million: some 24 000 numbers in
/// one static.
///
/// # Panics
/// When the table is wrong, so use it in a `const` or a `static`, where a wrong table ends the build and says
/// where: "line 7: a column is missing". At run time use [`read_responsivities`].
///
/// ```compile_fail
/// # use nanospectra::{Nodes, Observer, Power, sensor::responsivities};
/// static CHIP: Observer<2, 3, Power, Nodes<400, 600>> =
///     responsivities("400,0.5,0.01\n500,0.25\n600,0,0.75\n"); // line 2: a column is missing
/// # fn main() { assert_eq!(CHIP.weights()[1][0], 1.0) }
/// ```
#[must_use]
pub const fn responsivities<const C: usize, const N: usize, G: Grid>(csv: &str) -> Observer<C, N, Power, G> {
    match read_responsivities(csv) {
        Ok(sensor) => sensor,
        Err(error) => panic!("{}", error.message().as_str()),
    }
}

/// Reads responsivities from CSV text that is known only at run time, in the format of [`responsivities`].
///
/// ```
/// # use nanospectra::sensor::{ResponsivityErrorKind, read_responsivities};
/// # use nanospectra::{Nodes, Observer, Power};
/// type Chip = Observer<2, 2, Power, Nodes<400, 500>>;
/// let chip: Chip = read_responsivities("nm;blue;red\n400;0.5;0.01\n500;0.25;0.1")?;
/// assert_eq!(chip.weights()[0], [50.0, 25.0]); // times the 100 nm of a bin
/// let error = read_responsivities::<2, 2, Nodes<400, 500>>("400,0.5,0.01\n500,0.25\n").unwrap_err();
/// assert_eq!((error.line, error.kind), (2, ResponsivityErrorKind::MissingColumn));
/// # Ok::<(), nanospectra::sensor::ResponsivityError>(())
/// ```
///
/// # Errors
/// [`ResponsivityError`], with the line, counted from 1, and what is wrong with it.
pub const fn read_responsivities<const C: usize, const N: usize, G: Grid>(
    csv: &str,
) -> Result<Observer<C, N, Power, G>, ResponsivityError> {
    let mut rows = [[0.0; N]; C];
    let mut text = Text { bytes: csv.as_bytes(), at: 0, line: 1 };
    // A byte order mark is skipped.
    if let [0xef, 0xbb, 0xbf, ..] = text.bytes {
        text.at = 3;
    }
    let (mut n, mut first_line) = (0, true);
    while text.next_row() {
        let nm = text.cell();
        if first_line && nm.is_err() {
            first_line = false;
            text.skip_line();
            continue;
        }
        first_line = false;
        if n >= N {
            return Err(text.error(Kind::TooManyRows));
        }
        let center = Layout::<G, N>::center(n);
        match nm {
            // Nodes that are no whole nanometers are rounded in the text.
            Ok(nm) if (nm - center).abs() <= 4.0 * f32::EPSILON * center => {}
            Ok(_) => return Err(text.error(Kind::AnotherWavelength)),
            Err(kind) => return Err(text.error(kind)),
        }
        let mut c = 0;
        while c < C {
            if !text.separator() {
                return Err(text.error(Kind::MissingColumn));
            }
            match text.cell() {
                Ok(value) => rows[c][n] = value,
                Err(kind) => return Err(text.error(kind)),
            }
            c += 1;
        }
        if text.separator() {
            return Err(text.error(Kind::MoreColumns));
        }
        text.skip_line();
        n += 1;
    }
    if n < N {
        return Err(text.error(Kind::MissingRows));
    }
    Ok(Observer::from_rows(rows))
}

/// A text, and how far it has been read.
struct Text<'a> {
    bytes: &'a [u8],
    at: usize,
    line: u32,
}

impl Text<'_> {
    const fn error(&self, kind: ResponsivityErrorKind) -> ResponsivityError {
        ResponsivityError { line: self.line, kind }
    }

    /// Returns the byte that is there, 0 at the end.
    const fn byte(&self) -> u8 {
        if self.at < self.bytes.len() { self.bytes[self.at] } else { 0 }
    }

    /// Goes to the start of the next row that counts; false at the end.
    const fn next_row(&mut self) -> bool {
        while self.at < self.bytes.len() {
            self.skip_blanks();
            match self.byte() {
                b'#' => self.skip_line(),
                b'\n' | b'\r' => self.skip_line(),
                _ if self.at < self.bytes.len() => return true,
                _ => {}
            }
        }
        false
    }

    const fn skip_blanks(&mut self) {
        while self.at < self.bytes.len() && self.bytes[self.at] == b' ' {
            self.at += 1;
        }
    }

    const fn skip_line(&mut self) {
        while self.at < self.bytes.len() && self.bytes[self.at] != b'\n' {
            self.at += 1;
        }
        if self.at < self.bytes.len() {
            self.at += 1;
            self.line += 1;
        }
    }

    /// Goes past a separator; false at the end of the row.
    const fn separator(&mut self) -> bool {
        let found = matches!(self.byte(), b',' | b';' | b'\t');
        if found {
            self.at += 1;
        }
        found
    }

    /// Reads the number up to the next separator.
    const fn cell(&mut self) -> Result<f32, ResponsivityErrorKind> {
        self.skip_blanks();
        let (number, end) = decimal(self.bytes, self.at);
        self.at = end;
        self.skip_blanks();
        match number {
            Some(_) if !matches!(self.byte(), 0 | b',' | b';' | b'\t' | b'\n' | b'\r') => Err(Kind::NoNumber),
            Some(number) if !number.is_finite() => Err(Kind::TooLarge),
            Some(number) => Ok(number),
            None => Err(Kind::NoNumber),
        }
    }
}

/// What is wrong with a table of responsivities, and where.
///
/// [`read_responsivities`] returns it, with an [example](read_responsivities).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ResponsivityError {
    /// The number of the line, which counts from 1 with comments and blank lines.
    pub line: u32,
    /// What is wrong with this line.
    pub kind: ResponsivityErrorKind,
}

/// What can be wrong with a line of a table of responsivities.
///
/// See the [example](read_responsivities) of [`read_responsivities`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum ResponsivityErrorKind {
    /// A cell is not a number with a decimal point.
    NoNumber,
    /// A number is beyond the range of f32.
    TooLarge,
    /// The wavelength is not that of the grid's next node.
    AnotherWavelength,
    /// There are fewer columns than channels.
    MissingColumn,
    /// There are more columns than channels.
    MoreColumns,
    /// The table ends before the grid does.
    MissingRows,
    /// The table goes on after the grid's last node.
    TooManyRows,
}

impl ResponsivityErrorKind {
    const fn text(self) -> &'static str {
        match self {
            Kind::NoNumber => "a cell is not a number with a decimal point",
            Kind::TooLarge => "a number is too large",
            Kind::AnotherWavelength => "the wavelength is not the next one of the grid",
            Kind::MissingColumn => "a column is missing",
            Kind::MoreColumns => "there are more columns than channels",
            Kind::MissingRows => "the table ends before the grid does",
            Kind::TooManyRows => "the table has more rows than the grid",
        }
    }
}

/// A line of text without an allocator.
struct Message {
    bytes: [u8; 80],
    length: usize,
}

impl Message {
    const fn with(mut self, text: &str) -> Self {
        let text = text.as_bytes();
        let mut k = 0;
        while k < text.len() && self.length < self.bytes.len() {
            self.bytes[self.length] = text[k];
            self.length += 1;
            k += 1;
        }
        self
    }

    const fn with_number(mut self, number: u32) -> Self {
        let mut power = 1;
        while number / power >= 10 {
            power *= 10;
        }
        while power > 0 && self.length < self.bytes.len() {
            self.bytes[self.length] = b'0' + (number / power % 10) as u8;
            self.length += 1;
            power /= 10;
        }
        self
    }

    const fn as_str(&self) -> &str {
        match core::str::from_utf8(self.bytes.split_at(self.length).0) {
            Ok(text) => text,
            Err(_) => "a wrong table",
        }
    }
}

impl ResponsivityError {
    const fn message(self) -> Message {
        Message { bytes: [0; 80], length: 0 }
            .with("line ")
            .with_number(self.line)
            .with(": ")
            .with(self.kind.text())
    }
}

impl fmt::Display for ResponsivityError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.message().as_str())
    }
}

impl core::error::Error for ResponsivityError {}
