//! Checks the documentation of the library's public items, as rustdoc's JSON gives it, and the pages of
//! docs.rs.

mod examples;
mod functions;
mod items;
pub mod labels;
pub mod links;
mod sentence;

use crate::shell::{Outcome, Shell, root};
use examples::Page;
use items::{Item, items};
use rustdoc_types::Crate;
use sentence::{VERBLESS, fault, first_sentence};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;

/// How many public items must have an example of their own or a link to one that shows them.
const EXAMPLES: usize = 300;

/// The verbs that a first sentence may have, one a line.
const VERBS: &str = "tests/xtask/data/verbs.txt";

/// Fails if a public item is not documented as CONTRIBUTING.md asks, and prints every fault with its place.
pub fn check(shell: &Shell) -> Outcome {
    let library = library(shell)?;
    let found = faults(&library, &verbs()?);
    found.faults.iter().for_each(|fault| shell.say(fault));
    if found.faults.iter().any(|fault| fault.contains(VERBLESS)) {
        shell.say(&format!(
            "If a sentence has a verb that this check does not know, add the verb to {VERBS}."
        ));
    }
    let Found { items, own, linked, .. } = found;
    let examples = own + linked;
    shell.say(&format!(
        "{items} public items; {examples} are shown by an example: {own} by their own, {linked} by a link to one"
    ));
    if !found.faults.is_empty() || examples < EXAMPLES {
        return Err(format!(
            "{} faults; {examples} public items are shown by an example, of at least {EXAMPLES}",
            found.faults.len()
        ));
    }
    Ok(())
}

/// The public functions of the library that can run, by their names, with their documentation.
pub fn functions(shell: &Shell) -> Outcome<BTreeMap<String, String>> {
    Ok(functions::functions(&library(shell)?))
}

/// What rustdoc knows of the library.
fn library(shell: &Shell) -> Outcome<Crate> {
    // Rustdoc writes JSON only with its unstable options. The compiler takes them with this variable, which
    // would make cargo compile dependencies again for the other steps, so this one has its own folder.
    let shell = shell.again().with("RUSTC_BOOTSTRAP", "1").with("CARGO_TARGET_DIR", "target/docs");
    shell.run(
        "cargo rustdoc --quiet -p nanospectra --all-features --lib -- -Zunstable-options --output-format json",
    )?;
    read("target/docs/doc/nanospectra.json")
}

fn read(path: &str) -> Outcome<Crate> {
    let text = fs::read_to_string(root().join(path)).map_err(|error| format!("{path}: {error}"))?;
    let json: serde_json::Value = serde_json::from_str(&text).map_err(|error| format!("{path}: {error}"))?;
    let (written, known) = (&json["format_version"], rustdoc_types::FORMAT_VERSION);
    if *written != known {
        return Err(format!(
            "rustdoc writes version {written} of its JSON, but tests/xtask/Cargo.toml takes rustdoc-types for \
             version {known}; ask for rustdoc-types 0.{written}"
        ));
    }
    serde_json::from_value(json).map_err(|error| format!("{path}: {error}"))
}

fn verbs() -> Outcome<BTreeSet<String>> {
    let text = fs::read_to_string(root().join(VERBS)).map_err(|error| format!("{VERBS}: {error}"))?;
    Ok(text.lines().map(str::to_owned).collect())
}

/// What is wrong with the documentation of a library, and how many of its public items have an example.
struct Found {
    faults: Vec<String>,
    items: usize,
    own: usize,
    linked: usize,
}

fn faults(library: &Crate, verbs: &BTreeSet<String>) -> Found {
    let items = items(library);
    let (mut faults, mut own, mut linked) = (Vec::new(), 0, 0);
    for item in &items {
        let mut fail = |why: &str| faults.push(format!("{}: `{}` {why}", item.place, item.path));
        if item.docs.trim().is_empty() {
            fail("has no documentation");
            continue;
        }
        match first_sentence(item.docs) {
            None => fail("does not begin with a sentence"),
            Some(sentence) => {
                if let Some(why) = fault(&sentence, verbs) {
                    fail(&why);
                }
            }
        }
        let page = Page::new(item.docs);
        let mut shown = false;
        for link in &page.example_links {
            match item.shows(link, library, &items) {
                Ok(()) => shown = true,
                Err(why) => fail(&format!("has a link to an example, `{link}`, {why}")),
            }
        }
        if page.has_example {
            own += 1;
        } else if shown {
            linked += 1;
        }
        if item.is_module && !page.has_example {
            fail("is a module without an example");
        }
    }
    Found { faults, items: items.len(), own, linked }
}

impl Item<'_> {
    /// Whether a link in this item's documentation leads to an example.
    fn shows(&self, link: &str, library: &Crate, items: &[Item]) -> Result<(), String> {
        let (target, fragment) = match (self.links.get(link), link.split_once('#')) {
            (Some(target), fragment) => (*target, fragment.map(|(_, fragment)| fragment)),
            (None, Some(("", _))) if self.is_of_trait => {
                return Err("which has to name the trait: the pages of types show it too".to_owned());
            }
            (None, Some(("", fragment))) => (self.page, Some(fragment)),
            (None, _) => return Err("which is no item of this crate".to_owned()),
        };
        let docs = |docs: Option<&str>| Page::new(docs.unwrap_or_default());
        let whole = docs(library.index.get(&target).and_then(|item| item.docs.as_deref()));
        let shows = match fragment {
            None => whole.has_example,
            Some(fragment) => {
                let member = fragment.split_once('.').map(|(_, name)| name);
                let is_it = |item: &&Item| item.page == target && member == Some(item.name);
                whole.shows(fragment)
                    || Page::new(self.docs).shows(fragment)
                    || items.iter().find(is_it).is_some_and(|item| docs(Some(item.docs)).has_example)
            }
        };
        if shows { Ok(()) } else { Err("but there is no code that runs".to_owned()) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The documentation of a small crate is found wanting in each of the ways that there are.
    #[test]
    fn bad_documentation_is_found() {
        let shell = Shell::new().with("RUSTC_BOOTSTRAP", "1");
        let rustdoc =
            "rustdoc --edition 2024 -Zunstable-options --output-format json --out-dir target/docs/tests";
        shell.run(&format!("{rustdoc} tests/xtask/data/badly_documented.rs")).unwrap();
        let library = read("target/docs/tests/badly_documented.json").unwrap();
        let found = faults(&library, &verbs().unwrap());
        let file = "tests/xtask/data/badly_documented.rs";
        let short = "begins with a sentence of fewer than five words";
        let code = "but there is no code that runs";
        let expected = [
            format!("{file}:1: `badly_documented` is a module without an example"),
            format!("{file}:8: `Lamp::watts` has no documentation"),
            format!("{file}:16: `Lamp::new` {short}: \"Makes a lamp.\""),
            format!("{file}:31: `Lamp::off` has a link to an example, `#colors`, {code}"),
            format!("{file}:36: `Lamp::dim` has a link to an example, `shades`, {code}"),
            format!(
                "{file}:46: `Lamp::text` {VERBLESS}: \"The lamp as a short text, which nobody `reads`.\""
            ),
            format!("{file}:51: `Lamp::COLD` does not begin with a sentence"),
            format!("{file}:55: `shades` is a module without an example"),
            format!(
                "{file}:68: `Glows::light` has a link to an example, `#example`, which has to name the trait: the \
                 pages of types show it too"
            ),
        ];
        let mut faults = found.faults;
        faults.sort_by_key(|fault| fault.split(':').nth(1).map(|line| line.parse::<usize>().unwrap()));
        assert_eq!(faults, expected, "{faults:#?}");
        assert_eq!((found.items, found.own, found.linked), (14, 2, 2));
    }
}
