//! The largest errors on record: what a check measures may not grow by more than 2 %.
//!
//! `cargo xtask bless` makes the record again. With NANOSPECTRA_BLESS=1 a test puts on record what is larger
//! than what is there, and what is new. The errors are the same on every machine but for the last digits of
//! the f64 models.

use super::table::{self, FOLDER, Table};
use std::fs;
use std::sync::{Mutex, PoisonError};

const FILE: &str = "measured_errors.txt";
const HEAD: &str = "# The largest error of each check in tests/data/allowances.txt: absolute, relative, name. By `cargo xtask bless`.\n";

/// By name: absolute, relative.
pub fn read() -> Table {
    table::read(FILE)
}

/// Fails if the largest error of this check is not on record or more than 2 % above it.
pub fn hold(what: &'static str, measured: [f64; 2]) {
    static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());
    let _one = ONE_AT_A_TIME.lock().unwrap_or_else(PoisonError::into_inner);
    let mut all = read();
    if std::env::var_os("NANOSPECTRA_BLESS").is_some() {
        let entry = all.entry(what.to_string()).or_default();
        *entry = [entry[0].max(measured[0]), entry[1].max(measured[1])];
        let lines =
            all.iter().map(|(what, [absolute, relative])| format!("{absolute:.3e} {relative:.3e} {what}\n"));
        fs::write(format!("{FOLDER}{FILE}"), HEAD.to_string() + &lines.collect::<String>())
            .expect("a record");
        return;
    }
    let Some(recorded) = all.get(what) else {
        panic!("'{what}' is not on record: this test with NANOSPECTRA_BLESS=1 records it")
    };
    for (measured, recorded) in measured.into_iter().zip(recorded) {
        assert!(measured <= 1.02 * recorded, "{what}: {measured:.3e}, on record are {recorded:.3e}");
    }
}
