//! The options of the command `paint`.

use crate::failure::Failure;
use crate::paint::grids;
use crate::usage;
use clap::error::{ContextKind, Error};
use clap::{ArgMatches, ValueEnum};
use std::path::PathBuf;

const INPUT: &str = "\
Input:
  A color is three numbers, written as R,G,B or 'R G B', or a hexadecimal code such as #cc331a or
  #c31. Numbers are encoded by the transfer function of the RGB space, from 0 to 1, unless --linear
  says that they are linear; a code is always encoded. Numbers below 0 or above 1 are answered, and
  the status says how. NaN and infinities are refused.
  srgb and p3 (Display P3) are encoded by the curve of IEC 61966-2-1, dci-p3 by a power of 2.6, bt2020
  by a power of 2.4 (BT.1886), adobe by a power of 563/256 and prophoto by a power of 1.8 with a
  straight line; the numbers of acescg and aces2065 are linear.
  '-' reads colors from standard input, which is UTF-8 text with one color on each line. A '#' before
  a blank starts a comment. A color that begins with a minus sign must be given with --rgb, as in
  --rgb -0.1,0.5,0.4.
  Colors are answered in the order in which they were given. All of them are read and checked before
  anything is printed. If something is wrong, the program ends with exit code 2 and prints one line
  that says where.
  The values of a spectrum are averages over its bands, and not points of a curve.
  Without a color, the program shows 24 samples of CES99 (every fourth), by the colors that they have
  in sRGB under D65.

Conventions:
  The observer is CIE 1931 (2 degrees). The white of a space is D65; that of prophoto is D50, that of
  acescg and aces2065 daylight of 6000 K ('D60'), and that of dci-p3 a greenish light of its own
  ('DCI'). Under that white the spectrum has the color that was asked for. The other lights show how
  a surface with this spectrum would look there.
  XYZ has Y = 100 for the perfect white. Lab is relative to the white of the light. Swatches are in
  sRGB, adapted (CAT16) from the light to D65 and clipped to the gamut.

Status:
  exact        The spectrum has the color, within 0.002 CIEDE2000.
  unreachable  No sigmoid was found for the color. This one is the nearest, by CIEDE2000.
  desaturated  The spectrum has the luminance of the color, but only the share 'kept' of the way
               from gray to it.
  approximate  The method is smits, which does not give colors back exactly.
  unphysical   The spectrum has the color but is no reflectance, since it leaves 0..1.
  delta_e2000 is the difference between the color of the spectrum and the color asked for.";

/// Find spectra for RGB colors, and show how they look under other lights
#[derive(Debug, clap::Args)]
#[command(after_help = INPUT)]
pub struct Args {
    /// The colors; '-' reads them from standard input
    #[arg(value_name = "COLORS")]
    positional: Vec<String>,

    /// One more color; the option may be given several times
    #[arg(long, value_name = "R,G,B|#HEX|-", allow_hyphen_values = true)]
    rgb: Vec<String>,

    /// The RGB space that the numbers belong to
    #[arg(long, value_enum, default_value = "srgb")]
    pub space: Space,

    /// Take the numbers as linear and not as encoded
    #[arg(long)]
    pub linear: bool,

    /// The method that finds a spectrum
    #[arg(long, value_enum, default_value = "sigmoid")]
    pub method: Method,

    /// What to do with a color for which no sigmoid is found [default: nearest]
    #[arg(long, value_enum)]
    beyond: Option<Beyond>,

    /// The CIE illuminants under which the spectrum is shown, besides the white of the space; separated by
    /// commas, as in A,FL11,LED-B3,FL3.1
    #[arg(long, value_name = "NAME", value_delimiter = ',', default_values = ["A", "FL11"])]
    pub light: Vec<String>,

    /// The bands of the spectrum: nodes or bins, how many, and from where to where in nm
    #[arg(long, value_name = "LAYOUT:N,FROM,TO", long_help = grids::help(), value_parser = grids::known, default_value = "nodes:81,380,780")]
    pub grid: String,

    /// Print one JSON object for each color, on a line of its own, with unrounded numbers. Its keys are rgb,
    /// space, method, status, wavelengths_nm, spectrum, values_are, roundtrip_rgb, delta_e2000, linear, grid,
    /// beyond, kept (if the color was desaturated), sample (of CES99), lights, and notes, which say why a
    /// value is null
    #[arg(long)]
    pub json: bool,

    /// Print the spectra as a table, with a column for each color, which 'nanospectra measure --reflectance
    /// -' reads. The values are averages over bands around the wavelengths, as the heading 'band-nm' says
    #[arg(long, conflicts_with = "json")]
    pub csv: bool,

    /// Also draw each color into the directory DIR, as NUMBER-RRGGBB.svg. DIR is made if it is missing. A run
    /// that fails leaves no file behind, and no file is overwritten without --force
    #[arg(long, value_name = "DIR")]
    pub svg: Option<PathBuf>,

    /// Replace pictures that exist already. A link is never replaced
    #[arg(long, requires = "svg")]
    pub force: bool,

    /// The text of every color, in the order of the command line.
    #[arg(skip)]
    pub colors: Vec<String>,
}

/// The values of `--space`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Space {
    Srgb,
    #[value(alias = "display-p3")]
    P3,
    DciP3,
    Bt2020,
    #[value(alias = "adobe-rgb")]
    Adobe,
    #[value(alias = "prophoto-rgb")]
    Prophoto,
    Acescg,
    #[value(alias = "aces2065-1")]
    Aces2065,
}

/// The values of `--method`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Method {
    #[value(help = "A smooth curve within 0..1 that has the color exactly")]
    Sigmoid,
    #[value(help = "A mixture of three fixed spectra, which is linear and exact")]
    Basis,
    #[value(help = "The method of Smits (1999), which is approximate")]
    Smits,
}

/// The values of `--beyond`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Beyond {
    #[value(alias = "damp", help = "Come as near as CIEDE2000 allows; the status is unreachable")]
    Nearest,
    #[value(
        help = "Mix it with the gray of the same luminance until it has a spectrum; the status is desaturated"
    )]
    Desaturate,
}

impl Args {
    /// Puts the colors into the order of the command line.
    pub fn in_order_of(mut self, program: &ArgMatches) -> Self {
        let matches = program.subcommand().map(|(_, matches)| matches);
        let placed = |id: &str, words: &[String]| -> Vec<(usize, String)> {
            let places = matches.and_then(|matches| matches.indices_of(id));
            places.into_iter().flatten().zip(words.iter().cloned()).collect()
        };
        let mut colors = [placed("positional", &self.positional), placed("rgb", &self.rgb)].concat();
        colors.sort();
        self.colors = colors.into_iter().map(|(_, word)| word).collect();
        self
    }

    /// What to do with colors for which no sigmoid is found. With the other methods there is nothing to
    /// choose.
    pub fn beyond(&self) -> Option<Beyond> {
        (self.method == Method::Sigmoid).then(|| self.beyond.unwrap_or(Beyond::Nearest))
    }

    /// Refuses what is wrong by the command line alone.
    pub fn check(&self) -> Result<(), Failure> {
        if self.colors.iter().filter(|word| *word == "-").count() > 1 {
            return Err(Failure::of("-", "standard input can be read only once; give '-' only once"));
        }
        if self.beyond.is_some() && self.method != Method::Sigmoid {
            let what = "this option needs the method sigmoid; leave out --beyond or --method";
            return Err(Failure::of("--beyond", what));
        }
        if self.light.iter().any(|name| name.trim().is_empty()) {
            return Err(Failure::of("--light", "a name is empty; write --light A,FL11 or leave --light out"));
        }
        if self.colors.is_empty() && self.space != Space::Srgb {
            return Err(Failure::of(
                "--space",
                "the samples that are shown without colors are in sRGB; give --rgb too",
            ));
        }
        Ok(())
    }
}

/// The failure for a color that begins with a minus sign, which clap takes for an option.
pub fn negative(error: &Error) -> Option<Failure> {
    let word = usage::context(error, ContextKind::InvalidArg)?;
    let is_number = word.strip_prefix('-')?.starts_with(|c: char| c.is_ascii_digit() || c == '.');
    let what = "a color that begins with a minus sign looks like an option; write --rgb -0.1,0.5,0.4";
    is_number.then(|| Failure::of("paint", what))
}
