//! One reading, measured.

use crate::failure::Failure;
use crate::sensor::advice::{self, Next};
use crate::sensor::dark::Frames;
use crate::sensor::instrument::{Instrument, Setup};
use crate::sensor::log::Entry;
use nanospectra::color::{Cct, Xy, Xyz};
use nanospectra::radiometry::ppfd;
use nanospectra::sensor::{BasicCounts, CctUncertainty, Exposure, ReadingError, Variances};
use nanospectra::{Fine, Light};

/// Everything that is known of a reading.
pub struct Reading {
    /// As it was read.
    pub entry: Entry,
    pub settings: String,
    pub exposure: Exposure,
    pub status: Status,
    pub basic: Option<Vec<f32>>,
    pub color: Option<Color>,
    /// Lux, or Y: for flicker, so of dark readings too, but not of saturated ones.
    pub brightness: Option<f32>,
    pub next: Option<Next>,
    /// (what it is about, what is to be said)
    pub notes: Vec<(&'static str, String)>,
}

/// Whether a reading says something.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Status {
    Ok,
    /// The names of the channels.
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

/// A color with what chance may have done to it.
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
    /// (nm, power per nm): W/m2/nm if lux is known.
    pub spectrum: Option<Vec<(f32, f32)>>,
}

pub fn reading<const C: usize>(
    instrument: &Instrument<C>,
    setup: &Setup,
    dark: &Frames,
    entry: Entry,
) -> Result<Reading, Failure> {
    let lost = || Failure::of("log", "an entry without exposure or with other channels; report this");
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
    let mut notes = Vec::new();
    if !entry.unused.is_empty() {
        notes.push(("log", format!("columns not used: {}", entry.unused.join(", "))));
    }
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
        notes,
        entry,
    };
    if let Ok(basic) = outcome {
        reading.basic = Some(basic.values().to_vec());
        if instrument.to_xyz.xyz(&basic).is_err() {
            reading.status = Status::Negative;
            let what = "the sums are negative: a light unlike those of the calibration, or noise";
            reading.notes.push(("status", what.into()));
        }
        let color = color(instrument, setup, &basic, &variances, reading.status == Status::Ok);
        if color.spectrum.is_none() && instrument.spectrum.is_some() {
            let what = "the eye sees too little of it to tell its power from the lux";
            reading.notes.push(("spectrum", what.into()));
        }
        reading.color = Some(color);
    }
    Ok(reading)
}

/// The sums; what is meant to be a color only if it `is_one`.
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
        // So that its illuminance is that of the calibration; if the eye sees enough of it to tell.
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

/// What a row comes to, and the sizes of its terms.
fn sum_and_size<const C: usize>(row: &[f32; C], basic: &BasicCounts<C>) -> (f32, f32) {
    row.iter().zip(basic.values()).fold((0.0, 0.0), |(sum, size), (w, x)| (sum + w * x, size + (w * x).abs()))
}
