//! The sections `# Accuracy` and `# Cost` of the documentation, in the order of files and lines.

use std::fs;
use std::path::{Path, PathBuf};

use super::numbers::numbers;

pub const ROOT: &str = env!("CARGO_MANIFEST_DIR");

pub struct Section {
    /// File below `src`, item, and what the section is: `color/cct.rs cct Accuracy`.
    pub title: String,
    pub numbers: Vec<String>,
}

/// Every section in `src`.
pub fn sections() -> Vec<Section> {
    let mut found = Vec::new();
    for (name, text) in sources() {
        let lines: Vec<&str> = text.lines().map(str::trim_start).collect();
        for (k, line) in lines.iter().enumerate() {
            let ("/// # Accuracy" | "/// # Cost" | "//! # Accuracy" | "//! # Cost") = *line else { continue };
            let kind = line.rsplit(' ').next().unwrap_or_default();
            let text: Vec<&str> = lines.iter().skip(k + 1).map_while(|line| prose(line)).collect();
            let item = lines.iter().skip(k + 1 + text.len()).find_map(|line| item(line));
            let item = item.unwrap_or_else(|| panic!("{name}:{}: of which item?", k + 1));
            found.push(Section { title: format!("{name} {item} {kind}"), numbers: numbers(&text.join(" ")) });
        }
    }
    found
}

/// The files below `src` and their text, by name.
pub fn sources() -> Vec<(String, String)> {
    let source = Path::new(ROOT).join("src");
    let mut files = Vec::new();
    find_files(&source, &mut files);
    files.sort();
    let name =
        |file: &Path| file.strip_prefix(&source).expect("below src").to_string_lossy().replace('\\', "/");
    files.iter().map(|file| (name(file), fs::read_to_string(file).expect("a source"))).collect()
}

fn find_files(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            find_files(&path, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
}

/// The text of a line of documentation, if neither the next section nor an example begins there.
fn prose(line: &str) -> Option<&str> {
    let text = line.strip_prefix("///").or_else(|| line.strip_prefix("//!"))?.trim_start();
    (!text.starts_with("# ") && !text.starts_with("```")).then_some(text)
}

/// The name that a line declares.
fn item(line: &str) -> Option<&str> {
    if line.starts_with("//") || line.starts_with('#') {
        return None;
    }
    let mut words = line.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty());
    words.find(|word| ["fn", "struct", "static", "enum", "trait", "type"].contains(word))?;
    words.next()
}
