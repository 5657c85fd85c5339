//! The hard-case table: every row is in it, holds what it claims on this machine and on a Cortex-M4F, is guarded by
//! a test that exists, and is the one on record.
//!
//! `NANOSPECTRA_BLESS=1 cargo test --release --test hard_case_table` records it; what a Cortex-M4F says is recorded
//! by `tests/devices.sh --bless`.
#![cfg(feature = "libm")]

#[path = "../examples/cost/hard_cases/mod.rs"]
mod hard_cases;
#[expect(dead_code, reason = "of the methods of others only those of colour temperature are here")]
#[path = "../examples/cost/yardstick/mod.rs"]
mod yardstick;

use hard_cases::{HardCase, hard_cases, markdown, semantics};
use std::fs;
use std::path::Path;
use std::sync::LazyLock;

static TABLE: LazyLock<Vec<HardCase>> = LazyLock::new(hard_cases);

fn path(below: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(below)
}

#[test]
fn every_row_is_there_once() {
    let rows: Vec<u8> = TABLE.iter().map(|case| case.row).collect();
    assert!(rows.is_sorted(), "{rows:?}");
    for row in 1..=53 {
        let parts: Vec<&str> = TABLE.iter().filter(|case| case.row == row).map(|case| case.part).collect();
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
    let guards = TABLE.iter().map(|case| case.test).chain(semantics().iter().map(|rule| rule.test));
    let mut count = 0;
    for guard in guards {
        let names: Vec<&str> = guard.split("::").collect();
        let [file, modules @ .., name] = &names[..] else { panic!("{guard} is no file and test") };
        let (file, name) = (format!("tests/{file}.rs"), format!("fn {name}("));
        let text = fs::read_to_string(path(&file)).expect(guard);
        let rest = modules.iter().try_fold(text.as_str(), |text, module| {
            text.split_once(&format!("mod {module} {{")).map(|(_, rest)| rest)
        });
        let (before, after) = rest.and_then(|rest| rest.split_once(&name)).expect(guard);
        assert!(before.lines().rev().take(3).any(|line| line.trim() == "#[test]"), "{guard} is no test");
        assert!(!after.contains(&name), "{guard} is there twice");
        count += 1;
    }
    assert!(count > 53, "{count}");
}

#[test]
fn the_table_is_the_one_on_record() {
    let record = path("examples/cost/data/hard_cases.md");
    let text = markdown(&TABLE);
    if std::env::var_os("NANOSPECTRA_BLESS").is_some() {
        fs::create_dir_all(path("examples/cost/data")).expect("a directory");
        fs::write(&record, &text).expect("a file");
    }
    let recorded = fs::read_to_string(&record).expect("a table on record");
    for (line, (is, was)) in text.lines().zip(recorded.lines()).enumerate() {
        assert_eq!(is, was, "line {} of examples/cost/data/hard_cases.md", line + 1);
    }
    assert_eq!(text.lines().count(), recorded.lines().count());
}
