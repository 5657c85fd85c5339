//! Runs the program on command lines and files that a generator wrote, with numbers over all of f64.
//!
//! Whatever it gets, the program ends with exit code 0, 1 or 2 and without a panic; it writes no NaN, no
//! infinity and no null without a note; its pictures are XML; and it changes no file outside the directory of
//! its pictures. [`seeds`] says how to run more cases, or some again.

mod dice;
pub mod input;
mod measure;

use crate::fuzz::input::{COMMANDS, Run, run_of};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// The longest that a picture and a report should be, in bytes.
const LONGEST: usize = 1_000_000;

/// Returns the first seed and the number of seeds, each of which makes one run of every command:
/// `NANOSPECTRA_FUZZ_SEED=7 NANOSPECTRA_FUZZ_RUNS=1` repeats the runs of seed 7.
fn seeds() -> (u64, u64) {
    let number = |name: &str| {
        let text = std::env::var(name).ok()?;
        Some(text.parse().unwrap_or_else(|error| panic!("{name}={text}: {error}")))
    };
    (number("NANOSPECTRA_FUZZ_SEED").unwrap_or(1), number("NANOSPECTRA_FUZZ_RUNS").unwrap_or(2000))
}

#[test]
fn whatever_it_gets_the_program_answers_or_refuses() {
    let (first, count) = seeds();
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("fuzz-{first}"));
    let mut failures = Vec::new();
    // The answers of each command; the others are refusals.
    let mut answers = BTreeMap::from(COMMANDS.map(|(command, _)| (command, 0)));
    let every_run = (first..first + count).flat_map(|seed| COMMANDS.map(|command| (seed, command)));
    for (seed, command) in every_run {
        let run = run_of(seed, command);
        match tried(&folder, &run) {
            Ok(is_answer) => *answers.get_mut(command.0).expect("a command") += u64::from(is_answer),
            Err(what) => {
                let files: String =
                    run.files.iter().map(|(name, text)| format!("--- {name}\n{text}\n")).collect();
                failures.push(format!("seed {seed}: {what}\n{:?}\n{files}", run.arguments));
            }
        }
        if failures.len() == 10 {
            break;
        }
    }
    let _ = fs::remove_dir_all(&folder);
    assert!(failures.is_empty(), "{}", failures.join("\n\n"));
    println!("answers to {count} runs of each command: {answers:?}");
    // A generator whose every input is refused would test little.
    assert!(count < 1000 || answers.values().all(|answers| 4 * answers > count), "{answers:?}");
}

/// Runs one case in a folder of its own. Returns whether there was an answer, or what was wrong.
fn tried(folder: &Path, run: &Run) -> Result<bool, String> {
    let _ = fs::remove_dir_all(folder);
    fs::create_dir_all(folder).map_err(|error| error.to_string())?;
    for (name, text) in &run.files {
        fs::write(folder.join(name), text).map_err(|error| error.to_string())?;
    }
    let before = contents(folder);
    let output = output(folder, run);
    let [out, err] = [&output.stdout, &output.stderr].map(|bytes| String::from_utf8_lossy(bytes));
    let code = output.status.code();
    let is_answer = match code {
        Some(0) => err.is_empty(),
        // Of several spectra, those that can be measured are.
        Some(2) if run.arguments[0] == "measure" => {
            err.lines().all(|line| line.contains(';')) && !err.is_empty()
        }
        Some(2) => out.is_empty() && err.lines().count() == 1 && err.contains(';'),
        _ => return Err(format!("it ended with {:?}: {err}", output.status)),
    };
    if !is_answer {
        return Err(format!("exit code {code:?}, {} bytes on stdout and on stderr {err:?}", out.len()));
    }
    sound_report(&out, run.arguments.iter().any(|word| word == "--json"))?;

    let after = contents(folder);
    let is_picture = |path: &PathBuf| path.starts_with(folder.join("pictures"));
    let changed = before.iter().find(|(path, text)| after.get(*path) != Some(*text));
    let new = after.iter().find(|(path, _)| !before.contains_key(*path) && !is_picture(path));
    if let Some((path, _)) = changed.or(new) {
        return Err(format!("{} has changed", path.display()));
    }
    for (path, text) in after.iter().filter(|(path, _)| is_picture(path)) {
        sound_picture(text).map_err(|what| format!("{}: {what}", path.display()))?;
    }
    Ok(code == Some(0) || !out.is_empty())
}

fn output(folder: &Path, run: &Run) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_nanospectra"))
        .args(&run.arguments)
        .current_dir(folder)
        .env("TMPDIR", folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program runs");
    // A program that refuses its options does not read.
    let _ = child.stdin.take().expect("a pipe").write_all(run.stdin.as_bytes());
    child.wait_with_output().expect("the program ends")
}

/// Returns every file below a folder with its text.
fn contents(folder: &Path) -> BTreeMap<PathBuf, String> {
    let mut files = BTreeMap::new();
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            files.extend(contents(&path));
        } else {
            files.insert(
                path.clone(),
                String::from_utf8_lossy(&fs::read(&path).unwrap_or_default()).into_owned(),
            );
        }
    }
    files
}

/// Returns the word in a text that stands for a number that is none.
fn no_number(text: &str) -> Option<&str> {
    let words = text.split(|c: char| !c.is_alphanumeric());
    words.into_iter().find(|word| ["nan", "inf", "infinity"].contains(&word.to_lowercase().as_str()))
}

fn sound_report(out: &str, is_json: bool) -> Result<(), String> {
    if out.len() > LONGEST {
        return Err(format!("{} bytes of report", out.len()));
    }
    if let Some(word) = no_number(out) {
        return Err(format!("the report says {word}:\n{out}"));
    }
    for line in out.lines().filter(|_| is_json) {
        let object: Value = serde_json::from_str(line).map_err(|error| format!("{error}: {line}"))?;
        let notes: Vec<&str> =
            object["notes"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
        if let Some(path) = unexplained(&object, "", &notes) {
            return Err(format!("{path} is null without a note: {line}"));
        }
    }
    Ok(())
}

/// Returns the path of a null without a note beside it, or in the list of notes about its path or one above.
fn unexplained(value: &Value, path: &str, notes: &[&str]) -> Option<String> {
    match value {
        Value::Null => {
            let keys =
                notes.iter().filter_map(|note| note.split_once(": ")).flat_map(|(keys, _)| keys.split(", "));
            let is_above = |key: &str| path == key || path.starts_with(&format!("{key}."));
            (!keys.into_iter().any(is_above)).then(|| path.to_owned())
        }
        Value::Array(values) => values.iter().find_map(|value| unexplained(value, path, notes)),
        Value::Object(object) if object.get("note").is_some_and(Value::is_string) => None,
        Value::Object(object) => object.iter().find_map(|(key, value)| {
            unexplained(value, &if path.is_empty() { key.clone() } else { format!("{path}.{key}") }, notes)
        }),
        _ => None,
    }
}

fn sound_picture(text: &str) -> Result<(), String> {
    let document = roxmltree::Document::parse(text).map_err(|error| error.to_string())?;
    if text.len() > LONGEST {
        return Err(format!("{} bytes of picture", text.len()));
    }
    for node in document.descendants() {
        let attributes = node.attributes().map(|attribute| attribute.value());
        if let Some(word) = attributes.chain(node.text()).find_map(no_number) {
            return Err(format!("the picture says {word}"));
        }
    }
    Ok(())
}
