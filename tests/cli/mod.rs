//! Runs the study of costs as a user does, and reads what it says.

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
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
        cargo.args(["build", "--quiet", "--example", "cost", "--message-format=json"]);
        if !cfg!(debug_assertions) {
            cargo.arg("--release");
        }
        let built = cargo.stderr(Stdio::inherit()).output().expect("cargo runs");
        assert!(built.status.success(), "the example does not build");
        let messages = String::from_utf8(built.stdout).expect("cargo speaks UTF-8");
        let artifacts = messages.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
        let path = artifacts
            .filter(|message| message["target"]["name"] == "cost")
            .find_map(|message| message["executable"].as_str().map(PathBuf::from));
        path.expect("cargo names the executable")
    })
}

pub fn run(arguments: &[&str]) -> Outcome {
    let output = Command::new(binary())
        .args(arguments)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .stdin(Stdio::null())
        .output()
        .expect("the example runs");
    let text = |bytes| String::from_utf8(bytes).expect("the report is UTF-8");
    Outcome { code: output.status.code(), out: text(output.stdout), err: text(output.stderr) }
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
