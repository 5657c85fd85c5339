//! Numbers become text in one place, which knows those that do not exist.

use nanospectra_cli::output::{json, number};
use serde_json::{Value, json};
use std::fs;
use std::path::{Path, PathBuf};

fn sources(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    entries.flat_map(|path| if path.is_dir() { sources(&path) } else { vec![path] }).collect()
}

/// Returns the placeholders of format strings that ask for decimals, an exponent or `Debug`.
fn formats(source: &str) -> Vec<&str> {
    let inside = source.split('{').skip(1).filter_map(|rest| rest.split_once('}')).map(|(inside, _)| inside);
    let of_numbers = |inside: &&str| {
        let spec = inside.split_once(':').filter(|_| !inside.contains([' ', '\n', ',', '{']));
        spec.is_some_and(|(_, spec)| spec.contains('.') || spec.ends_with(['e', 'E', '?']))
    };
    inside.filter(of_numbers).collect()
}

#[test]
fn only_one_file_formats_numbers() {
    let all = sources(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/src")));
    assert!(all.len() > 50);
    for path in all.iter().filter(|path| !path.ends_with("output/number.rs")) {
        let source = fs::read_to_string(path).expect("a source");
        assert_eq!(formats(&source), Vec::<&str>::new(), "{}: use output::number", path.display());
    }
}

#[test]
fn a_number_that_does_not_exist_is_a_word() {
    for (value, word) in
        [(f64::NAN, "undefined"), (f64::INFINITY, "too large"), (-f64::INFINITY, "too large (negative)")]
    {
        let texts = [
            number::fixed(value, 2),
            number::signed(value, 2),
            number::significant(value, 5),
            number::at_least_four(value),
            number::shortest(value),
            number::all([value], 1, " "),
        ];
        assert!(texts.iter().all(|text| text == word), "{texts:?}");
    }
}

#[test]
fn numbers_of_every_size_are_short() {
    for value in [5e-324, -1e-45, 1e-6, 1234.5678, -9.9e8, 1e9, 3.4e38, 1.7e308] {
        let texts = [
            number::fixed(value, 5),
            number::signed(value, 5),
            number::significant(value, 6),
            number::at_least_four(value),
            number::shortest(value),
        ];
        for text in texts {
            assert!(text.len() <= 23, "{text}");
            assert!(
                text.parse::<f64>().is_ok_and(|read| (read - value).abs() <= 1e-3 * value.abs().max(1.0)),
                "{text}"
            );
        }
    }
}

/// What JSON says is the f64 itself, or the shortest text of the f32 that it is.
#[test]
fn json_numbers_are_those_that_were_computed() {
    for value in [1e-40, 1.4e-45, 5e-324, -3.2e-39, 1.0 / 3.0, 1e300, 0.0] {
        assert_eq!(json::number(value), Value::from(value));
    }
    // These are exactly an f32; below the smallest normal one its digits would be another f64.
    let subnormal = f64::from(f32::from_bits(70_001));
    assert_eq!(json::number(subnormal), Value::from(subnormal));
    assert_eq!(json::number(f64::from(0.3127_f32)).to_string(), "0.3127");
}

#[test]
fn every_null_of_json_gets_a_note() {
    let object = json!({
        "a": null,
        "b": [1, null, null],
        "c": { "d": null, "e": { "f": null, "note": "it is far" } },
        "g": { "h": null },
        "notes": ["g: it is dark"],
    });
    let line = json::line(object, |path| (path == "a").then_some("nobody knows"));
    let notes = serde_json::from_str::<Value>(&line).expect("JSON")["notes"].clone();
    let [dark, nobody, extreme] = &notes.as_array().expect("a list")[..] else { panic!("{notes}") };
    assert_eq!((dark, nobody), (&json!("g: it is dark"), &json!("a: nobody knows")));
    assert!(extreme.as_str().is_some_and(|note| note.starts_with("b, c.d: ")), "{extreme}");
}
