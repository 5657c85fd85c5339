//! An answer as one JSON object, in which every number has all its digits.

use crate::output::json::{numbers, single};
use crate::output::tint;
use crate::scene::answer::{Absolute, Answer, Budget, Line, NO_WHITE, Sensor};
use nanospectra::path::Price;
use serde_json::{Value, json};

/// Returns why a key of the object is null.
pub fn why(path: &str) -> Option<&'static str> {
    Some(match path {
        "xy" => "black has no chromaticity",
        "lab" | "bill.without_delta_e2000" => NO_WHITE,
        "absolute" => "the lamp has no illuminance_lx",
        "absolute.luminance_cd_m2" | "absolute.radiance_w_m2_sr" => {
            "the light leaves something that is not matt"
        }
        "sensor" => "the scene names no sensor",
        "sensor.of_lamp" => "the channel gets nothing from the bare lamp",
        "budget" => "no --budget is given",
        _ => return None,
    })
}

/// The object for a scene, with its keys in the order that `--help` lists them.
pub fn object(answer: &Answer) -> Value {
    json!({
        "scene": answer.name,
        "title": answer.title,
        "lamp": answer.lamp,
        "eye": answer.eye,
        "grid": answer.grid,
        "wavelengths_nm": numbers(answer.lit.iter().map(|(nm, _)| *nm)),
        "lamp_spectrum": numbers(answer.lit.iter().map(|(_, power)| *power)),
        "leaving_spectrum": numbers(answer.leaving.iter().map(|(_, power)| *power)),
        "XYZ": numbers(answer.look.xyz.to_array()),
        "xy": answer.look.xy.map(|xy| numbers([xy.x, xy.y])),
        "lab": answer.look.lab.map(|lab| numbers([lab.l, lab.a, lab.b])),
        "hex": tint::hex(answer.look.srgb),
        "hex_is_clipped": answer.look.is_clipped,
        "lamp_hex": tint::hex(answer.lamp_srgb),
        "luminous_factor_percent": single(answer.look.xyz.y),
        "absolute": answer.absolute.as_ref().map(absolute),
        "sensor": answer.sensor.as_ref().map(sensor),
        "bill": answer.bill.iter().enumerate().map(line).collect::<Vec<_>>(),
        "walked": price(answer.walked),
        "folded": price(answer.folded),
        "budget": answer.budget.as_ref().map(budget),
        "notes": answer.notes,
    })
}

fn absolute(absolute: &Absolute) -> Value {
    json!({
        "illuminance_lx": single(absolute.illuminance_lx),
        "irradiance_w_m2": single(absolute.irradiance_w_m2),
        "exitance_lm_m2": single(absolute.exitance_lm_m2),
        "exitance_w_m2": single(absolute.exitance_w_m2),
        "luminance_cd_m2": absolute.radiance.map(|[luminance, _]| single(luminance)),
        "radiance_w_m2_sr": absolute.radiance.map(|[_, radiance]| single(radiance)),
    })
}

fn sensor(sensor: &Sensor) -> Value {
    json!({
        "name": sensor.name,
        "channels_nm": numbers(sensor.peaks_nm.iter().copied()),
        "channels": numbers(sensor.channels.iter().copied()),
        "of_lamp": sensor.of_lamp.iter().map(|share| share.map(single)).collect::<Vec<_>>(),
    })
}

fn line((part, line): (usize, &Line)) -> Value {
    json!({
        "part": part,
        "name": line.name,
        "kind": line.kind,
        "effect": line.effect,
        "multiply_adds": line.price.multiply_adds,
        "bytes": line.price.bytes,
        "without_delta_e2000": line.without_delta_e.map(single),
        "left_out": line.left_out,
    })
}

fn price(price: Price) -> Value {
    json!({ "multiply_adds": price.multiply_adds, "bytes": price.bytes })
}

fn budget(budget: &Budget) -> Value {
    json!({
        "delta_e2000": single(budget.delta_e),
        "left_out": budget.left_out,
        "cost_delta_e2000": single(budget.cost_delta_e),
        "hex": tint::hex(budget.srgb),
        "multiply_adds": budget.multiply_adds,
    })
}
