//! Renews the records, and the figures that are derived from them.

use crate::check::{STATIONS, each, harnesses};
use crate::full::benches;
use crate::lane::Lane;
use crate::shell::{Outcome, Shell, root};
use crate::toolchain;
use crate::workspace::{self, Package};
use std::fs;

/// The largest errors, which are measured afresh: an error on record only grows.
const ERRORS: &str = "tests/data/measured_errors.txt";

/// What the scripts for devices and for the web would skip, and leave on record as it was.
const NEEDED: [&str; 4] = ["qemu-system-arm", "qemu-system-riscv32", "node", "npm"];

pub fn run(mut lane: Lane) -> Outcome {
    toolchain::install_all(&mut lane)?;
    let packages = workspace::packages()?;
    lane.run(
        "bits, instructions and bytes of devices, and what they make of the hard cases",
        "bash tests/devices.sh --bless --install",
    );
    let missing = |program: &&str| !Shell::new().succeeds(&format!("{program} --version"));
    if let Some(program) = NEEDED.into_iter().find(missing) {
        return Err(format!(
            "{program} is not installed, so records of it would stay as they were; install it"
        ));
    }
    lane.run(
        "the cost study, with its chart and the tables of the README and the guides and the guides",
        "cargo run --release -p nanospectra-cost -- --bless",
    );
    lane.step("the largest errors, the table of hard cases and the table of Ohno's method", |shell| {
        let before = fs::read_to_string(root().join(ERRORS)).map_err(|error| format!("{ERRORS}: {error}"))?;
        let head: String = before.lines().take(1).map(|line| format!("{line}\n")).collect();
        let write = |text: &str| fs::write(root().join(ERRORS), text).map_err(|e| format!("{ERRORS}: {e}"));
        write(&head)?;
        let measured = errors(&shell.again().with("NANOSPECTRA_BLESS", "1"), &packages);
        // What is measured in part is no record.
        if measured.is_err() { write(&before).and(measured) } else { measured }
    });
    lane.step("the sizes of the web package", |shell| {
        shell.again().with("NANOSPECTRA_BLESS", "1").run("bash examples/web/test.sh")
    });
    // Last, since these figures are taken from all the records.
    lane.step("figures in the documentation", |shell| {
        let shell = shell.again().with("NANOSPECTRA_BLESS", "1");
        shell.filtered("cargo test --release -p nanospectra --test promises doc_claims")
    });
    lane.step("what has changed", |shell| {
        shell.run("git --no-pager diff --stat")?;
        shell.run("git --no-pager diff --unified=0 -- . :!*.svg :!*.json")
    });
    lane.report()
}

/// All the tests that measure an error.
fn errors(shell: &Shell, packages: &[Package]) -> Outcome {
    each(packages, shell, |name| format!("cargo test --release -p {name} -- --skip doc_claims"))?;
    shell.run(&format!("cargo test --release -p nanospectra --all-features {}", harnesses(&STATIONS)))?;
    let every = shell.again().with("NANOSPECTRA_STRIDE", "1");
    every.filtered("cargo test --release -p nanospectra --test spectrum every_f32")?;
    benches(shell, packages)
}
