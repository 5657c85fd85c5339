//! Renews the records and the figures that are derived from them.

use crate::check::{STATIONS, each, harnesses};
use crate::full::benches;
use crate::lane::Lane;
use crate::shell::{Outcome, Shell, root};
use crate::toolchain;
use crate::workspace::{self, Package};
use std::fs;

/// The record of the largest errors, which is measured from nothing, since a test only raises an error on
/// record.
const ERRORS: &str = "tests/data/measured_errors.txt";

/// The programs without which the scripts for devices and for the web would skip checks and leave records as
/// they were.
const NEEDED: [&str; 4] = ["qemu-system-arm", "qemu-system-riscv32", "node", "npm"];

pub fn run(mut lane: Lane) -> Outcome {
    toolchain::install_all(&mut lane)?;
    let packages = workspace::packages()?;
    lane.run(
        "bits, instructions and bytes of devices, and their results of the hard cases",
        "bash tests/devices.sh --bless --install",
    );
    let missing = |program: &&str| !Shell::new().succeeds(&format!("{program} --version"));
    if let Some(program) = NEEDED.into_iter().find(missing) {
        return Err(format!(
            "{program} is not installed, and records that need it would stay as they were; install it"
        ));
    }
    lane.run(
        "the cost study, with its chart and the tables of the README and the guides",
        "cargo run --release -p nanospectra-cost -- --bless",
    );
    lane.step("the largest errors, the table of hard cases and the table of Ohno's method", |shell| {
        let before = fs::read_to_string(root().join(ERRORS)).map_err(|error| format!("{ERRORS}: {error}"))?;
        let head: String = before.lines().take(1).map(|line| format!("{line}\n")).collect();
        let write = |text: &str| fs::write(root().join(ERRORS), text).map_err(|e| format!("{ERRORS}: {e}"));
        write(&head)?;
        let measured = errors(&shell.again().with("NANOSPECTRA_BLESS", "1"), &packages);
        // If only a part was measured, the old record is kept.
        if measured.is_err() { write(&before).and(measured) } else { measured }
    });
    lane.step("the sizes of the web package", |shell| {
        shell.again().with("NANOSPECTRA_BLESS", "1").run("bash examples/web/test.sh")
    });
    // This comes last, since these figures are taken from all the records.
    lane.step("figures in the documentation", |shell| {
        let shell = shell.again().with("NANOSPECTRA_BLESS", "1");
        shell.filtered("cargo test --release -p nanospectra --test promises doc_claims")
    });
    lane.step("the changes", |shell| {
        shell.run("git --no-pager diff --stat")?;
        shell.run("git --no-pager diff --unified=0 -- . :!*.svg :!*.json")
    });
    lane.report()
}

/// Runs all tests that measure an error.
fn errors(shell: &Shell, packages: &[Package]) -> Outcome {
    each(packages, shell, |name| format!("cargo test --release -p {name} -- --skip doc_claims"))?;
    shell.run(&format!("cargo test --release -p nanospectra --all-features {}", harnesses(&STATIONS)))?;
    let every = shell.again().with("NANOSPECTRA_STRIDE", "1");
    every.filtered("cargo test --release -p nanospectra --test spectrum every_f32")?;
    benches(shell, packages)
}
