//! Turns what is known of the chip into matrices.

use crate::failure::Failure;
use crate::sensor::args::{Args, Unit};
use crate::sensor::calibration;
use crate::sensor::chip::{BINS, Chip, Grid};
use crate::sensor::responsivity;
use nanospectra::observer::{CIE_1931, KM};
use nanospectra::sensor::{Calibration, DEFAULT_ALPHA, Noise, Reconstruction};
use nanospectra::{Curve, Observer, Power};
use std::sync::LazyLock;

/// The correlation that is expected between neighboring bins of 10 nm.
const CORRELATION: f32 = 0.95;
/// The share of a channel's peak that a bin must reach to be reported.
const SEEN: f32 = 0.01;

static EYE: LazyLock<Observer<3, BINS, Power, Grid>> = LazyLock::new(|| CIE_1931.fold(Curve::Step));

/// The part of an instrument that does not depend on the number of channels.
pub struct Setup {
    pub chip: Chip,
    pub channels: Vec<String>,
    pub noise: Noise,
    /// Whether the noise is known, apart from the rounding to whole counts.
    pub noise_is_known: bool,
    /// The counts above dark that a reading must have.
    pub floor: f32,
    /// The weights of the channels on the bins.
    pub weights: Option<Vec<[f32; BINS]>>,
    pub source: Source,
    /// Whether Y is in lux.
    pub absolute: bool,
}

/// The source of the responsivities.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    Nominal,
    File,
    Unknown,
}

impl Source {
    pub fn name(self) -> &'static str {
        match self {
            Source::Nominal => "nominal",
            Source::File => "file",
            Source::Unknown => "unknown",
        }
    }
}

impl Setup {
    pub fn new(args: &Args, channels: &[String]) -> Result<Self, Failure> {
        let (weights, source) = match (&args.responsivity, args.sensor.nominal()) {
            (Some(path), _) => (Some(responsivity::read(path, channels)?), Source::File),
            (None, Some(nominal)) => (Some(nominal), Source::Nominal),
            (None, None) => (None, Source::Unknown),
        };
        let chip = args.sensor;
        let published = chip.0.and_then(|chip| chip.to_xyz);
        if source == Source::Unknown && args.calibration.is_none() && published.is_none() {
            let what = format!(
                "the channels of a {} are not known well enough to compute colors; \
                 give --calibration with measured patches, or --responsivity",
                chip.title()
            );
            return Err(Failure::of("--sensor", what));
        }
        let told = args.calibration.is_some() || args.responsivity.is_some();
        if args.unit.is_some() && !told {
            let what =
                "this is the unit of --responsivity or --calibration; give one of them, or leave it out";
            return Err(Failure::of("--unit", what));
        }
        let absolute = match args.unit {
            Some(unit) => unit == Unit::Absolute,
            None => args.calibration.is_some(),
        };
        // The noise of the simulated log is known.
        let known = args.log.is_none().then_some(crate::sensor::simulate::NOISE);
        let noise_is_known =
            known.is_some() || args.electrons_per_count.is_some() || args.read_counts.is_some();
        let rounding = Noise { electrons_per_count: f32::INFINITY, read_counts: 0.0 };
        let known = known.unwrap_or(rounding);
        let noise = Noise {
            electrons_per_count: args.electrons_per_count.unwrap_or(known.electrons_per_count),
            read_counts: args.read_counts.unwrap_or(known.read_counts),
        };
        let channels = channels.to_vec();
        Ok(Setup { chip, channels, noise, noise_is_known, floor: args.floor, weights, source, absolute })
    }
}

/// The matrices from basic counts to every result.
pub struct Instrument<const C: usize> {
    pub to_xyz: Calibration<C>,
    /// The matrix to lux, if lux is not Y.
    pub to_lux: Option<Calibration<C, 1>>,
    pub spectrum: Option<Reconstruction<C, BINS, Grid>>,
    /// The matrix to XYZ of that spectrum.
    pub of_spectrum: Option<Calibration<C>>,
    /// Whether a channel is sensitive in each bin.
    pub seen: [bool; BINS],
    /// Lines that say how the colors are computed, for the report.
    pub colors: Vec<String>,
}

impl<const C: usize> Instrument<C> {
    pub fn new(args: &Args, setup: &Setup) -> Result<Self, Failure> {
        let weights: Option<[[f32; BINS]; C]> =
            setup.weights.as_ref().and_then(|rows| rows.as_slice().try_into().ok());
        let place = args.responsivity.as_ref().map_or("--sensor".into(), |path| path.display().to_string());
        let spectrum = weights
            .map(|rows| Reconstruction::smooth(&Observer::from_weights(rows), CORRELATION, DEFAULT_ALPHA))
            .transpose()
            .map_err(|error| Failure::of(place, format_args!("no spectrum can be reconstructed; {error}")))?;
        let of_spectrum = spectrum.map(|spectrum| spectrum.seen_by(&EYE).scaled(KM));
        let mut colors = Vec::new();
        match setup.source {
            Source::Nominal => colors.push(format!(
                "spectrum: by NOMINAL responsivities of the {} (Gaussians of the data sheet, not measured)",
                setup.chip.title()
            )),
            Source::File => colors.push("spectrum: by the responsivities of a file".into()),
            Source::Unknown => {}
        }
        let mut to_lux = None;
        let to_xyz = match (&args.calibration, of_spectrum) {
            (Some(path), _) => {
                let found = calibration::read(path, &setup.channels)?;
                colors.push(format!("XYZ: {}", found.said));
                found.matrix
            }
            (None, Some(matrix)) => {
                colors.push("XYZ: from the spectrum".into());
                // XYZ is on the scale of the basic counts, unless these count W/m2.
                if setup.absolute { matrix } else { matrix.scaled(1.0 / KM) }
            }
            (None, None) => {
                let chip = setup.chip.0;
                to_lux = chip.and_then(|chip| chip.to_lux).map(|row| Calibration::from_rows([wide(row)]));
                let lux = if to_lux.is_some() { "XYZ and lux" } else { "XYZ" };
                colors.push(format!("{lux}: by the published matrix of the {}", setup.chip.title()));
                Calibration::from_rows(chip.and_then(|chip| chip.to_xyz).unwrap_or_default().map(wide))
            }
        };
        let seen = std::array::from_fn(|bin| {
            weights.is_some_and(|rows| {
                rows.iter().any(|row| row[bin] > SEEN * row.iter().copied().fold(0.0, f32::max))
            })
        });
        Ok(Instrument { to_xyz, to_lux, spectrum, of_spectrum, seen, colors })
    }
}

/// Converts a row to an array of the length `C`, the number of channels.
fn wide<const C: usize>(row: &[f32]) -> [f32; C] {
    std::array::from_fn(|channel| row.get(channel).copied().unwrap_or(0.0))
}
