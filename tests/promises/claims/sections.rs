//! The sections of what is written about the crate, and the numbers in them.

use std::collections::BTreeMap;
use std::fs;
use std::ops::Range;
use std::path::Path;

use super::numbers::{numbers, plain};

pub const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// A number where it stands.
#[derive(Debug)]
pub struct Number {
    pub at: Range<usize>,
    /// Without separators of thousands.
    pub text: String,
    /// The word behind it.
    pub unit: String,
    /// Between backticks: an input or a constant, as code has it.
    pub in_code: bool,
}

impl Number {
    /// Does it look like something that was measured?
    pub fn is_bound(&self) -> bool {
        !self.in_code && (self.text.contains('.') || self.text.contains("e-"))
    }
}

/// Numbers of a section, in their order.
#[derive(Debug, Default)]
pub struct Section {
    /// Below the root of the repository.
    pub file: String,
    pub numbers: Vec<Number>,
}

/// The text of each file that is read, by its path below the root.
pub type Texts = BTreeMap<String, String>;

pub fn texts() -> Texts {
    let mut texts = Texts::new();
    for file in ["README.md", "Cargo.toml"] {
        texts.insert(file.into(), fs::read_to_string(Path::new(ROOT).join(file)).expect(file));
    }
    add_sources(&Path::new(ROOT).join("src"), &mut texts);
    texts
}

fn add_sources(folder: &Path, texts: &mut Texts) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            add_sources(&path, texts);
        } else if path.extension().is_some_and(|extension| extension == "rs" || extension == "md") {
            let name = path.strip_prefix(ROOT).expect("below the root").to_string_lossy().replace('\\', "/");
            texts.insert(name, fs::read_to_string(path).expect("a source"));
        }
    }
}

/// Every section by its title: `color/cct.rs cct Accuracy`, with `Summary` for what precedes the first
/// heading and `module` for an item where a file is documented; `guide/bands.md Narrow lines` of a page;
/// `Cargo.toml description`. Those that share a title are one.
pub fn sections(texts: &Texts) -> BTreeMap<String, Section> {
    let mut found: BTreeMap<String, Section> = BTreeMap::new();
    for (file, text) in texts {
        let name = file.strip_prefix("src/").unwrap_or(file);
        let mut add = |item: &str, parts: Vec<(String, Vec<Number>)>| {
            for (heading, numbers) in parts {
                let title = [name, item, &heading].into_iter().filter(|word| !word.is_empty());
                let section = found.entry(title.collect::<Vec<_>>().join(" ")).or_default();
                section.file.clone_from(file);
                section.numbers.extend(numbers);
            }
        };
        let mut block = Block::default();
        let mut start = 0;
        for line in text.split_inclusive('\n') {
            let offset = start + line.len() - line.trim_start().len();
            start += line.len();
            let line = line.trim();
            if file.ends_with(".md") {
                block.read(offset, line);
            } else if file == "Cargo.toml" {
                if line.starts_with("description") {
                    block.parts = vec![("description".into(), Vec::new())];
                    block.read(offset, line);
                }
            } else if let Some(text) = line.strip_prefix("//!").or_else(|| line.strip_prefix("///")) {
                block.read(offset + line.len() - text.trim_start().len(), text.trim());
                block.in_module = line.starts_with("//!");
            } else if !block.parts.is_empty() && (block.in_module || !line.starts_with(['#', ')', '/'])) {
                let done = std::mem::take(&mut block);
                add(if done.in_module { "module" } else { item(line) }, done.parts);
            }
        }
        add("", block.parts);
    }
    found
}

/// Tables that a page words itself. `examples/cost` makes only the counts in them, and all of the others.
const WORDED: [&str; 2] = ["<!-- cost: counts -->", "<!-- cost: paths -->"];

/// Text below headings.
#[derive(Default)]
struct Block {
    parts: Vec<(String, Vec<Number>)>,
    in_module: bool,
    /// In an example, or in a table that `examples/cost` makes whole.
    skips: bool,
}

impl Block {
    fn read(&mut self, offset: usize, line: &str) {
        if line.starts_with("```") {
            self.skips = !self.skips;
            return;
        }
        if ["<!-- cost:", "<!-- end"].iter().any(|mark| line.starts_with(mark)) {
            self.skips = line.starts_with("<!-- cost:") && !WORDED.contains(&line);
            return;
        }
        let heading = line.trim_start_matches('#').strip_prefix(' ').filter(|_| line.starts_with('#'));
        if self.skips {
        } else if let Some(heading) = heading {
            self.parts.push((heading.into(), Vec::new()));
        } else {
            if self.parts.is_empty() {
                self.parts.push(("Summary".into(), Vec::new()));
            }
            let Some((_, known)) = self.parts.last_mut() else { return };
            if let Some(last) = known.last_mut().filter(|last| last.unit.is_empty()) {
                last.unit = first_word(line);
            }
            known.extend(numbers(line).into_iter().map(|at| Number {
                text: plain(&line[at.clone()]),
                unit: first_word(line[at.end..].trim_start()),
                in_code: line[..at.start].matches('`').count() % 2 == 1,
                at: offset + at.start..offset + at.end,
            }));
        }
    }
}

/// The word that a text begins with; empty only if the text is.
fn first_word(text: &str) -> String {
    let end = text.find(|c: char| !c.is_alphanumeric()).unwrap_or(text.len());
    if end == 0 { text.chars().take(1).collect() } else { text[..end].into() }
}

/// The name that a line declares.
fn item(line: &str) -> &str {
    const BEFORE: [&str; 13] = [
        "pub", "crate", "super", "const", "unsafe", "mut", "fn", "struct", "static", "enum", "trait", "type",
        "mod",
    ];
    let words = line.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty());
    words.into_iter().find(|word| !BEFORE.contains(word)).unwrap_or("nothing")
}
