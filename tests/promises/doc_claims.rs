//! What is written about the crate in its documentation, README.md and Cargo.toml is what tests measure and
//! what is on record.
//!
//! tests/data/claims.txt names for numbers of sections what holds them. A row whose number is not in its
//! section is a failure, and so is a number that its holder no longer says. NANOSPECTRA_BLESS=1 first renews
//! what is held by an error or a count.

use std::collections::BTreeSet;
use std::path::Path;

use crate::claims::TODAY;
use crate::claims::entries::{Entry, Row, entries};
use crate::claims::held::{Records, holds};
use crate::claims::numbers::{Rounding, like, numbers, value};
use crate::claims::renew::renew;
use crate::claims::sections::{ROOT, Section, Texts, sections};
use nanospectra::matter::{CES, Donaldson, Mirror, Slab, TCS};
use nanospectra::sensor::LightFlickermeter;
use nanospectra::sensor::fixed::FixedObserver;
use nanospectra::upsample::{Basis, Sigmoid, Smits};
use nanospectra::{FineObserver, Nodes};

/// What a reader sees first. Their counts are of one core and one build, or they promise what no program is.
const HEADLINES: [&str; 3] = ["README.md nanospectra", "lib.rs module Summary", "Cargo.toml description"];

#[test]
fn every_row_is_found_in_its_section() {
    let (sections, entries) = (sections(&TODAY.texts), entries(&TODAY.table));
    let mut faults = String::new();
    for (k, entry) in entries.iter().enumerate() {
        let places = sections.get(&entry.title).map(|section| entry.places(section).map(drop));
        let once = entries[..k].iter().all(|other| other.title != entry.title) && !entry.rows.is_empty();
        let found = places.unwrap_or(Err("no such section".into()));
        if let Err(fault) = found.and(once.then_some(()).ok_or("no rows, or a second time".into())) {
            faults += &format!("{}: {fault}\n", entry.title);
        }
    }
    assert!(faults.is_empty(), "tests/data/claims.txt and what is written differ:\n{faults}");
}

#[test]
fn every_bound_has_a_row() {
    let entries = entries(&TODAY.table);
    for (title, section) in sections(&TODAY.texts) {
        let bound = section.numbers.iter().find(|number| number.is_bound());
        let held = entries.iter().any(|entry| entry.title == title);
        if let (Some(bound), true) = (bound, title.ends_with(" Accuracy")) {
            assert!(held, "{title} says {}; say in tests/data/claims.txt what holds it", bound.text);
        }
    }
}

#[test]
fn every_claim_is_held() {
    let mut faults = String::new();
    for entry in entries(&TODAY.table) {
        for row in &entry.rows {
            let words = row.numbers.is_empty().then_some("");
            for number in row.values().chain(words) {
                if let Err(fault) = holds(row, number, &TODAY.records) {
                    faults += &format!("{}: {number}: {fault}\n", entry.title);
                }
            }
        }
    }
    assert!(faults.is_empty(), "these claims are not what is measured:\n{faults}");
}

#[test]
fn every_count_and_every_figure_of_the_pages_is_held() {
    let entries = entries(&TODAY.table);
    let mut faults = String::new();
    for (title, section) in sections(&TODAY.texts) {
        let entry = entries.iter().find(|entry| entry.title == title);
        faults += &unheld_counts(&title, &section, entry);
    }
    assert!(faults.is_empty(), "these counts have no row in tests/data/claims.txt:\n{faults}");
}

/// Instructions, bytes, times, shares and figures with a fraction in README.md and the guides; instructions
/// where costs are named; bytes besides where a reader looks first.
fn unheld_counts(title: &str, section: &Section, entry: Option<&Entry>) -> String {
    let first = HEADLINES.contains(&title);
    let page = title.contains(".md ");
    let costs = first || page || title.ends_with(" Cost");
    let places = entry.and_then(|entry| entry.places(section).ok()).unwrap_or_default();
    let mut faults = String::new();
    for (k, number) in section.numbers.iter().enumerate() {
        let count = match number.unit.as_str() {
            "instructions" => costs,
            "bytes" | "KB" | "kB" | "KiB" | "MB" => first || page,
            // (A share may be an input too: then its section says so in code.)
            "cycles" | "ns" | "%" | "mired" => page && !number.in_code,
            _ => page && number.is_bound(),
        };
        if count && places.iter().all(|(.., place)| *place != k) {
            faults += &format!("{title}: {} {}\n", number.text, number.unit);
        }
    }
    faults
}

#[test]
fn counts_of_a_headline_are_of_one_core_and_one_build() {
    let (sections, entries) = (sections(&TODAY.texts), entries(&TODAY.table));
    assert!(HEADLINES.iter().all(|title| sections.contains_key(*title)), "{HEADLINES:?}");
    let first = |title: &str| title.starts_with("README.md ") || HEADLINES.contains(&title);
    for entry in entries.iter().filter(|entry| first(&entry.title)) {
        assert!(builds(entry).len() <= 1, "{}: {:?}", entry.title, builds(entry));
    }
}

/// Core and profile of the counts.
fn builds(entry: &Entry) -> BTreeSet<String> {
    let counts = entry.rows.iter().filter(|row| row.holder == "record");
    counts.map(|row| row.what.split(' ').take(2).collect::<Vec<_>>().join(" ")).collect()
}

/// A test that cannot fail proves nothing.
#[test]
fn no_other_number_would_do() {
    let records = &TODAY.records;
    for entry in entries(&TODAY.table) {
        for row in entry.rows.iter().filter(|row| row.is_recorded()) {
            for number in row.values().map(value) {
                for factor in [0.45, 2.1] {
                    let other = format!("{:e}", factor * number);
                    assert!(holds(row, &other, records).is_err(), "{}: {number}", entry.title);
                }
            }
        }
        for row in entry.rows.iter().filter(|row| row.holder == "formula") {
            assert!(holds(row, "7", records).is_err(), "{}: {}", entry.title, row.what);
        }
        for row in entry.rows.iter().filter(|row| row.holder == "test" && !row.numbers.is_empty()) {
            let what: Vec<&str> = row.what.splitn(3, ' ').collect();
            let what = format!("{} {} 12.345e6", what[0], what[1]);
            let other = Row { line: 0, what, holder: "test".into(), numbers: vec![] };
            assert!(holds(&other, "", records).is_err(), "{}: {}", entry.title, row.what);
        }
    }
}

#[test]
fn every_test_that_the_documentation_names_is_there() {
    let mut named = 0;
    for (file, text) in TODAY.texts.iter().filter(|(file, _)| file.starts_with("src/")) {
        for rest in text.split("`tests/").skip(1) {
            let name = rest.split('`').next().unwrap_or_default();
            assert!(Path::new(ROOT).join("tests").join(name).exists(), "{file} names tests/{name}");
            named += 1;
        }
    }
    assert!(named > 20, "{named}");
}

#[test]
fn every_check_is_on_record_and_none_else() {
    let recorded = &TODAY.records.errors;
    let allowed = model::allowed::all();
    for (what, [absolute, relative]) in allowed {
        let errors =
            recorded.get(what).unwrap_or_else(|| panic!("'{what}' is never measured, or not on record"));
        assert!(errors[0] <= *absolute && errors[1] <= *relative, "'{what}': more on record than allowed");
    }
    for what in recorded.keys() {
        assert!(allowed.contains_key(what), "'{what}' is on record, but not in tests/data/allowances.txt");
    }
}

#[test]
fn numbers_in_prose_are_found_and_words_are_not() {
    for (text, expected) in [
        ("0.009 mired over 1000 K..1e6 K and |Duv| <= 0.05.", vec!["0.009", "1000", "1e6", "0.05"]),
        ("8 units of 2^-24, f32, x86-64-v3, N^3, 3D, FL11: -0.23..1.23", vec!["8", "2^-24", "0.23", "1.23"]),
        (
            "from 1 230 000 to 54,000, or 6 400. 17^3 of 12 345.5, 1,234",
            vec!["1 230 000", "54,000", "6 400", "17^3", "12", "345.5", "1,234"],
        ),
        ("1 234,567 of 1,234 567", vec!["1 234", "567", "1,234", "567"]),
    ] {
        let found: Vec<&str> = numbers(text).into_iter().map(|at| &text[at]).collect();
        assert_eq!(found, expected, "{text}");
    }
}

#[test]
fn numbers_are_written_anew_in_their_form() {
    use Rounding::{Nearest, Up};
    for (old, value, rounding, expected) in [
        ("444", 447.0, Nearest, "447"),
        ("14 000", 13_120.0, Nearest, "13 000"),
        ("14 300", 9_981.0, Nearest, "9 980"),
        ("14,000", 1_214_567.0, Nearest, "1,200,000"),
        ("1,234", 987.0, Nearest, "987"),
        ("6400", 1_214.0, Nearest, "1200"),
        // One digit would be too far off.
        ("50", 54.2, Nearest, "54"),
        ("2.6", 2.0, Nearest, "2.0"),
        ("2e-7", 3.01e-7, Up, "4e-7"),
        ("2e-7", 3e-7, Up, "3e-7"),
        ("9e-8", 9.1e-8, Up, "1e-7"),
        ("1.45e-7", 1.301e-7, Up, "1.31e-7"),
        ("0.009", 0.01, Up, "0.01"),
        ("0.009", 0.0041, Up, "0.005"),
        ("0.80", 0.6993, Up, "0.70"),
        ("14", 9.21, Up, "9.3"),
        ("20", 41.0, Up, "50"),
        ("8", 9.3, Up, "10"),
    ] {
        assert_eq!(like(old, value, rounding), expected, "{old}, {value}");
    }
}

#[test]
fn what_moved_is_renewed_and_nothing_else() {
    let source = "/// Off by 2e-7 of FL11 at 16 to 31 bins and f32: 2e-7, 2^-24, |x| <= 16.\n\
        ///\n/// # Cost\n/// 16 bands take 14 000 instructions, 16 or 16 of `N^16`\n/// 31 at \"s\", 2,000 bytes.\n\
        /// ```\n/// 16\n/// ```\n#[inline]\npub const fn sees() {\n    let x = 16; // 14 000\n}\n";
    let table = "# 16\nmade.rs sees Summary\n  2e-7#2 measured errors * 10\n  16#1 31 reading of it\n\
        made.rs sees Cost\n  14000 record M4F small instructions a / 2\n  16#2 record M0 release instructions a\n\
        \x20 16#3 absolute both\n  2000 record M4F small bytes c-code + c-tables\n";
    let errors = [("errors", [0.0, 2.5e-8]), ("both", [12.0, 1e-9])];
    let records = Records {
        errors: errors.map(|(name, errors)| (name.to_string(), errors)).into(),
        counts:
            "thumbv7em-none-eabihf small a 25910 instructions\nthumbv6m-none-eabi release a 31 instructions\n\
            thumbv7em-none-eabihf small c-code 900 bytes\nthumbv7em-none-eabihf small c-tables 44 bytes\n"
                .into(),
    };
    let mut texts = Texts::from([("src/made.rs".to_string(), source.to_string())]);
    let mut renewed = table.to_string();
    let changes = renew(&mut texts, &mut renewed, &records);
    let expected = source
        .replace("f32: 2e-7", "f32: 3e-7")
        .replace("take 14 000", "take 13 000")
        .replace("16 or 16", "31 or 16")
        .replace("2,000", "940");
    assert_eq!(texts["src/made.rs"], expected);
    let table = table
        .replace("2e-7#2", "3e-7")
        .replace("14000", "13000")
        .replace("16#2", "31#1")
        .replace("16#3", "16#2")
        .replace("2000", "940");
    assert_eq!(renewed, table);
    assert_eq!(
        changes,
        [
            "made.rs sees Summary: 2e-7 -> 3e-7",
            "made.rs sees Cost: 14 000 -> 13 000",
            "made.rs sees Cost: 16 -> 31",
            "made.rs sees Cost: 2,000 -> 940",
        ]
    );
    // And now everything holds.
    assert_eq!(renew(&mut texts, &mut renewed, &records), [""; 0]);
    let sections = sections(&texts);
    for entry in entries(&renewed) {
        assert!(entry.places(&sections[&entry.title]).is_ok(), "{}", entry.title);
        for row in entry.rows.iter().filter(|row| row.is_recorded()) {
            assert!(row.values().all(|number| holds(row, number, &records).is_ok()), "{}", row.what);
        }
    }
}

#[test]
fn what_is_ambiguous_lost_or_of_two_builds_is_found() {
    let readme = "# nanospectra\n444 instructions and 2 KB of flash, 444 times\n<!-- cost: a -->\n444 KB\n<!-- end -->\n";
    let sections = sections(&Texts::from([("README.md".to_string(), readme.to_string())]));
    let section = &sections["README.md nanospectra"];
    let entry = |rows: &str| entries(&format!("README.md nanospectra\n{rows}\n")).remove(0);
    let worded = "# Cost\n<!-- cost: counts -->\n| a | 123 / 170 | 0.009 mired |\n<!-- end -->\n30 % of 5 ns and 2 KiB\n";
    let worded =
        crate::claims::sections::sections(&Texts::from([("README.md".to_string(), worded.to_string())]));
    let unheld = unheld_counts("README.md Cost", &worded["README.md Cost"], None);
    assert_eq!(unheld.lines().count(), 4, "{unheld}");
    for rows in [
        "  444 record M4F release instructions a",
        "  444#3 record M4F release instructions a",
        "  445 test a b",
        "  444#1 test a b\n  444#1 record M4F release instructions a",
    ] {
        assert!(entry(rows).places(section).is_err(), "{rows}");
    }
    let good = entry("  444#1 record M4F release instructions a");
    assert!(good.places(section).is_ok());
    assert_eq!(unheld_counts(&good.title, section, Some(&good)), "README.md nanospectra: 2 KB\n");
    let mixed = entry("  444#1 record M4F release instructions a\n  2 record M4F small bytes a / 1000");
    assert_eq!(builds(&mixed), ["M4F release", "M4F small"].map(str::to_string).into());
    assert_eq!(unheld_counts(&mixed.title, section, Some(&mixed)), "");
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
    assert_eq!((size_of::<Sigmoid<81, Grid>>() - size_of::<Sigmoid<31, Grid>>()) / 50, 16);
    assert_eq!(size_of::<FineObserver<3>>(), 5652);
    assert_eq!(size_of::<LightFlickermeter>(), 1208);
    // And what they are shifted and counted by.
    assert_eq!(size_of::<FixedObserver<3, 80, Grid>>(), 2 * 3 * 80 + 12);
}
