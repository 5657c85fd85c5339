//! Defines the options of the command `measure` and their help.

use crate::failure::Failure;
use crate::input::text::check_stdin;
use clap::ValueEnum;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use nanospectra::Interpolation;
use nanospectra::observer::{self, NamedObserver};
use std::path::PathBuf;

const INPUT: &str = "\
Input:
  A file is text in UTF-8. Its first column is the wavelength in nm, and every other column is a
  spectrum. Cells are separated by commas, semicolons, tabs or blanks. A line that starts with '#'
  is a comment, and one heading line may name the columns. Wavelengths must increase.
  Nothing is sorted, dropped or guessed. If something is wrong, the program ends with exit code 2
  and one line that says where it is, what it is and what to do. All input is checked before
  anything is printed, so that a report is never cut short.
  A heading that begins with 'band-nm' and not with 'nm' says that the values are averages over bands
  around the wavelengths, whose edges lie half way between these. 'paint --csv' prints such a table.
  Spectra without a heading are named after their file: FILE, or FILE:1, FILE:2 and so on.
  --light takes the name of a CIE illuminant first; write ./A for a file that is called A.

Conventions:
  Samples are interpolated to 1 nm and summed over 360..830 nm. Outside its samples a light is
  zero, and a reflectance has the value of the nearest end. Averages over bands are not interpolated:
  the spectrum is constant within each band.
  XYZ has Y = 100 for a relative light and for a perfect white surface. With --unit absolute Y is
  in lx.
  CCT, Duv, CRI and photometry use the CIE 1931 2 degree observer, and TM-30 uses CIE 1964.
  --observer changes XYZ, chromaticity, dominant wavelength, Lab and sRGB.
  Dominant wavelength and excitation purity are measured from the equal-energy white for lights,
  and from the white of the light for reflectances. A complementary wavelength is negative.
  The sRGB color of a light is that of its chromaticity at Y = 100. That of a reflectance is
  adapted from its light to D65 by Bradford's method. Both are clipped to the gamut, with a note.
  --compare reports each spectrum minus the one in FILE. y_ratio is the ratio of the numbers as
  read. spectral_rms is the root mean square difference over 360..830 nm. For lights, both are
  scaled to the same Y first, and the difference is divided by the root mean square of FILE.";

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

    /// Take the spectra as reflectances of surfaces (shares of 0..1) instead of lights
    #[arg(long)]
    pub reflectance: bool,

    /// The light on the surfaces: a CIE illuminant (D65, A, FL11, LED-B3, FL3.1, E and so on) or a
    /// file with one spectrum [default: D65]
    #[arg(long, value_name = "NAME|FILE", requires = "reflectance")]
    pub light: Option<PathBuf>,

    /// The unit of a light's numbers: absolute is W/m2/nm, which also gives lux and PPFD
    #[arg(long, value_enum, default_value_t)]
    pub unit: Unit,

    /// The rule that interpolates between the samples
    #[arg(long, value_enum, default_value_t)]
    pub interpolation: Between,

    /// Also report the difference to the spectrum in FILE, which must have only one
    #[arg(long, value_name = "FILE")]
    pub compare: Option<PathBuf>,

    /// Print one JSON object per line, with numbers that are not rounded
    #[arg(long)]
    pub json: bool,

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

/// The value of `--unit`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Unit {
    #[default]
    Relative,
    Absolute,
}

/// The value of `--interpolation`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Between {
    #[default]
    Linear,
    Sprague,
}

impl Args {
    /// Returns a failure for what is wrong with the command line alone.
    pub fn check(&self) -> Result<(), Failure> {
        if self.reflectance && self.unit == Unit::Absolute {
            let what = "a reflectance has no unit; leave out --unit or --reflectance";
            return Err(Failure::of("--unit absolute", what));
        }
        check_stdin(self.inputs())
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

impl From<Between> for Interpolation {
    fn from(between: Between) -> Self {
        match between {
            Between::Linear => Interpolation::Linear,
            Between::Sprague => Interpolation::Sprague,
        }
    }
}
