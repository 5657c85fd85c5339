//! The command line.

use crate::failure::Failure;
use crate::input::text::check_stdin;
use clap::ValueEnum;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use nanospectra::Interpolation;
use nanospectra::observer::{self, NamedObserver};
use std::path::PathBuf;

const INPUT: &str = "\
Input:
  Text in UTF-8: the first column is the wavelength in nm, every other column is a spectrum.
  Cells are separated by commas, semicolons, tabs or blanks; '#' starts a comment line; one
  heading line may name the columns. Wavelengths must increase. Nothing is sorted, dropped or
  guessed: what is wrong ends the program with exit code 2 and one line that says where. All
  input is checked before anything is printed, so there are no half reports.
  Spectra without a heading are called after their file: FILE, or FILE:1, FILE:2, ..
  --light takes a name for a CIE illuminant if it is one; write ./A for a file called A.

Conventions:
  Samples are interpolated to 1 nm and summed over 360..830 nm. Outside its data a light is
  zero, a reflectance keeps its end values.
  XYZ: Y = 100 for a relative light and for the perfect white; lx for --unit absolute.
  CCT, Duv, CRI and all of photometry use the CIE 1931 2 degree observer and TM-30 its own;
  --observer is for XYZ, chromaticity, dominant wavelength, Lab and sRGB.
  Dominant wavelength and excitation purity are seen from the equal-energy white for lights,
  from the light's own white for reflectances; a complementary wavelength is negative.
  sRGB: of a light its chromaticity at Y = 100; of a reflectance adapted (Bradford) from its light
  to D65. Both are clipped to the gamut, with a note.
  --compare gives this minus FILE. y_ratio is of the numbers as read. spectral_rms is the root
  mean square difference over 360..830 nm; for lights both are brought to the same Y first, and
  it is a share of FILE's root mean square.";

/// Every number that matters about measured spectra: color, color temperature, rendering,
/// photometry.
#[derive(Debug, Default, clap::Args)]
#[command(after_help = INPUT)]
pub struct Args {
    /// Spectra to report on; '-' is standard input. Without any: CIE L41, a white LED
    #[arg(value_name = "FILES")]
    pub files: Vec<PathBuf>,

    /// Color-matching functions
    #[arg(long, value_parser = eye(), default_value = observer::ALL[0].name)]
    pub observer: Eye,

    /// The spectra are reflectances (shares 0..1) of surfaces, not lights
    #[arg(long)]
    pub reflectance: bool,

    /// What lights the surfaces: a CIE illuminant (D65, A, FL11, LED-B3, FL3.1, E, ..) or a file
    /// with one spectrum [default: D65]
    #[arg(long, value_name = "NAME|FILE", requires = "reflectance")]
    pub light: Option<PathBuf>,

    /// What a light's numbers mean: absolute is W/m2/nm, and brings lux and PPFD
    #[arg(long, value_enum, default_value_t)]
    pub unit: Unit,

    /// How to read between the samples
    #[arg(long, value_enum, default_value_t)]
    pub interpolation: Between,

    /// Also report the difference to the one spectrum in FILE
    #[arg(long, value_name = "FILE")]
    pub compare: Option<PathBuf>,

    /// Print one JSON object a line, numbers unrounded
    #[arg(long)]
    pub json: bool,

    /// Also draw each spectrum into DIR (made if missing), as NAME.svg
    #[arg(long, value_name = "DIR")]
    pub svg: Option<PathBuf>,
}

/// `--observer`: one of [`observer::ALL`].
#[derive(Clone, Copy, Debug)]
pub struct Eye(pub &'static NamedObserver);

/// `--unit`
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Unit {
    #[default]
    Relative,
    Absolute,
}

/// `--interpolation`
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Between {
    #[default]
    Linear,
    Sprague,
}

impl Args {
    /// What the command line alone shows to be wrong.
    pub fn check(&self) -> Result<(), Failure> {
        if self.reflectance && self.unit == Unit::Absolute {
            let what = "a reflectance has no unit; leave out --unit or --reflectance";
            return Err(Failure::of("--unit absolute", what));
        }
        check_stdin(self.files.iter().chain(&self.light).chain(&self.compare))
    }
}

impl Default for Eye {
    fn default() -> Self {
        Eye(&observer::ALL[0])
    }
}

/// Takes the names of the observers, and lists them in the help.
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
