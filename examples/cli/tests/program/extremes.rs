//! Inputs at the ends of what numbers can hold: answers in words, and pictures that can be drawn.

use crate::run::{Outcome, Program, files};
use serde_json::Value;
use std::fs;

const MEASURE: Program = Program("measure", module_path!());
const SENSOR: Program = Program("sensor", module_path!());
const PAINT: Program = Program("paint", module_path!());
const SCENE: Program = Program("scene", module_path!());

/// It answered, in words where there is no number, and its pictures have finite places.
#[track_caller]
fn assert_sound(outcome: &Outcome, directory: &std::path::Path) {
    let Outcome { code, out, err } = outcome;
    assert!(matches!(code, Some(0 | 2)), "{code:?} {err}");
    assert_eq!(err.is_empty(), *code == Some(0), "{err}");
    assert!(!out.contains("NaN") && !out.contains("inf "), "{out}");
    for name in files(directory) {
        let text = fs::read_to_string(directory.join(&name)).expect("a picture");
        assert!(text.len() < 500_000 && !text.contains("NaN") && !text.contains("inf"), "{name}");
        roxmltree::Document::parse(&text).expect("XML");
    }
}

#[test]
fn spectra_of_every_size_are_drawn() {
    let sizes = ["3.4e38", "1e-45", "3.6e38", "1e39", "1e-310", "5e-324", "1.7e308", "-3.4e38", "0"];
    for (k, size) in sizes.into_iter().enumerate() {
        for (j, options) in [&[][..], &["--reflectance"], &["--unit", "absolute"]].into_iter().enumerate() {
            let directory = MEASURE.scratch(&format!("size-{k}-{j}"));
            let svg = ["-", "--svg", directory.to_str().expect("UTF-8")];
            let outcome =
                MEASURE.run_with(format!("nm,a\n380,{size}\n780,{size}\n"), &[&svg, options].concat());
            assert_sound(&outcome, &directory);
        }
    }
}

#[test]
fn lights_of_every_size_have_a_level() {
    let lux = |size: &str| {
        let table = format!("nm,a\n380,{size}\n780,{size}\n");
        crate::run::number(&MEASURE.json_with(&table, &["--unit", "absolute", "-"])[0]["lux"])
    };
    let one = lux("1");
    for (size, value) in
        [("1e-310", 1e-310), ("1e-300", 1e-300), ("1e-45", 1e-45), ("1e39", 1e39), ("1e300", 1e300)]
    {
        assert!((lux(size) / value / one - 1.0).abs() < 1e-6, "{size}: {} is not {}", lux(size), one * value);
    }
}

#[test]
fn colors_too_large_for_a_spectrum_are_refused() {
    let directory = PAINT.scratch("large");
    let svg = directory.to_str().expect("UTF-8");
    let large = PAINT.run(&["1e37,1e37,1e37", "--linear", "--method", "basis", "--svg", svg]);
    assert_sound(&large, &directory);
    assert_eq!((large.code, files(&directory).len()), (Some(2), 0), "{}", large.out);
    assert_sound(&PAINT.run(&["1e20,1e30,-1e38", "--linear"]), &directory);
    let adobe = PAINT.run(&["--rgb", "1e38,0.45,711", "--space", "adobe", "--linear"]);
    assert_sound(&adobe, &directory);
    assert!(adobe.code == Some(2) && adobe.err.contains("too large"), "{}", adobe.err);
}

/// The light between two wavelengths, on a white surface.
fn narrow(grid: &str, from: f32, to: f32) -> Value {
    let points = format!("[[{}, 0], [{from}, 1], [{to}, 1], [{}, 0]]", from - 0.5, to + 0.5);
    let toml = format!("grid = \"{grid}\"\n[lamp]\npoints = {points}\n[[part]]\nsurface.flat = 0.5\n");
    SCENE.written(&format!("narrow-{from}-{to}"), &toml)
}

/// A smooth curve through the averages of a narrow lamp swings below zero, and such a lamp would be no white.
#[test]
fn narrow_lamps_have_a_color() {
    let green = narrow("bins:16,380,730", 500.0, 510.0);
    let lab = crate::run::numbers(&green["lab"]);
    assert!((lab[0] - 76.07).abs() < 0.01 && lab[1].abs() < 0.01 && lab[2].abs() < 0.01, "{lab:?}");
    assert!(crate::run::numbers(&green["XYZ"]).iter().all(|value| *value > 0.0), "{green}");
    assert!(green["notes"][0].as_str().is_some_and(|note| note.contains("constant within each band")));
    for grid in ["bins:60,380,730", "nodes:81,380,780", "bins:16,380,730"] {
        for nm in [400.0, 450.0, 475.0, 505.0, 520.0, 560.0, 600.0, 650.0] {
            let answer = narrow(grid, nm - 2.0, nm + 2.0);
            assert!(
                crate::run::numbers(&answer["XYZ"]).iter().all(|value| *value >= 0.0),
                "{nm} on {grid}: {answer}"
            );
        }
    }
}

/// The eye of CIE 1931 has no Z at 700 nm at all: there is no white, and words say so.
#[test]
fn a_lamp_that_is_no_white_is_said_to_be_none() {
    let red = narrow("bins:60,380,730", 698.0, 702.0);
    assert_eq!((&red["lab"], &red["bill"][0]["without_delta_e2000"]), (&Value::Null, &Value::Null));
    assert_eq!(red["hex_is_clipped"], true, "{red}");
    let notes = red["notes"].to_string();
    assert!(
        notes.contains("the lamp is no white; there is no Lab, and the colors are not adapted"),
        "{notes}"
    );
    assert!(red["hex"].as_str().is_some_and(|hex| hex.ends_with("0000")), "{}", red["hex"]);
    let report = SCENE.says(&[&SCENE.file(
        "red.toml",
        "title = \"red\"\n[lamp]\npoints = [[697,0],[698,1],[702,1],[703,0]]\n[[part]]\nfilter.flat = 0.5\n",
    )]);
    assert!(report.contains("none, the lamp is no white") && !report.contains("NaN"), "{report}");
}

#[test]
fn sensors_of_every_size_have_words_for_what_is_unknown() {
    let log = "time,gain,time_ms,full_scale,a,b\n0,1,1,60000,500,5\n1e-39,1,1,60000,500,7\n";
    let toml =
        |scale: &str| format!("nm,a,b\n400,{scale},0\n500,{scale},{scale}\n600,0,{scale}\n700,0,{scale}\n");
    let directory = SENSOR.scratch("none");
    for (k, scale) in ["1e30", "1e38", "1e-30", "1e-45", "1"].into_iter().enumerate() {
        let curves = SENSOR.file(&format!("curves-{k}.csv"), &toml(scale));
        for noise in [&[][..], &["--read-counts", "3.4e38"], &["--electrons-per-count", "1e-45"]] {
            for unit in [&[][..], &["--unit", "absolute"]] {
                let fixed =
                    ["--sensor", "custom", "-", "--responsivity", &curves, "--flicker-hz", "1e-38,100"];
                let arguments = [&fixed[..], noise, unit].concat();
                let text = SENSOR.run_with(log, &arguments);
                assert_sound(&text, &directory);
                assert!(
                    !text.out.contains("too large per second") && !text.out.contains("undefined"),
                    "{}",
                    text.out
                );
                let json = SENSOR.run_with(log, &[&arguments[..], &["--json"]].concat());
                assert_sound(&json, &directory);
            }
        }
    }
}
