//! No matter is left out of the tests that all of its kind pass.

use crate::claims::sections::{ROOT, Texts, texts};
use std::fs;
use std::path::Path;

/// What matter implements, and the file whose tests hold all that does.
const KINDS: [(&str, &str); 2] = [("Brdf", "tests/matter/brdf.rs"), ("Foldable", "tests/path/own.rs")];

/// The types for which the library implements this trait.
fn implementing<'t>(texts: &'t Texts, name: &str) -> Vec<&'t str> {
    let lines = texts.iter().filter(|(file, _)| file.starts_with("src/")).flat_map(|(_, text)| text.lines());
    lines
        .filter_map(|line| {
            let (before, matter) = line.strip_prefix("impl")?.rsplit_once(" for ")?;
            let of_this = before.ends_with(&format!(" {name}")) || before.contains(&format!("> {name}<"));
            of_this.then(|| matter.split(|c: char| !c.is_alphanumeric()).next().unwrap_or(matter))
        })
        .collect()
}

/// Those of `matter` that a test file does not make: it only imports them, or does not know them.
fn forgotten<'t>(matter: Vec<&'t str>, tests: &str) -> Vec<&'t str> {
    let made =
        |name: &str| ["(", "::", " {", "<"].iter().any(|after| tests.contains(&format!("{name}{after}")));
    matter.into_iter().filter(|name| !made(name)).collect()
}

#[test]
fn every_brdf_and_every_effect_is_tested_with_the_others() {
    for (name, file) in KINDS {
        let matter = implementing(&texts(), name).join(" ");
        let tests = fs::read_to_string(Path::new(ROOT).join(file)).expect(file);
        assert!(matter.contains(' '), "{name}: {matter}");
        assert_eq!(forgotten(matter.split(' ').collect(), &tests), [""; 0], "{file}");
    }
}

/// A test that cannot fail proves nothing.
#[test]
fn matter_without_a_test_is_found() {
    let source =
        "impl<V: Integrand> Brdf for Moon<V> {\nimpl Brdf for Sun {\nimpl<B: Brdf> Sky<B> for Mars {";
    let texts = Texts::from([("src/matter/moon.rs".into(), source.into())]);
    assert_eq!(implementing(&texts, "Brdf"), ["Moon", "Sun"]);
    assert_eq!(
        forgotten(vec!["Moon", "Sun"], "use nanospectra::matter::{Moon, Sun};\nMoon(0.5).f(wo, wi)"),
        ["Sun"]
    );
}
