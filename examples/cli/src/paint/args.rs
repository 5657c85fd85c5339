//! The command line.

use crate::failure::Failure;
use crate::paint::grids;
use crate::usage;
use clap::error::{ContextKind, Error};
use clap::{ArgMatches, ValueEnum};
use std::path::PathBuf;

const INPUT: &str = "\
Input:
  A color is three numbers, R,G,B or 'R G B', or a code, #cc331a or #c31. Numbers are encoded by
  the transfer function of the space, 0..1, unless --linear says otherwise; a code is encoded
  always. Numbers below 0 or above 1 are answered with a status, NaN and infinities are refused.
  srgb and p3 are encoded by the curve of IEC 61966-2-1, bt2020 by a power of 2.4 (BT.1886), adobe
  by one of 563/256; acescg is linear.
  '-' reads colors from standard input: text in UTF-8, one a line; '#' before a blank starts a
  comment. A color that begins with a minus goes behind --rgb: --rgb -0.1,0.5,0.4.
  Colors are answered in the order they were given. All are read and checked before anything is
  printed: what is wrong ends the program with exit code 2 and one line that says where.
  Without colors: 24 samples of CES99 (every fourth), by their colors in sRGB under D65.

Conventions:
  The eye is CIE 1931, 2 degrees. The white of a space is D65, of acescg daylight of 6000 K; a
  spectrum has its color under that light and shows its shape under others.
  exact: within 0.002 CIEDE2000. unreachable: no sigmoid has the color, this one comes near.
  desaturated: it has the luminance, but of the way from gray to the color only the share kept.
  approximate: by smits, which does not give colors back. unphysical: exact, but no reflectance,
  for it leaves 0..1. delta_e2000 says by how much the color is missed.
  XYZ: Y = 100 for the perfect white, Lab by the white of the light. Swatches are sRGB, adapted
  (CAT16) from the light to D65 and clipped to the gamut.";

/// Spectra for RGB colors: the color each gives back, and how it looks under other lights.
#[derive(Debug, clap::Args)]
#[command(after_help = INPUT)]
pub struct Args {
    /// Colors; '-' reads them from standard input
    #[arg(value_name = "COLORS")]
    positional: Vec<String>,

    /// The same, once or more often
    #[arg(long, value_name = "R,G,B|#HEX|-", allow_hyphen_values = true)]
    rgb: Vec<String>,

    /// The RGB space of the numbers
    #[arg(long, value_enum, default_value = "srgb")]
    pub space: Space,

    /// The numbers are linear, not encoded
    #[arg(long)]
    pub linear: bool,

    /// How to find a spectrum
    #[arg(long, value_enum, default_value = "sigmoid")]
    pub method: Method,

    /// What to do with a color that no sigmoid has [default: nearest]
    #[arg(long, value_enum)]
    beyond: Option<Beyond>,

    /// CIE illuminants to look under besides the white of the space, with commas: A,FL11,LED-B3,FL3.1; each
    /// once
    #[arg(long, value_name = "NAME", value_delimiter = ',', default_values = ["A", "FL11"])]
    pub light: Vec<String>,

    /// Bands of the spectrum: points or bins, how many, from and to in nm
    #[arg(long, value_name = "LAYOUT:N,FROM,TO", long_help = grids::help(), value_parser = grids::known, default_value = "nodes:81,380,780")]
    pub grid: String,

    /// Print one JSON object a line, numbers unrounded: rgb, space, method, status, wavelengths_nm, spectrum,
    /// roundtrip_rgb, delta_e2000; linear, grid, beyond, kept (if desaturated), sample (of CES99), lights
    #[arg(long)]
    pub json: bool,

    /// Also draw each color into DIR (made if missing), as NUMBER-RRGGBB.svg; nothing is overwritten, and
    /// a run that fails leaves nothing there
    #[arg(long, value_name = "DIR")]
    pub svg: Option<PathBuf>,

    /// Every color's text, in the order of the command line.
    #[arg(skip)]
    pub colors: Vec<String>,
}

/// `--space`
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Space {
    Srgb,
    #[value(alias = "display-p3")]
    P3,
    Bt2020,
    #[value(alias = "adobe-rgb")]
    Adobe,
    Acescg,
}

/// `--method`
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Method {
    #[value(help = "smooth, within 0..1, exact")]
    Sigmoid,
    #[value(help = "three fixed spectra, linear and exact")]
    Basis,
    #[value(help = "the classic of 1999, approximate")]
    Smits,
}

/// `--beyond`
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Beyond {
    #[value(alias = "damp", help = "as near as least squares come: status unreachable")]
    Nearest,
    #[value(help = "mixed with the gray of its luminance until it has a spectrum: status desaturated")]
    Desaturate,
}

impl Args {
    /// The same with the colors in the order of the command line.
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

    /// What becomes of colors that no sigmoid has; nothing to choose with the other methods.
    pub fn beyond(&self) -> Option<Beyond> {
        (self.method == Method::Sigmoid).then(|| self.beyond.unwrap_or(Beyond::Nearest))
    }

    /// What the command line alone shows to be wrong.
    pub fn check(&self) -> Result<(), Failure> {
        if self.colors.iter().filter(|word| *word == "-").count() > 1 {
            return Err(Failure::of("-", "standard input can be read once; name it once"));
        }
        if self.beyond.is_some() && self.method != Method::Sigmoid {
            let what = "for colors that no sigmoid has; leave out --beyond or --method";
            return Err(Failure::of("--beyond", what));
        }
        if self.light.iter().any(|name| name.trim().is_empty()) {
            return Err(Failure::of("--light", "an empty name; write --light A,FL11 or leave --light out"));
        }
        if self.colors.is_empty() && self.space != Space::Srgb {
            return Err(Failure::of("--space", "the samples shown without colors are sRGB; give --rgb too"));
        }
        Ok(())
    }
}

/// Of a color that begins with a minus, which clap takes for an option.
pub fn negative(error: &Error) -> Option<Failure> {
    let word = usage::context(error, ContextKind::InvalidArg)?;
    let is_number = word.strip_prefix('-')?.starts_with(|c: char| c.is_ascii_digit() || c == '.');
    let what = "a color that begins with a minus looks like an option; write --rgb -0.1,0.5,0.4";
    is_number.then(|| Failure::of("paint", what))
}
