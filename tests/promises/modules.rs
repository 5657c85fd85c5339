//! Modules of the library depend downwards only. (The story of `src/lib.rs` goes along the light; what the
//! code of a station needs decides what lies lower: an observer before the lights that are judged by it,
//! colors before the matter whose Fresnel terms and budgets are told in them.)

use crate::claims::sections::{Texts, texts};
use std::collections::BTreeSet;

/// From the ground up: a module may use those before it.
const ORDER: &str = "math grid sum price tristimulus geometry spectrum test_samples observer light color matter path upsample \
                     radiometry sensor guide";

/// The top-level module that a file of the library belongs to.
fn module(file: &str) -> Option<&str> {
    file.strip_prefix("src/")?.split(['/', '.']).next()
}

fn height(module: &str) -> usize {
    ORDER
        .split(' ')
        .position(|name| name == module)
        .unwrap_or_else(|| panic!("{module} is no module of ORDER"))
}

/// The first names of all paths from the crate's root in code: not in comments, not in unit tests.
fn used(text: &str) -> BTreeSet<String> {
    let code: String = text
        .lines()
        .take_while(|line| line.trim() != "#[cfg(test)]")
        .map(|line| line.split("//").next().unwrap_or_default().to_owned() + "\n")
        .collect();
    code.split("crate::").skip(1).flat_map(first_names).collect()
}

/// The name that a path begins with, or each path of a group: `grid` and `color` of `{grid::{Bands, Grid},
/// color::Xyz}`.
fn first_names(rest: &str) -> BTreeSet<String> {
    let (mut names, mut depth, mut begins) = (BTreeSet::new(), 0, true);
    for (at, c) in rest.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' => begins = depth == 1,
            c if begins && depth < 2 && (c.is_alphanumeric() || "_*".contains(c)) => {
                let end = rest[at..].find(|c: char| !c.is_alphanumeric() && c != '_');
                names.insert(rest[at..][..end.unwrap_or(rest.len() - at)].to_owned());
                begins = false;
            }
            _ => {}
        }
        if depth == 0 {
            break;
        }
    }
    names
}

/// The arrows that point upwards: from which file to which module.
fn arrows_back(texts: &Texts) -> Vec<String> {
    let mut faults = Vec::new();
    for (file, text) in texts.iter().filter(|(file, _)| file.ends_with(".rs")) {
        let Some(module) = module(file).filter(|module| *module != "lib") else { continue };
        for name in used(text) {
            if height(&name) > height(module) {
                faults.push(format!("{file} uses crate::{name}, which is above {module}"));
            }
        }
    }
    faults
}

#[test]
fn no_module_uses_one_above_it() {
    let faults = arrows_back(&texts());
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn every_module_has_its_place() {
    let texts = texts();
    let found: BTreeSet<&str> = texts.keys().filter_map(|file| module(file)).collect();
    assert_eq!(found, ORDER.split(' ').chain(["lib"]).collect());
}

/// A test that cannot fail proves nothing.
#[test]
fn an_arrow_back_is_found() {
    for code in [
        "use crate::observer::sum;",
        "let x = crate::path::price();",
        "use crate::{grid::Grid, sensor::Meter};",
        "use crate::{\n    grid::Grid,\n    color::Xyz,\n};",
        "use crate::{grid::{Bands, Grid}, math::{Math}, sensor::{Meter, Fit}};",
        "pub use crate::{\n    math::{\n        Math, sqrt,\n    },\n    color::*,\n};",
        "macro_rules! m { () => { $crate::sensor::Meter }; }",
        "pub(in crate::sensor) use crate::grid::Grid;",
    ] {
        assert_eq!(
            arrows_back(&Texts::from([("src/spectrum/series.rs".into(), code.into())])).len(),
            1,
            "{code}"
        );
    }
    for code in [
        "/// [`x`](crate::sensor::Meter)",
        "use crate::grid::Grid; // crate::path",
        "#[cfg(test)]\ncrate::sensor",
    ] {
        assert_eq!(
            arrows_back(&Texts::from([("src/spectrum/series.rs".into(), code.into())])).len(),
            0,
            "{code}"
        );
    }
}

/// Code names other modules from the crate's root, so that it reads the same wherever its file lies. (Modules
/// within a file, for tests and for sealing traits, call their file `super`.)
#[test]
fn paths_begin_at_the_crate() {
    for (file, text) in texts() {
        let mut within = false;
        for line in text.lines() {
            within = (within || (line.starts_with("mod ") && line.ends_with('{'))) && line != "}";
            assert!(
                within || !line.contains("super::"),
                "{file}: write `crate::` and the whole path in {line}"
            );
        }
    }
}
