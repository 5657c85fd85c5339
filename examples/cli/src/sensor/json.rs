//! Writes readings and runs as JSON, one object per line, with all digits of their numbers.

use crate::failure::Failure;
use crate::flicker::measures;
use crate::output::json::{explain, line, single};
use crate::output::{Spool, terminal};
use crate::sensor::Report;
use crate::sensor::instrument::Setup;
use crate::sensor::measure::{Color, Reading, Status};
use crate::sensor::runs::{At, Run};
use nanospectra::color::Cct;
use serde_json::{Value, json};

/// Prints the objects of all readings, in the order of the log, and then those of the runs.
pub fn print(report: &Report) -> Result<(), Failure> {
    terminal::stream(|out| {
        let (mut runs, mut later) = (report.runs(), Spool::new());
        let mut keep = |ended: Option<Run>| {
            ended.map_or(Ok(()), |ended| later.add("stdout", line(run(&ended), why).as_bytes()))
        };
        for reading in report.readings()? {
            let reading = reading?;
            out.write(&line(object(report, &reading), why))?;
            keep(runs.push(&reading))?;
        }
        keep(runs.end())?;
        later.print(out)
    })
}

fn object(report: &Report, reading: &Reading) -> Value {
    let setup = report.setup;
    let saturated = match &reading.status {
        Status::Saturated(channels) => channels.as_slice(),
        _ => &[],
    };
    let mut object = json!({
        "kind": "reading",
        "line": reading.entry.line,
        "time": reading.entry.time.as_ref().map(|(text, seconds)| seconds.map_or(json!(text), Value::from)),
        "label": reading.entry.label,
        "sensor": setup.chip.title(),
        "responsivities": setup.source.name(),
        "status": reading.status.name(),
        "saturated": saturated,
        "counts": raw(setup, &reading.entry.counts),
        "exposure": {
            "settings": reading.settings,
            "gain": single(reading.exposure.gain()),
            "time_ms": single(reading.exposure.time_ms()),
            "full_scale": reading.exposure.full_scale(),
            "shows_100_hz": shown(setup, reading, 100.0),
            "shows_120_hz": shown(setup, reading, 120.0),
        },
        "temperature_c": reading.entry.temperature_c.map(single),
        "basic_counts": reading.basic.as_ref().map(|basic| channels(setup, basic)),
    });
    let color = reading.color.as_ref().map_or_else(nothing, color);
    if let (Value::Object(object), Value::Object(color)) = (&mut object, color) {
        object.extend(color);
    }
    object["next"] = reading.next.as_ref().map_or(Value::Null, |next| {
        json!({
            "settings": next.settings,
            "gain": single(next.exposure.gain()),
            "time_ms": single(next.exposure.time_ms()),
            "same": next.same,
        })
    });
    let shared = general(setup, reading).into_iter().chain(report.unused());
    let own = shared.chain(reading.notes.iter().cloned());
    object["notes"] = own.map(|(key, text)| format!("{key}: {text}")).collect();
    let status = match reading.status {
        Status::Ok => None,
        Status::Saturated(_) => Some("a channel is saturated"),
        Status::TooDark => Some("the reading is too dark"),
        Status::Negative => Some("X, Y or Z is negative"),
    };
    explain(&mut object, |path| why(path).or(status).or(unknown(path)));
    // How the colors are computed is not about this reading, so it explains no null.
    if let Value::Array(notes) = &mut object["notes"] {
        notes.splice(0..0, report.colors.iter().cloned().map(Value::from));
    }
    object
}

/// Returns why a key of an object is null, if that is not the same for all keys.
fn why(path: &str) -> Option<&'static str> {
    Some(match path {
        "time" | "label" | "temperature_c" => "the log has no such column",
        "exposure.shows_100_hz" | "exposure.shows_120_hz" => "the time of a reading is not known",
        "next" => "the exposures to choose from are not known",
        "flicker.confused_with_hz" => "the run is long enough to tell it from the others",
        _ => return None,
    })
}

/// Returns why a reading that can be used lacks a number.
fn unknown(path: &str) -> Option<&'static str> {
    Some(match path {
        "lux" | "uncertainty.lux" | "ppfd" => "the lux of this reading is not known",
        "cct_k" | "duv" => "there is none for this color; the key cct says where the color lies",
        "wavelengths_nm" | "spectrum" => "the responsivities of the channels are not known",
        _ => return None,
    })
}

fn color(color: &Color) -> Value {
    let (cct_k, duv) = color.cct.and_then(Cct::near).unzip();
    let cct = color.cct_uncertainty;
    json!({
        "unit": if color.absolute { "absolute" } else { "relative" },
        "XYZ": color.xyz.to_array().map(single),
        "xy": color.xy.map(|p| [p.x, p.y].map(single)),
        "lux": color.lux.map(single),
        "cct_k": cct_k.map(single),
        "duv": duv.map(single),
        "cct": color.cct.map(place),
        "ppfd": color.ppfd.map(single),
        "wavelengths_nm": color.spectrum.as_ref().map(|bins| bins.iter().map(|bin| single(bin.0)).collect::<Value>()),
        "spectrum": color.spectrum.as_ref().map(|bins| bins.iter().map(|bin| single(bin.1)).collect::<Value>()),
        "uncertainty": {
            "XYZ": color.xyz_uncertainty.to_array().map(single),
            "lux": color.lux_uncertainty.map(single),
            "cct_k": cct.map(|cct| single(cct.cct_k)),
            "mired": cct.map(|cct| single(cct.mired)),
            "duv": cct.map(|cct| single(cct.duv)),
        },
    })
}

/// Returns the same keys as [`color`], without values, for a reading without a color.
fn nothing() -> Value {
    let keys = "unit XYZ xy lux cct_k duv cct ppfd wavelengths_nm spectrum uncertainty".split(' ');
    Value::Object(keys.map(|key| (key.to_owned(), Value::Null)).collect())
}

/// Returns where a chromaticity lies beside the Planckian locus, in words.
pub fn place(cct: Cct) -> &'static str {
    match cct {
        Cct::Near { .. } => "near",
        Cct::OffLocus => "off the locus",
        Cct::TooCold => "below 1000 K",
        Cct::TooHot => "beyond 1e6 K",
        _ => "none",
    }
}

/// Returns the notes that apply to every reading with this setup.
pub fn general(setup: &Setup, reading: &Reading) -> Vec<(&'static str, String)> {
    let mut notes = Vec::new();
    let Some(color) = &reading.color else { return notes };
    if color.lux.is_none() && !setup.absolute {
        let what = "no absolute scale is known for this sensor, so Y is relative; give --calibration in lux";
        notes.push(("lux", what.to_owned()));
    }
    if !setup.noise_is_known {
        let what =
            "it includes only the rounding to whole counts; give --electrons-per-count and --read-counts";
        notes.push(("uncertainty", what.to_owned()));
    }
    let Color { xyz_uncertainty, cct_uncertainty, .. } = color;
    let of_cct = cct_uncertainty.map(|of| [of.cct_k, of.mired, of.duv]);
    let mut numbers = xyz_uncertainty
        .to_array()
        .into_iter()
        .chain(color.lux_uncertainty)
        .chain(of_cct.into_iter().flatten());
    if numbers.any(|number| !number.is_finite()) {
        notes.push((
            "uncertainty",
            "what is unknown of it follows from numbers that are too large".to_owned(),
        ));
    }
    notes
}

fn run(run: &Run) -> Value {
    let flicker = |at: &At| {
        let found = at.flicker.found.as_ref().ok();
        let object = json!({
            "frequency_hz": single(at.flicker.frequency_hz),
            "mean": found.map(|(flicker, _)| single(flicker.mean)),
            "percent": found.map(|(flicker, _)| single(flicker.percent)),
            "index": found.map(|(flicker, _)| single(flicker.index)),
            "amplitude": found.map(|(_, amplitude)| single(*amplitude)),
            "svm": at.flicker.svm.as_ref().ok().map(|svm| single(*svm)),
            "confused_with_hz": at.confused_with_hz.map(single),
            "shown_by_readings": single(at.shown),
        });
        with_note(object, at.flicker.found.as_ref().err())
    };
    let notes = match run.rate_hz {
        Ok(_) => measures::unknown(&run.pst_lm, run.flicker.iter().map(|at| &at.flicker)),
        // A note of the object says why.
        Err(_) => Vec::new(),
    };
    let object = json!({
        "kind": "run",
        "label": run.label,
        "lines": [run.lines.0, run.lines.1],
        "readings": run.readings,
        "rate_hz": run.rate_hz.as_ref().ok().map(|rate| single(*rate)),
        "pst_lm": run.pst_lm.as_ref().ok().map(|severity| single(*severity)),
        "flicker": run.flicker.iter().map(flicker).collect::<Value>(),
        "notes": notes,
    });
    with_note(object, run.rate_hz.as_ref().err())
}

/// Returns an object with a note, if there is one, which says why its numbers are missing.
fn with_note(mut object: Value, note: Option<&String>) -> Value {
    if let Some(note) = note {
        object["note"] = json!(note);
    }
    object
}

/// Returns the share of a flicker that the reading still shows, if the chip's settings tell its time.
fn shown(setup: &Setup, reading: &Reading, hz: f32) -> Value {
    if setup.chip.settings().is_empty() {
        Value::Null
    } else {
        single(reading.exposure.residual_modulation(hz))
    }
}

/// Returns the counts of the channels, where whole counts are written as whole numbers.
fn raw(setup: &Setup, counts: &[f64]) -> Value {
    let count = |count: &f64| {
        if count.fract() == 0.0 && *count < 4e9 { Value::from(*count as u32) } else { Value::from(*count) }
    };
    setup.channels.iter().cloned().zip(counts.iter().map(count)).collect()
}

fn channels(setup: &Setup, values: &[f32]) -> Value {
    setup.channels.iter().cloned().zip(values.iter().map(|value| single(*value))).collect()
}
