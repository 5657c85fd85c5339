//! An answer as one JSON object, in which every number has all its digits.

use crate::output::json::{numbers, single};
use crate::output::tint;
use crate::paint::answer::{Answer, Look};
use crate::paint::args::Args;
use crate::usage::name_of;
use serde_json::{Value, json};

/// Returns why a key of the object is null.
pub fn why(path: &str) -> Option<&'static str> {
    (path == "beyond")
        .then_some("only the method sigmoid has a choice of what to do with colors it cannot reach")
}

/// The object for one color, with its keys in the order that `--help` lists them.
pub fn object(args: &Args, answer: &Answer) -> Value {
    let mut object = json!({
        "rgb": numbers(answer.rgb),
        "space": name_of(args.space),
        "method": name_of(args.method),
        "status": answer.status,
        "wavelengths_nm": numbers(answer.spectrum.iter().map(|(nm, _)| *nm)),
        "spectrum": numbers(answer.spectrum.iter().map(|(_, share)| *share)),
        "values_are": "averages over bands",
        "roundtrip_rgb": numbers(answer.roundtrip),
        "delta_e2000": single(answer.delta_e2000),
        "linear": args.linear,
        "grid": args.grid,
        "beyond": args.beyond().map(name_of),
        "lights": answer.looks.iter().map(look).collect::<Vec<_>>(),
        "notes": [],
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
    json!({
        "name": look.light,
        "XYZ": numbers(look.xyz.to_array()),
        "lab": numbers([look.lab.l, look.lab.a, look.lab.b]),
        "hex": tint::hex(look.srgb),
    })
}
