//! Runs paint as a user does, and reads what it says.
#![allow(dead_code, reason = "each test file uses a part")]

use crate::cli::Outcome;
use serde_json::Value;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::OnceLock;

/// Where cargo puts the example; built here, because `cargo test --test paint` does not.
fn binary() -> &'static Path {
    static BINARY: OnceLock<PathBuf> = OnceLock::new();
    BINARY.get_or_init(|| {
        let mut cargo = Command::new(env!("CARGO"));
        cargo.current_dir(env!("CARGO_MANIFEST_DIR"));
        cargo.args(["build", "--quiet", "--example", "paint", "--message-format=json"]);
        if !cfg!(debug_assertions) {
            cargo.arg("--release");
        }
        let built = cargo.stderr(Stdio::inherit()).output().expect("cargo runs");
        assert!(built.status.success(), "the example does not build");
        let messages = String::from_utf8(built.stdout).expect("cargo speaks UTF-8");
        let artifacts = messages.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
        let path = artifacts
            .filter(|message| message["target"]["name"] == "paint")
            .find_map(|message| message["executable"].as_str().map(PathBuf::from));
        path.expect("cargo names the executable")
    })
}

pub fn run_with(input: impl AsRef<[u8]>, arguments: &[&str]) -> Outcome {
    let mut child = Command::new(binary())
        .args(arguments)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the example runs");
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
