//! No two public types of the library have the same name, so that an import says which one is meant.

use crate::claims::sections::{Texts, texts};
use std::collections::{BTreeMap, BTreeSet};

/// The public types that a file declares. (`pub trait Sealed` stands in private modules, where nobody can
/// name it.)
fn declared(text: &str) -> impl Iterator<Item = &str> {
    text.lines().filter_map(|line| {
        let (kind, rest) = line.trim_start().strip_prefix("pub ")?.split_once(' ')?;
        let name = rest.split(|c: char| !c.is_alphanumeric() && c != '_').next()?;
        let is_type = ["struct", "enum", "trait", "type", "union"].contains(&kind);
        (is_type && name != "Sealed" && !name.is_empty()).then_some(name)
    })
}

/// What a module publishes of those below it: also types that a macro makes.
fn published(text: &str) -> impl Iterator<Item = &str> {
    let uses = text.split("\npub use ").skip(1).filter_map(|rest| rest.split_once(';'));
    let below = uses.map(|(names, _)| names).filter(|names| !names.starts_with("crate::"));
    below.flat_map(|names| names.split(|c: char| !c.is_alphanumeric() && c != '_'))
}

/// Names that are declared twice, or published by two modules of which neither holds the other.
fn shared(texts: &Texts) -> BTreeSet<String> {
    let mut shared = BTreeSet::new();
    let mut files: BTreeMap<&str, &str> = BTreeMap::new();
    let mut folders: BTreeMap<&str, &str> = BTreeMap::new();
    for (file, text) in texts.iter().filter(|(file, _)| file.starts_with("src/") && file.ends_with(".rs")) {
        for name in declared(text) {
            if let Some(other) = files.insert(name, file) {
                shared.insert(format!("{name} in {other} and {file}"));
            }
        }
        // (`src/lib.rs` holds all.)
        let Some(folder) = file.strip_suffix("/mod.rs") else { continue };
        for name in published(text).filter(|name| name.starts_with(char::is_uppercase)) {
            let other = *folders.entry(name).or_insert(folder);
            if !folder.starts_with(other) && !other.starts_with(folder) {
                shared.insert(format!("{name} in {other} and {folder}"));
            }
        }
    }
    shared
}

#[test]
fn no_two_public_types_have_the_same_name() {
    assert_eq!(shared(&texts()), BTreeSet::new());
}

/// A test that cannot fail proves nothing.
#[test]
fn a_name_that_stands_twice_is_found() {
    let with = |file: &str, one: &str, other: &str| {
        let text = |module: &str, text: &str| (format!("src/{module}/{file}"), format!("\n{text}\n"));
        shared(&Texts::from([text("light", one), text("color", other)])).len()
    };
    assert_eq!(with("line.rs", "pub struct Linear;", "    pub type Linear<T> = Line<T>;"), 1);
    assert_eq!(with("line.rs", "pub enum Linear {", "pub(crate) struct Linear;"), 0);
    assert_eq!(with("line.rs", "pub struct Linear;", "pub struct Linearity;"), 0);
    assert_eq!(with("line.rs", "pub trait Sealed {}", "pub trait Sealed {}"), 0);
    assert_eq!(with("mod.rs", "pub use line::{\n    Curve,\n    Linear,\n};", "pub use made::Linear;"), 1);
    assert_eq!(with("mod.rs", "pub use line::Linear;", "pub use crate::light::Linear;"), 0);
}
