//! Runs the program as a user does, and reads what it says.

use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::{Mutex, PoisonError};
use std::thread::{self, ThreadId};

/// A command of the program, and the tests that run it, which have files of their own.
pub struct Program(pub &'static str, pub &'static str);

pub struct Outcome {
    pub code: Option<i32>,
    pub out: String,
    pub err: String,
}

impl Program {
    /// Runs with `stdout` and reads from pipes.
    pub fn start(&self, arguments: &[&str], stdout: impl Into<Stdio>) -> Child {
        Command::new(env!("CARGO_BIN_EXE_nanospectra"))
            .args(Some(self.0).filter(|command| !command.is_empty()))
            .args(arguments)
            .current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
            .stdin(Stdio::piped())
            .stdout(stdout)
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program runs")
    }

    pub fn run_with(&self, input: impl AsRef<[u8]>, arguments: &[&str]) -> Outcome {
        let mut child = self.start(arguments, Stdio::piped());
        // A program that refuses its options does not read.
        let _ = child.stdin.take().expect("a pipe").write_all(input.as_ref());
        let output = child.wait_with_output().expect("the program ends");
        let text = |bytes| String::from_utf8(bytes).expect("the report is UTF-8");
        Outcome { code: output.status.code(), out: text(output.stdout), err: text(output.stderr) }
    }

    /// Runs in a shell, after `setup` and with redirected streams.
    #[cfg(unix)]
    pub fn run_in_shell(&self, setup: &str, streams: &str, arguments: &[&str]) -> Outcome {
        let output = Command::new("sh")
            .args(["-c", &format!("{setup}\nexec \"$0\" \"$@\" {streams}")])
            .arg(env!("CARGO_BIN_EXE_nanospectra"))
            .args(Some(self.0).filter(|command| !command.is_empty()))
            .args(arguments)
            .stdin(Stdio::null())
            .output()
            .expect("the shell runs");
        let text = |bytes| String::from_utf8(bytes).expect("the report is UTF-8");
        Outcome { code: output.status.code(), out: text(output.stdout), err: text(output.stderr) }
    }

    pub fn run(&self, arguments: &[&str]) -> Outcome {
        self.run_with("", arguments)
    }

    /// What it says to this input, without an error.
    pub fn says_to(&self, input: impl AsRef<[u8]>, arguments: &[&str]) -> String {
        let Outcome { code, out, err } = self.run_with(input, arguments);
        assert_eq!((code, err.as_str()), (Some(0), ""), "{arguments:?}");
        out
    }

    pub fn says(&self, arguments: &[&str]) -> String {
        self.says_to("", arguments)
    }

    /// [`assert_refused`] of a run.
    #[track_caller]
    pub fn refuses(&self, arguments: &[&str], start: &str, word: &str) {
        assert_refused(&self.run(arguments), start, word);
    }

    #[track_caller]
    pub fn refuses_of(&self, input: impl AsRef<[u8]>, arguments: &[&str], start: &str, word: &str) {
        assert_refused(&self.run_with(input, arguments), start, word);
    }

    /// Its help has all of these words, and its version is the package's.
    pub fn assert_helps(&self, words: &str) {
        let help = self.says(&["--help"]);
        for word in words.split(' ') {
            assert!(help.contains(word), "{word}");
        }
        let version = format!("nanospectra-{} {}\n", self.0, env!("CARGO_PKG_VERSION"));
        assert_eq!(self.says(&["--version"]), version);
    }

    /// Whoever reads its answers stops before the first one comes: no error.
    pub fn assert_may_be_left_unread(&self, input: &str, arguments: &[&str]) {
        let mut child = self.start(arguments, Stdio::piped());
        drop(child.stdout.take());
        child.stdin.take().expect("a pipe").write_all(input.as_bytes()).expect("it reads");
        let output = child.wait_with_output().expect("it ends");
        assert_eq!((output.status.code(), output.stderr.as_slice()), (Some(0), &b""[..]));
    }

    /// Runs with `--json` and reads the objects.
    pub fn json_with(&self, input: &str, arguments: &[&str]) -> Vec<Value> {
        self.says_to(input, &[&["--json"], arguments].concat())
            .lines()
            .map(|line| serde_json::from_str(line).expect("one object a line"))
            .collect()
    }

    pub fn json(&self, arguments: &[&str]) -> Vec<Value> {
        self.json_with("", arguments)
    }

    /// The only object.
    pub fn one(&self, arguments: &[&str]) -> Value {
        let [answer] = <[Value; 1]>::try_from(self.json(arguments)).expect("one answer");
        answer
    }

    /// The answer to a scene written here.
    pub fn written(&self, name: &str, toml: &str) -> Value {
        self.one(&[&self.file(&format!("{name}.toml"), &format!("title = \"test\"\n{toml}"))])
    }

    /// A file of these tests' own below cargo's.
    pub fn file(&self, name: &str, text: &str) -> String {
        let path = self.path(name);
        fs::write(&path, text).expect("a scratch file");
        path.to_str().expect("UTF-8").to_owned()
    }

    /// A directory of these tests' own below cargo's.
    pub fn scratch(&self, name: &str) -> PathBuf {
        let directory = self.path(name);
        let _ = fs::remove_dir_all(&directory);
        fs::create_dir_all(&directory).expect("a scratch directory");
        directory
    }

    /// A path of this name, which only one test may use: tests run at the same time.
    fn path(&self, name: &str) -> PathBuf {
        static USERS: Mutex<BTreeMap<PathBuf, ThreadId>> = Mutex::new(BTreeMap::new());
        let name = format!("{}-{name}", self.1.trim_start_matches("program::"));
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(&name);
        let this = thread::current().id();
        let mut users = USERS.lock().unwrap_or_else(PoisonError::into_inner);
        let user = *users.entry(path.clone()).or_insert(this);
        assert_eq!(user, this, "another test writes {name}, too");
        path
    }
}

/// The names of the files in a directory, in their order.
pub fn files(directory: &Path) -> Vec<String> {
    let entries = fs::read_dir(directory).expect("the directory was made");
    let names = entries.map(|entry| entry.expect("an entry").file_name());
    let mut names: Vec<String> = names.map(|name| name.into_string().expect("UTF-8")).collect();
    names.sort();
    names
}

/// The keys of an object in their order, with spaces between.
pub fn keys(object: &Value) -> String {
    object.as_object().expect("an object").keys().map(String::as_str).collect::<Vec<_>>().join(" ")
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
