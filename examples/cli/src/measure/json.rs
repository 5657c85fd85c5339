//! Writes a reading as a JSON object, with all digits of its numbers.

use crate::measure::level::Kind;
use crate::measure::reading::{Bench, Comparison, Difference, Reading, Strength};
use crate::output::json::{number, single};
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
        "delta_e2000_to_white": reading.delta_e2000_to_white.map(single),
        "observer": bench.eye.name,
        "interpolation": reading.rule.map(|rule| rule.name()),
        "unit": reading.kind.unit(),
        "file": &*reading.file,
        "read": reading.origin,
        "stated": stated(reading),
        "cri_r9": reading.cri_r.map(|r| single(r[8])),
        "cri_is_valid": reading.cri_is_valid,
        "tm30_edition": "ANSI/IES TM-30-20",
    });
    if reading.origin.is_none() {
        let what = "with --strict nothing is found out";
        object["read"] = json!(what);
    }
    if reading.kind == Kind::Surface {
        object["light"] = json!(bench.room.light.name);
    }
    strength(&mut object, reading);
    if let Some(comparison) = &reading.compare {
        return with_comparison(object, comparison);
    }
    object
}

/// Returns what the file says beside its spectra. Of lines with the same name the last one counts.
fn stated(reading: &Reading) -> Value {
    Value::Object(reading.stated.iter().map(|(name, value)| (name.clone(), json!(value))).collect())
}

/// Adds how strong a light is, and where its power is.
fn strength(object: &mut Value, reading: &Reading) {
    let Strength { power, luminous, epar, bands, r_fr, receptors } = &reading.strength;
    if let Some(level) = reading.kind.level() {
        object[level.radiant[1]] = json!(power.map(number));
        object[level.luminous[2]] = json!(luminous.map(number));
    }
    object["epar"] = json!(epar.map(number));
    let photons: Map<String, Value> =
        bands.iter().map(|(name, _, photons)| ((*name).to_owned(), json!(photons.map(number)))).collect();
    let is_known = bands.iter().any(|(_, _, photons)| photons.is_some());
    object["photons"] = if is_known { Value::Object(photons) } else { Value::Null };
    let shares: Map<String, Value> =
        bands.iter().map(|(name, share, _)| ((*name).to_owned(), json!(share.map(number)))).collect();
    object["photon_shares"] = if shares.is_empty() { Value::Null } else { Value::Object(shares) };
    object["r_fr"] = json!(r_fr.map(number));
    let receptors: Map<String, Value> = receptors
        .iter()
        .map(|receptor| {
            let mut one = json!({ "der": receptor.der.map(number) });
            if let (Some(alpha_opic), Some(equivalent)) = (receptor.alpha_opic, receptor.equivalent) {
                let keys = match reading.kind {
                    Kind::Radiance => ["radiance_w_m2_sr", "edl_cd_m2"],
                    _ => ["irradiance_w_m2", "edi_lx"],
                };
                one[keys[0]] = number(alpha_opic);
                one[keys[1]] = number(equivalent);
            }
            (receptor.name.to_owned(), one)
        })
        .collect();
    object["alpha_opic"] = if receptors.is_empty() { Value::Null } else { Value::Object(receptors) };
    object["peak_nm"] = json!(reading.shape.map(|shape| number(shape.peak)));
    object["centroid_nm"] = json!(reading.shape.and_then(|shape| shape.centroid).map(number));
    object["fwhm_nm"] = json!(reading.shape.and_then(|shape| shape.width).map(number));
}

/// Returns the object with the comparison behind its name, where it is found first.
fn with_comparison(object: Value, comparison: &Comparison) -> Value {
    let Value::Object(object) = object else { return object };
    let mut whole = Map::new();
    for (key, value) in object {
        let is_name = key == "name";
        whole.insert(key, value);
        if is_name {
            whole.insert("compare".into(), compared(comparison));
        }
    }
    Value::Object(whole)
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
