//! Writes a reading as a JSON object, with all digits of its numbers.

use crate::measure::reading::{Bench, Comparison, Difference, Reading};
use crate::output::json::{number, single};
use crate::usage::name_of;
use serde_json::{Map, Value, json};

/// Returns the object of a reading, with its keys in the order of the documentation.
pub fn object(bench: &Bench, reading: &Reading) -> Value {
    let mut object = json!({
        "name": reading.name,
        "XYZ": reading.xyz.map(number),
        "xy": reading.xy.map(|p| [p.x, p.y].map(single)),
        "uv1960": reading.uv1960.map(|p| [p.u, p.v].map(single)),
        "uv1976": reading.uv1976.map(|p| [p.u, p.v].map(single)),
        "cct_k": reading.cct_k.map(single),
        "duv": reading.duv.map(single),
        "lux": reading.lux.map(number),
        "ler_lm_per_w": reading.ler_lm_per_w.map(single),
        "lab": reading.lab.map(|lab| [lab.l, lab.a, lab.b].map(single)),
        "srgb": reading.srgb.map(|rgb| rgb.map(single)),
        "hex": reading.hex,
        "dominant_wavelength_nm": reading.dominant_wavelength_nm.map(single),
        "purity": reading.purity.map(single),
        "cri_ra": reading.cri_ra.map(single),
        "cri_r": reading.cri_r.map(|r| r.map(single)),
        "tm30_rf": reading.tm30_rf.map(single),
        "tm30_rg": reading.tm30_rg.map(single),
        "melanopic_edi_ratio": reading.melanopic_edi_ratio.map(single),
        "ppfd": reading.ppfd.map(number),
        "notes": reading.notes.iter().map(|note| format!("{}: {}", note.key, note.text)).collect::<Vec<_>>(),
        "delta_e2000": reading.delta_e2000.map(single),
        "observer": bench.eye.name,
        "interpolation": reading.rule,
        "unit": name_of(bench.unit),
        "file": &*reading.file,
    });
    if let Some(room) = &bench.room {
        object["light"] = json!(room.light.name);
    }
    if let Some(comparison) = &reading.compare {
        object["compare"] = compared(comparison);
    }
    object
}

fn compared(comparison: &Comparison) -> Value {
    let mut object = Map::new();
    object.insert("to".into(), json!(comparison.to));
    for (key, difference) in &comparison.differences {
        let value = match difference {
            Some(Difference::One(value)) => number(*value),
            Some(Difference::Each(values)) => values.iter().copied().map(single).collect(),
            None => Value::Null,
        };
        object.insert((*key).to_owned(), value);
    }
    Value::Object(object)
}
