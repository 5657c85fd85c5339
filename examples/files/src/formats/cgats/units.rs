//! Says what the values of a table are.

use super::Key;
use crate::formats::contents::{Spectrum, TWICE, highest, part};
use crate::refusal::{Note, Refusal, Setting};

/// What the values are, and what they are to be divided by.
pub struct Scale {
    pub unit: Option<String>,
    pub norm: f64,
}

/// A reflectance in percent above this is none, not even that of a fluorescent sample.
const NO_REFLECTANCE: f64 = 150.0;

/// Finds what the values of a table are by the kind of the file and the head of the table.
pub fn find(
    kind: &str,
    keys: &[Key],
    named: Option<f64>,
    spectra: &[Spectrum],
    notes: &mut Vec<Note>,
) -> Result<Scale, Refusal> {
    let value = |name: &str| keys.iter().rev().find(|key| key.name == name).map(|key| key.value.as_str());
    let norm = match value("SPECTRAL_NORM").map(str::parse::<f64>) {
        Some(Ok(norm)) if norm.is_finite() && norm > 0.0 => Some(norm),
        Some(_) => {
            let line = keys.iter().rev().find(|key| key.name == "SPECTRAL_NORM").map(|key| key.line);
            let what = "SPECTRAL_NORM, by which all values are divided, is no number above 0; correct it";
            return Err(Refusal { line, ..Refusal::of(what) });
        }
        None => None,
    };
    let measured = value("MEAS_TYPE").unwrap_or("").to_ascii_uppercase();
    let device = value("DEVICE_CLASS").unwrap_or("").to_ascii_uppercase();
    let relative = value("NORMALIZED_TO_Y_100").is_some_and(|value| value.eq_ignore_ascii_case("YES"));
    let quantity = match (measured.as_str(), device.as_str()) {
        ("REFLECTIVE", _) => Some("reflectance"),
        ("TRANSMISSIVE", _) => Some("transmittance"),
        ("EMISSION", _) => Some("radiance (mW/m2/sr/nm)"),
        ("AMBIENT", _) => Some("irradiance (mW/m2/nm)"),
        ("", "OUTPUT" | "INPUT") => Some("reflectance"),
        ("", "DISPLAY" | "EMISINPUT") => Some("radiance (mW/m2/sr/nm)"),
        (other, _) if !other.is_empty() => {
            let what = format!("the values are relative, because MEAS_TYPE says {other}");
            notes.push(Note::assumed(what, Some(Setting::Unit)));
            Some("relative")
        }
        _ if kind == "CCSS" => Some("relative"),
        _ if kind == "SPECT" => None,
        _ => described(keys),
    };
    Ok(match quantity {
        Some(ratio @ ("reflectance" | "transmittance")) => match norm.or(named) {
            Some(100.0) => Scale { unit: Some(format!("{ratio} (percent)")), norm: 1.0 },
            Some(norm) => Scale { unit: Some(ratio.to_owned()), norm: said(norm, notes) },
            None => Scale { unit: guessed(ratio, spectra, notes), norm: 1.0 },
        },
        quantity => {
            let quantity = quantity.map(|quantity| if relative { "relative" } else { quantity });
            Scale { unit: quantity.map(str::to_owned), norm: said(norm.unwrap_or(1.0), notes) }
        }
    })
}

/// Says by what all values are divided.
fn said(norm: f64, notes: &mut Vec<Note>) -> f64 {
    if norm != 1.0 {
        notes.push(Note::stated(format!("all values are divided by SPECTRAL_NORM, which is {norm}")));
    }
    norm
}

/// Returns what the head of a table says in words of its own. CGATS.17 is made for reflectances.
fn described(keys: &[Key]) -> Option<&'static str> {
    let about = |key: &&Key| {
        ["MEAS", "DESCRIPTOR", "ORIGINATOR", "PROCESS", "DATA_TYPE", "SPECTRAL"]
            .iter()
            .any(|word| key.name.contains(word))
    };
    let says = |words: &[&str]| {
        keys.iter().filter(about).any(|key| {
            let value = key.value.to_lowercase();
            words.iter().any(|word| value.contains(word))
        })
    };
    if says(&["emiss", "emitt", "radian", "ambient", "light source", "spectral power"]) {
        None
    } else if says(&["transmi"]) {
        Some("transmittance")
    } else {
        Some("reflectance")
    }
}

/// Says whether values of an unknown scale are in percent.
fn guessed(ratio: &str, spectra: &[Spectrum], notes: &mut Vec<Note>) -> Option<String> {
    let high = highest(spectra.iter().flat_map(|spectrum| &spectrum.values));
    if high > NO_REFLECTANCE {
        let what =
            format!("the values are relative, because they reach {high}, which no {ratio} in percent does");
        notes.push(Note::assumed(what, Some(Setting::Unit)));
        return Some("relative".to_owned());
    }
    if high <= TWICE {
        let what = format!("the {ratio}s are parts of 1, because none is above {high}");
        notes.push(Note::assumed(what, Some(Setting::Percent)));
    }
    Some(part(ratio, high, TWICE, notes))
}
