//! Defines the options of the command `measure` and their help.

use crate::failure::Failure;
use crate::input::text::check_stdin;
use clap::ValueEnum;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use nanospectra::observer::{self, NamedObserver};
use nanospectra_files::{AxisUnit, Choice, Options, Quantity, Unit};
use std::path::PathBuf;

/// What `--unit absolute` is.
pub const ABSOLUTE: Unit = Unit::of(Quantity::Irradiance, 1.0);

const INPUT: &str = "\
Input:
  A file is what a meter, a spectrometer or a spreadsheet writes: a table of text with a column of
  wavelengths, or a row of them, with any lines above and below. The program finds the separator, the
  decimal point, the encoding, the heading and the units. TM-27 (.spdx), CGATS and Argyll (.sp, .ti3),
  CxF, JCAMP-DX, JSON and .xlsx are read, too.
  What the file states is used, and the report says so. What it does not state is assumed where the
  numbers allow nothing else, and the report says that, too. What is ambiguous, or contradicts an
  option, is refused with the name of the option that settles it. With --strict nothing is assumed:
  the first column is the wavelength in nm and increases, every other column is a spectrum, and
  anything else is refused.
  A file that cannot be read is reported in one line that says where it is, what it is and what to do.
  The others are still measured, and the exit code is 2.
  A heading that begins with 'band-nm' and not with 'nm' says that the values are averages over bands
  around the wavelengths, whose edges lie half way between these. 'paint --csv' prints such a table.
  Spectra without a name are named after their file: FILE, or FILE:1, FILE:2 and so on.
  --light takes the name of a CIE illuminant first; write ./A for a file that is called A.

Conventions:
  Samples are brought to 1 nm and summed over 360..830 nm. Outside its samples a light is zero, and a
  reflectance has the value of the nearest end. Samples at equal steps of 5 to 20 nm are interpolated by
  Sprague's rule and others by straight lines. If some are nearer than 1 nm, each nanometer has the mean
  of the straight lines, so that no line is lost. Averages over bands are constant within each band.
  XYZ has Y = 100 for a relative light and for a perfect white surface. An irradiance has Y in lx, a
  radiance in cd/m2, a flux in lm and an intensity in cd.
  Photons are counted from one wavelength to another, where both ends have half weight: PPFD from 400 to
  700 nm, ePAR to 750, and far red from 700 to 800. R:FR is that of 655..665 and 725..735 nm.
  Peak, centroid and width (FWHM) are those of the samples, with straight lines between them.
  CCT, Duv, CRI and photometry use the CIE 1931 2 degree observer, and TM-30 uses CIE 1964.
  --observer changes XYZ, chromaticity, dominant wavelength, Lab and sRGB.
  Dominant wavelength and excitation purity are measured from the equal-energy white for lights,
  and from the white of the light for reflectances. A complementary wavelength is negative.
  The sRGB color of a light is that of its chromaticity at Y = 100. That of a reflectance is
  adapted from its light to D65 by Bradford's method. Both are clipped to the gamut, with a note.
  --compare reports each spectrum minus the one in FILE. y_ratio is the ratio of the numbers as
  read. spectral_rms is the root mean square difference over 360..830 nm. For lights, both are
  scaled to the same Y first, and the difference is divided by the root mean square of FILE. CIEDE2000
  of two lights is that of their chromaticities at Y = 100, where the light of FILE is the white.";

/// Computes color, color temperature, color rendering and photometric quantities of measured
/// spectra.
#[derive(Debug, Default, clap::Args)]
#[command(after_help = INPUT)]
pub struct Args {
    /// Files with the spectra to measure; '-' is standard input. Without files, the program measures
    /// CIE L41, a white LED
    #[arg(value_name = "FILES")]
    pub files: Vec<PathBuf>,

    /// The observer, by its color-matching functions
    #[arg(long, value_parser = eye(), default_value = observer::ALL[0].name)]
    pub observer: Eye,

    /// A column to measure, by its name in the heading or by its number, where 1 is the first column of
    /// the file. May be given several times; without it all are measured
    #[arg(long, value_name = "NAME|NUMBER")]
    pub column: Vec<String>,

    /// Take the spectra as reflectances of surfaces (shares of 0..1) instead of lights
    #[arg(long)]
    pub reflectance: bool,

    /// The light on the surfaces: a CIE illuminant (D65, A, FL11, LED-B3, FL3.1, E and so on) or a
    /// file with one spectrum [default: D65]
    #[arg(long, value_name = "NAME|FILE")]
    pub light: Option<PathBuf>,

    /// The unit of the numbers, if the file does not say it: relative, absolute (which is W/m2/nm), a
    /// product such as mW/m2/nm, uW/cm2/nm, umol/m2/s/nm, W/m2/sr/nm or W/nm, counts, or absorbance
    #[arg(long, value_parser = unit)]
    pub unit: Option<Unit>,

    /// The unit of the axis, if the file does not say it: nm, um, angstrom, m, cm-1, THz, Hz or eV
    #[arg(long, value_parser = axis)]
    pub wavelength_unit: Option<AxisUnit>,

    /// Take the numbers as percent
    #[arg(long)]
    pub percent: bool,

    /// A number that stands for a value that is missing, such as -999; its rows are left out
    #[arg(long, value_name = "NUMBER", allow_negative_numbers = true)]
    pub missing: Option<f64>,

    /// Scale relative light to this illuminance, in lx
    #[arg(long, value_name = "LX", value_parser = above_zero, conflicts_with_all = ["ppfd", "reflectance"])]
    pub lux: Option<f64>,

    /// Scale relative light to this photon flux density of 400..700 nm, in umol/m2/s
    #[arg(long, value_name = "UMOL", value_parser = above_zero, conflicts_with = "reflectance")]
    pub ppfd: Option<f64>,

    /// Assume nothing: read tables with wavelengths in nm, and refuse anything that is not clear
    #[arg(long, conflicts_with_all = ["column", "wavelength_unit", "percent", "missing"])]
    pub strict: bool,

    /// Stop at the first file that cannot be read, and report nothing
    #[arg(long)]
    pub fail_fast: bool,

    /// The rule that brings the samples to 1 nm
    #[arg(long, value_enum, default_value_t)]
    pub interpolation: Between,

    /// Also report the difference to the spectrum in FILE, which must have only one
    #[arg(long, value_name = "FILE")]
    pub compare: Option<PathBuf>,

    /// Print one JSON object per line, with numbers that are not rounded
    #[arg(long)]
    pub json: bool,

    /// Print a table in CSV, with a row for each spectrum
    #[arg(long, conflicts_with = "json")]
    pub csv: bool,

    /// Also draw each spectrum to DIR/NAME.svg; DIR is made if it is missing. A run that fails leaves no
    /// file behind, and no file is overwritten without --force
    #[arg(long, value_name = "DIR")]
    pub svg: Option<PathBuf>,

    /// Replace pictures that exist already. A link, and a file that is read, are never replaced
    #[arg(long, requires = "svg")]
    pub force: bool,
}

/// The value of `--observer`, which is one of [`observer::ALL`].
#[derive(Clone, Copy, Debug)]
pub struct Eye(pub &'static NamedObserver);

/// The value of `--interpolation`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Between {
    /// Sprague's rule for equal steps of 5 to 20 nm, means of straight lines for finer data, and else
    /// straight lines
    #[default]
    Auto,
    /// Straight lines, read at whole nanometers
    Linear,
    /// Sprague's rule by CIE 167:2005, which needs equal steps
    Sprague,
}

impl Args {
    /// Returns a failure for what is wrong with the command line alone.
    pub fn check(&self) -> Result<(), Failure> {
        if let (true, Some(unit)) = (self.reflectance, self.unit)
            && !unit.is_ratio()
        {
            let what = "a reflectance has no unit; leave out --unit or --reflectance";
            return Err(Failure::of(format_args!("--unit {}", unit.written()), what));
        }
        if let (true, Some(unit)) = (self.strict, self.unit)
            && unit != Unit::RELATIVE
            && unit != ABSOLUTE
        {
            let what =
                "with --strict the unit is relative or absolute; convert the file, or leave out --strict";
            return Err(Failure::of(format_args!("--unit {}", unit.written()), what));
        }
        check_stdin(self.inputs())
    }

    /// Returns what the reader of files is told.
    pub fn options(&self) -> Options {
        let choice = |text: &String| text.parse().map_or_else(|_| Choice::Name(text.clone()), Choice::Number);
        Options {
            columns: self.column.iter().map(choice).collect(),
            unit: self.unit,
            is_ratio: self.reflectance,
            axis: self.wavelength_unit,
            percent: self.percent,
            missing: self.missing,
            ..Options::default()
        }
    }

    /// Returns the files that are read.
    pub fn inputs(&self) -> impl Iterator<Item = &PathBuf> {
        self.files.iter().chain(&self.light).chain(&self.compare)
    }
}

impl Default for Eye {
    fn default() -> Self {
        Eye(&observer::ALL[0])
    }
}

/// Returns a parser that accepts the names of the observers and lists them in the help.
fn eye() -> impl TypedValueParser<Value = Eye> {
    let choices = observer::ALL.iter().map(|observer| PossibleValue::new(observer.name).help(observer.title));
    PossibleValuesParser::new(choices).map(|name| observer::named(&name).map_or_else(Eye::default, Eye))
}

fn unit(text: &str) -> Result<Unit, String> {
    let known = "relative, absolute, mW/m2/nm, uW/cm2/nm, umol/m2/s/nm, W/m2/sr/nm, W/nm, counts, absorbance";
    Unit::parse(text).ok_or_else(|| format!("it is none of {known} and their like"))
}

fn axis(text: &str) -> Result<AxisUnit, String> {
    AxisUnit::parse(text).ok_or_else(|| "it is none of nm, um, angstrom, m, cm-1, THz, Hz, eV".into())
}

fn above_zero(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|number| number.is_finite() && *number > 0.0);
    number.ok_or_else(|| "give a number above zero".into())
}
