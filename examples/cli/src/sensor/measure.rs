//! Computes the results of one reading.

use crate::failure::Failure;
use crate::sensor::advice::{self, Next};
use crate::sensor::dark::Frames;
use crate::sensor::instrument::{Instrument, Setup};
use crate::sensor::log::Entry;
use nanospectra::color::{Cct, Xy, Xyz};
use nanospectra::radiometry::ppfd;
use nanospectra::sensor::{BasicCounts, CctUncertainty, Exposure, ReadingError, Variances};
use nanospectra::{Fine, Light};

/// The results of one reading.
pub struct Reading {
    /// The entry of the log.
    pub entry: Entry,
    pub settings: String,
    pub exposure: Exposure,
    pub status: Status,
    pub basic: Option<Vec<f32>>,
    pub color: Option<Color>,
    /// Lux or Y, from which flicker is computed. Dark readings have it too, but saturated ones do not.
    pub brightness: Option<f32>,
    pub next: Option<Next>,
    /// Notes on this reading alone, as pairs of what they are about and their texts.
    pub notes: Vec<(&'static str, String)>,
}

/// Whether a reading can be used, and why not.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Status {
    Ok,
    /// At least one channel is saturated. Holds the names of those channels.
    Saturated(Vec<String>),
    TooDark,
    Negative,
}

impl Status {
    pub fn name(&self) -> &'static str {
        match self {
            Status::Ok => "ok",
            Status::Saturated(_) => "saturated",
            Status::TooDark => "too dark",
            Status::Negative => "negative",
        }
    }
}

/// A color with its uncertainties.
pub struct Color {
    pub xyz: Xyz,
    pub xyz_uncertainty: Xyz,
    pub xy: Option<Xy>,
    pub cct: Option<Cct>,
    pub cct_uncertainty: Option<CctUncertainty>,
    pub lux: Option<f32>,
    pub lux_uncertainty: Option<f32>,
    /// Whether XYZ has Y in lux.
    pub absolute: bool,
    pub ppfd: Option<f32>,
    /// Pairs of a wavelength in nm and the power per nm, in W/m2/nm if lux is known.
    pub spectrum: Option<Vec<(f32, f32)>>,
}

pub fn reading<const C: usize>(
    instrument: &Instrument<C>,
    setup: &Setup,
    dark: &Frames,
    entry: Entry,
) -> Result<Reading, Failure> {
    let lost = || {
        Failure::of(
            "log",
            "an entry has no exposure or other channels, which is an error in this program; report it",
        )
    };
    let exposure = entry.exposure.ok_or_else(lost)?.with_floor(setup.floor);
    let counts: [f64; C] = entry.counts.as_slice().try_into().map_err(|_| lost())?;
    let counts = counts.map(|count| count as f32);
    let level = dark.of(&entry)?;
    let mut variances = setup.noise.variances(&exposure, &counts);
    let outcome = match &level {
        Some(level) => {
            let dark: [f32; C] = level.counts.as_slice().try_into().map_err(|_| lost())?;
            variances = variances.plus(&setup.noise.variances(&exposure, &dark).of_mean(level.readings));
            exposure.basic_counts_above(&dark, &counts)
        }
        None => exposure.basic_counts(&counts),
    };
    let above_dark = |k: usize| counts[k] - level.as_ref().map_or(0.0, |level| level.counts[k]);
    let sums = BasicCounts::new(std::array::from_fn(|k| above_dark(k) * exposure.per_count()));
    let brightness = match &instrument.to_lux {
        Some(to_lux) => to_lux.apply(&sums)[0],
        None => instrument.to_xyz.apply(&sums)[1],
    };
    let status = match outcome {
        Ok(_) => Status::Ok,
        Err(ReadingError::Saturated { channels }) => {
            let named = setup.channels.iter().enumerate().filter(|(k, _)| channels.contains(*k));
            Status::Saturated(named.map(|(_, name)| name.clone()).collect())
        }
        Err(_) => Status::TooDark,
    };
    let mut reading = Reading {
        settings: setup.chip.describe(&entry.settings),
        exposure,
        status,
        basic: None,
        color: None,
        brightness: Some(brightness).filter(|_| !matches!(outcome, Err(ReadingError::Saturated { .. }))),
        next: advice::of(setup.chip, exposure, &entry.settings, &counts),
        notes: Vec::new(),
        entry,
    };
    if let Ok(basic) = outcome {
        reading.basic = Some(basic.values().to_vec());
        if instrument.to_xyz.xyz(&basic).is_err() {
            reading.status = Status::Negative;
            let what = "X, Y or Z is negative, because the light is unlike those of the calibration or because of noise";
            reading.notes.push(("status", what.into()));
        }
        let color = color(instrument, setup, &basic, &variances, reading.status == Status::Ok);
        if color.spectrum.is_none() && instrument.spectrum.is_some() {
            let what = "too little of it is visible to compute its power from the lux";
            reading.notes.push(("spectrum", what.into()));
        }
        reading.color = Some(color);
    }
    Ok(reading)
}

/// Computes the color. Only XYZ is filled in unless the sums are those of a real color (`is_one`).
fn color<const C: usize>(
    instrument: &Instrument<C>,
    setup: &Setup,
    basic: &BasicCounts<C>,
    variances: &Variances<C>,
    is_one: bool,
) -> Color {
    let xyz = Xyz::from(instrument.to_xyz.apply(basic));
    let covariance = instrument.to_xyz.covariance(variances);
    let seen = Some(xyz).filter(|_| is_one);
    let (lux, lux_uncertainty) = match &instrument.to_lux {
        Some(to_lux) => (to_lux.apply(basic)[0], to_lux.uncertainty(variances)[0]),
        None => (xyz.y, covariance.uncertainty().y),
    };
    let lux_is_known = (setup.absolute || instrument.to_lux.is_some()) && is_one;
    let spectrum = instrument.spectrum.and_then(|spectrum| {
        let light = spectrum.spectrum(basic);
        if !lux_is_known {
            return Some(light);
        }
        // Scale the spectrum to the illuminance of the calibration, if enough of it is visible.
        let [_, own, _] = instrument.of_spectrum?.rows().map(|row| sum_and_size(&row, basic));
        (own.0 > 0.02 * own.1).then(|| Light::from_bins(light.values().map(|value| value * (lux / own.0))))
    });
    Color {
        xyz,
        xyz_uncertainty: covariance.uncertainty(),
        xy: seen.and_then(Xyz::xy),
        cct: seen.and_then(Xyz::uv1960).map(|uv| uv.cct()),
        cct_uncertainty: seen.and_then(|xyz| covariance.cct(xyz)),
        lux: lux_is_known.then_some(lux),
        lux_uncertainty: lux_is_known.then_some(lux_uncertainty),
        absolute: setup.absolute,
        ppfd: spectrum.filter(|_| lux_is_known).map(|light| {
            let fine: Fine<nanospectra::Power> = light.fine();
            ppfd(&fine)
        }),
        spectrum: spectrum.map(|light| {
            light.iter().zip(instrument.seen).filter(|(_, seen)| *seen).map(|(bin, _)| bin).collect()
        }),
    }
}

/// Returns the sum of a row times the basic counts, and the sum of the absolute values of the terms.
fn sum_and_size<const C: usize>(row: &[f32; C], basic: &BasicCounts<C>) -> (f32, f32) {
    row.iter().zip(basic.values()).fold((0.0, 0.0), |(sum, size), (w, x)| (sum + w * x, size + (w * x).abs()))
}
