//! Tests the table of hard cases: that it has every row, that each row holds what it claims on this machine
//! and on a Cortex-M4F, that the test which each row names exists, and that the table is the one on record.
//!
//! `NANOSPECTRA_BLESS=1 cargo test -p nanospectra-hard` records the table. `tests/devices.sh --bless` records
//! the results of a Cortex-M4F.

use crate::table::{HardCase, hard_cases, markdown, rules};
use std::fs;
use std::path::Path;
use std::sync::LazyLock;

static TABLE: LazyLock<Vec<HardCase>> = LazyLock::new(hard_cases);

/// Of this package.
const RECORD: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/hard_cases.md");

#[test]
fn every_row_is_there_once() {
    let rows: Vec<u8> = TABLE.iter().map(|case| case.claim.place().0).collect();
    assert!(rows.is_sorted(), "{rows:?}");
    for row in 1..=53 {
        let places = TABLE.iter().map(|case| case.claim.place());
        let parts: Vec<&str> = places.filter(|place| place.0 == row).map(|place| place.1).collect();
        let expected: &[&str] = match parts.len() {
            1 => &[""],
            2 => &["a", "b"],
            _ => &["a", "b", "c"],
        };
        assert_eq!(parts, expected, "row {row}");
    }
    assert_eq!((rows.first(), rows.last()), (Some(&1), Some(&53)));
}

#[test]
fn every_row_holds_what_it_claims() {
    let faults: Vec<String> = TABLE.iter().flat_map(HardCase::faults).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn every_row_and_rule_is_guarded_by_a_test() {
    let guards = TABLE.iter().map(|case| case.claim.test.clone());
    let mut count = 0;
    for guard in guards.chain(rules().into_iter().map(|rule| rule.test)) {
        let names: Vec<&str> = guard.split("::").collect();
        let [file, modules @ .., name] = &names[..] else { panic!("{guard} is no file and test") };
        let name = format!("fn {name}(");
        let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let text = fs::read_to_string(tests.join(format!("{file}.rs"))).expect(&guard);
        let rest = modules.iter().try_fold(text.as_str(), |text, module| {
            text.split_once(&format!("mod {module} {{")).map(|(_, rest)| rest)
        });
        let (before, after) = rest.and_then(|rest| rest.split_once(&name)).expect(&guard);
        assert!(before.lines().rev().take(3).any(|line| line.trim() == "#[test]"), "{guard} is no test");
        assert!(!after.contains(&name), "{guard} is there twice");
        count += 1;
    }
    assert!(count > 53, "{count}");
}

#[test]
fn the_table_is_the_one_on_record() {
    let text = markdown(&TABLE);
    if std::env::var_os("NANOSPECTRA_BLESS").is_some() {
        fs::write(RECORD, &text).expect("a file");
    }
    let recorded = fs::read_to_string(RECORD).expect("a table on record");
    for (line, (is, was)) in text.lines().zip(recorded.lines()).enumerate() {
        assert_eq!(is, was, "line {} of tests/hard/hard_cases.md", line + 1);
    }
    assert_eq!(text.lines().count(), recorded.lines().count());
}
