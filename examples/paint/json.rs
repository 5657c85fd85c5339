//! An answer as one JSON object: every number with all the digits it has.

use crate::answer::{Answer, Look};
use crate::args::{Args, name_of};
use serde_json::{Value, json};

/// One line, keys in the order of the documentation.
pub fn object(args: &Args, answer: &Answer) -> Value {
    let mut object = json!({
        "rgb": numbers(answer.rgb),
        "space": name_of(args.space),
        "method": name_of(args.method),
        "status": answer.status,
        "wavelengths_nm": numbers(answer.spectrum.iter().map(|(nm, _)| *nm)),
        "spectrum": numbers(answer.spectrum.iter().map(|(_, share)| *share)),
        "roundtrip_rgb": numbers(answer.roundtrip),
        "delta_e2000": single(answer.delta_e2000),
        "linear": args.linear,
        "grid": args.grid,
        "beyond": args.beyond().map(name_of),
        "lights": answer.looks.iter().map(look).collect::<Vec<_>>(),
    });
    if let Some(kept) = answer.kept {
        object["kept"] = single(kept);
    }
    if let Some(sample) = &answer.sample {
        object["sample"] = json!(sample);
    }
    object
}

fn look(look: &Look) -> Value {
    let [r, g, b] = look.srgb;
    json!({
        "name": look.light,
        "XYZ": numbers(look.xyz.to_array()),
        "lab": numbers([look.lab.l, look.lab.a, look.lab.b]),
        "hex": format!("#{r:02x}{g:02x}{b:02x}"),
    })
}

fn numbers(values: impl IntoIterator<Item = f32>) -> Value {
    values.into_iter().map(single).collect()
}

/// An f32 with the fewest digits that bring it back: 0.3127 rather than 0.3127000033855438.
fn single(value: f32) -> Value {
    value.to_string().parse::<f64>().map_or(Value::Null, Value::from)
}
