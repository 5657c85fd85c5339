//! What the documentation says under `# Accuracy` and `# Cost` is what tests measure.
//!
//! tests/data/claims.txt names for every number of every section what holds it. A section, a number or a row without
//! the other is a failure, and so is a number that its holder no longer says.

use crate::claims::held::{Row, entries, holds};
use crate::claims::numbers::{numbers, value};
use crate::claims::sections::{ROOT, sections, sources};
use model::allowed::record;
use nanospectra::Nodes;
use nanospectra::matter::{CES, Donaldson, Mirror, Slab, TCS};
use nanospectra::sensor::fixed::FixedObserver;
use nanospectra::upsample::{Basis, Smits};
use std::path::Path;

#[test]
fn every_number_of_every_section_has_a_row() {
    let (sections, entries) = (sections(), entries());
    let mut faults = String::new();
    for (section, entry) in sections.iter().zip(&entries) {
        assert_eq!(
            section.title, entry.title,
            "in tests/data/claims.txt a section is missing, or one too many"
        );
        let covered: Vec<String> = entry.rows.iter().flat_map(|row| row.numbers.clone()).collect();
        if covered != section.numbers || entry.rows.is_empty() {
            faults +=
                &format!("{}\n  says     {:?}\n  in rows  {covered:?}\n", section.title, section.numbers);
        }
    }
    assert!(faults.is_empty(), "tests/data/claims.txt and the documentation differ:\n{faults}");
    assert_eq!(sections.len(), entries.len(), "sections, and entries in tests/data/claims.txt");
}

#[test]
fn every_claim_is_held() {
    let mut faults = String::new();
    for entry in entries() {
        for row in entry.rows {
            let words = row.numbers.is_empty().then(String::new);
            for number in row.numbers.iter().chain(&words) {
                if let Err(fault) = holds(&row, number) {
                    faults += &format!("{}: {number}: {fault}\n", entry.title);
                }
            }
        }
    }
    assert!(faults.is_empty(), "these claims are not what is measured:\n{faults}");
}

/// A test that cannot fail proves nothing.
#[test]
fn no_other_number_would_do() {
    for entry in entries() {
        for row in
            entry.rows.iter().filter(|row| ["measured", "absolute", "record"].contains(&row.holder.as_str()))
        {
            for number in &row.numbers {
                let number = value(number);
                for factor in [0.45, 2.1] {
                    assert!(
                        holds(row, &format!("{:e}", factor * number)).is_err(),
                        "{}: {number}",
                        entry.title
                    );
                }
            }
        }
        for row in entry.rows.iter().filter(|row| row.holder == "formula") {
            assert!(holds(row, "7").is_err(), "{}: {}", entry.title, row.what);
        }
        for row in entry.rows.iter().filter(|row| row.holder == "test" && !row.numbers.is_empty()) {
            let what: Vec<&str> = row.what.splitn(3, ' ').collect();
            let other = Row {
                what: format!("{} {} 12.345e6", what[0], what[1]),
                holder: "test".into(),
                numbers: vec![],
            };
            assert!(holds(&other, "").is_err(), "{}: {}", entry.title, row.what);
        }
    }
}

#[test]
fn every_test_that_the_documentation_names_is_there() {
    let mut named = 0;
    for (file, text) in sources() {
        for rest in text.split("`tests/").skip(1) {
            let name = rest.split('`').next().unwrap_or_default();
            assert!(Path::new(ROOT).join("tests").join(name).exists(), "src/{file} names tests/{name}");
            named += 1;
        }
    }
    assert!(named > 20, "{named}");
}

#[test]
fn every_check_is_on_record_and_none_else() {
    let recorded = record::read();
    for (what, absolute, relative) in model::allowed::all() {
        let errors =
            recorded.get(*what).unwrap_or_else(|| panic!("'{what}' is never measured, or not on record"));
        assert!(errors[0] <= *absolute && errors[1] <= *relative, "'{what}': more on record than allowed");
    }
    for what in recorded.keys() {
        assert!(
            model::allowed::all().any(|(name, ..)| name == what),
            "'{what}' is on record, but not in tests/allowed"
        );
    }
}

#[test]
fn numbers_in_prose_are_found_and_words_are_not() {
    for (text, expected) in [
        ("0.009 mired over 1000 K..1e6 K and |Duv| <= 0.05.", vec!["0.009", "1000", "1e6", "0.05"]),
        ("8 units of 2^-24, f32, x86-64-v3, N^3, FL11: -0.23..1.23", vec!["8", "2^-24", "0.23", "1.23"]),
        (
            "from 1 230 000 to 54 000, or 6 400. 17^3 of 12 345.5",
            vec!["1230000", "54000", "6400", "17^3", "12", "345.5"],
        ),
    ] {
        assert_eq!(numbers(text), expected, "{text}");
    }
}

#[test]
fn tables_and_samples_are_as_large_as_documented() {
    type Grid = Nodes<400, 700>;
    assert_eq!(size_of_val(&TCS) / 1000, 28);
    assert_eq!((size_of_val(&CES) + 500) / 1000, 159);
    assert_eq!(size_of::<Mirror<31>>(), 16 * 31 + 8);
    assert_eq!(size_of::<Slab<31>>(), 8 * 31 + 4);
    assert_eq!(size_of::<Donaldson<31, 496>>(), 4 * 496);
    assert_eq!(size_of::<Basis<31, Grid>>(), 8 * 31);
    assert_eq!(size_of::<Smits<31, Grid>>(), 28 * 31);
    // And what they are shifted and counted by.
    assert_eq!(size_of::<FixedObserver<3, 80, Grid>>(), 2 * 3 * 80 + 12);
}
