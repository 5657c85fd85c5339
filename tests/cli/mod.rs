//! Runs the colorimeter as a user does, and reads what it says.
#![expect(dead_code, reason = "each test file uses a part")]

use serde_json::Value;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::OnceLock;
/// In the order of the documentation; more may follow.
pub const KEYS: [&str; 21] = [
    "name",
    "XYZ",
    "xy",
    "uv1960",
    "uv1976",
    "cct_k",
    "duv",
    "lux",
    "ler_lm_per_w",
    "lab",
    "srgb",
    "hex",
    "dominant_wavelength_nm",
    "purity",
    "cri_ra",
    "cri_r",
    "tm30_rf",
    "tm30_rg",
    "melanopic_edi_ratio",
    "ppfd",
    "notes",
];

pub struct Outcome {
    pub code: Option<i32>,
    pub out: String,
    pub err: String,
}

/// Where cargo puts the example; built here, because `cargo test --test colorimeter` does not.
pub fn binary() -> &'static Path {
    static BINARY: OnceLock<PathBuf> = OnceLock::new();
    BINARY.get_or_init(|| {
        let mut cargo = Command::new(env!("CARGO"));
        cargo.current_dir(env!("CARGO_MANIFEST_DIR"));
        cargo.args(["build", "--quiet", "--example", "colorimeter", "--message-format=json"]);
        if !cfg!(debug_assertions) {
            cargo.arg("--release");
        }
        let built = cargo.stderr(Stdio::inherit()).output().expect("cargo runs");
        assert!(built.status.success(), "the example does not build");
        let messages = String::from_utf8(built.stdout).expect("cargo speaks UTF-8");
        let artifacts = messages.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
        let path = artifacts
            .filter(|message| message["target"]["name"] == "colorimeter")
            .find_map(|message| message["executable"].as_str().map(PathBuf::from));
        path.expect("cargo names the executable")
    })
}

pub fn run_with(input: &str, arguments: &[&str]) -> Outcome {
    let mut child = Command::new(binary())
        .args(arguments)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the example runs");
    // A program that refuses its options does not read.
    let _ = child.stdin.take().expect("a pipe").write_all(input.as_bytes());
    let output = child.wait_with_output().expect("the example ends");
    let text = |bytes| String::from_utf8(bytes).expect("the report is UTF-8");
    Outcome { code: output.status.code(), out: text(output.stdout), err: text(output.stderr) }
}

pub fn run(arguments: &[&str]) -> Outcome {
    run_with("", arguments)
}

/// Runs with `--json` and reads the objects.
pub fn json_with(input: &str, arguments: &[&str]) -> Vec<Value> {
    let outcome = run_with(input, &[&["--json"], arguments].concat());
    assert_eq!((outcome.code, outcome.err.as_str()), (Some(0), ""), "{arguments:?}");
    outcome.out.lines().map(|line| serde_json::from_str(line).expect("one object a line")).collect()
}

pub fn json(arguments: &[&str]) -> Vec<Value> {
    json_with("", arguments)
}

/// The reading of one column of a file below `tables/`.
pub fn table(file: &str, name: &str, arguments: &[&str]) -> Value {
    let path = format!("tables/{file}.csv");
    let readings = json(&[&[path.as_str()], arguments].concat());
    readings.into_iter().find(|reading| reading["name"] == name).expect("the table has the column")
}

pub fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is not a number"))
}

pub fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap_or_else(|| panic!("{value} is no array")).iter().map(number).collect()
}

pub fn assert_near(value: &Value, expected: f64, tolerance: f64) {
    let found = number(value);
    assert!((found - expected).abs() <= tolerance, "{found} is not {expected} within {tolerance}");
}

pub fn assert_all_near(value: &Value, expected: &[f64], tolerance: f64) {
    let found = numbers(value);
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() <= tolerance, "{found} is not {expected} within {tolerance}");
    }
}

pub fn notes(reading: &Value) -> Vec<&str> {
    reading["notes"].as_array().expect("notes").iter().filter_map(Value::as_str).collect()
}

pub fn has_note(reading: &Value, key: &str, word: &str) -> bool {
    let start = format!("{key}: ");
    notes(reading).iter().any(|note| note.starts_with(&start) && note.contains(word))
}

/// A directory of this run's own below cargo's.
pub fn scratch(name: &str) -> PathBuf {
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("colorimeter-{name}"));
    let _ = fs::remove_dir_all(&directory);
    fs::create_dir_all(&directory).expect("a scratch directory");
    directory
}
