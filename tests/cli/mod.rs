//! Runs an example as a user does, and reads what it says. Which one, the test file names as its `EXAMPLE`.
#![allow(dead_code, reason = "each test file uses a part")]

use crate::EXAMPLE;
use serde_json::Value;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::OnceLock;

pub struct Outcome {
    pub code: Option<i32>,
    pub out: String,
    pub err: String,
}

/// Where cargo puts the example; built here, because `cargo test --test` does not.
fn binary() -> &'static Path {
    static BINARY: OnceLock<PathBuf> = OnceLock::new();
    BINARY.get_or_init(|| {
        let mut cargo = Command::new(env!("CARGO"));
        cargo.current_dir(env!("CARGO_MANIFEST_DIR"));
        cargo.args(["build", "--quiet", "--example", EXAMPLE, "--message-format=json"]);
        if !cfg!(debug_assertions) {
            cargo.arg("--release");
        }
        let built = cargo.stderr(Stdio::inherit()).output().expect("cargo runs");
        assert!(built.status.success(), "the example does not build");
        let messages = String::from_utf8(built.stdout).expect("cargo speaks UTF-8");
        let artifacts = messages.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
        let path = artifacts
            .filter(|message| message["target"]["name"] == EXAMPLE)
            .find_map(|message| message["executable"].as_str().map(PathBuf::from));
        path.expect("cargo names the executable")
    })
}

/// Runs with `stdout` and reads from pipes.
pub fn start(arguments: &[&str], stdout: impl Into<Stdio>) -> Child {
    Command::new(binary())
        .args(arguments)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .stdin(Stdio::piped())
        .stdout(stdout)
        .stderr(Stdio::piped())
        .spawn()
        .expect("the example runs")
}

pub fn run_with(input: impl AsRef<[u8]>, arguments: &[&str]) -> Outcome {
    let mut child = start(arguments, Stdio::piped());
    // A program that refuses its options does not read.
    let _ = child.stdin.take().expect("a pipe").write_all(input.as_ref());
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

pub fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is not a number"))
}

pub fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap_or_else(|| panic!("{value} is no array")).iter().map(number).collect()
}

#[track_caller]
pub fn assert_near(value: &Value, expected: f64, tolerance: f64) {
    let found = number(value);
    assert!((found - expected).abs() <= tolerance, "{found} is not {expected} within {tolerance}");
}

#[track_caller]
pub fn assert_all_near(value: &Value, expected: &[f64], tolerance: f64) {
    let found = numbers(value);
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() <= tolerance, "{found} is not {expected} within {tolerance}");
    }
}

/// A file of this run's own below cargo's.
pub fn file(name: &str, text: &str) -> String {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{EXAMPLE}-{name}"));
    fs::write(&path, text).expect("a scratch file");
    path.to_str().expect("UTF-8").to_owned()
}

/// A directory of this run's own below cargo's.
pub fn scratch(name: &str) -> PathBuf {
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{EXAMPLE}-{name}"));
    let _ = fs::remove_dir_all(&directory);
    fs::create_dir_all(&directory).expect("a scratch directory");
    directory
}

/// It ended with exit code 2 and one line: that starts so, has this word in it, and says what to do.
#[track_caller]
pub fn assert_refused(outcome: &Outcome, start: &str, word: &str) {
    let message = &outcome.err;
    assert_eq!((outcome.code, outcome.out.as_str()), (Some(2), ""), "{message:?}");
    assert_eq!(message.lines().count(), 1, "{message:?}");
    assert!(message.ends_with('\n') && !message.trim_end().contains(|c: char| c.is_control()), "{message:?}");
    assert!(message.starts_with(start), "{message:?} does not start with {start:?}");
    assert!(message.contains(word), "{message:?} does not say {word:?}");
    assert!(message.contains(';'), "{message:?} does not say what to do");
}
