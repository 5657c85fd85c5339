//! Renews the records, and the figures that are derived from them.

use crate::check::{STATIONS, each, harnesses};
use crate::full::benches;
use crate::lane::Lane;
use crate::shell::Outcome;
use crate::{toolchain, workspace};

/// Where what is on record and what is derived from it may stand.
const DERIVED: &str = "README.md src tests benches examples";

pub fn run(mut lane: Lane) -> Outcome {
    toolchain::install_all(&mut lane)?;
    let packages = workspace::packages()?;
    lane.run(
        "bits, instructions and bytes of devices, and what they make of the hard cases",
        "bash tests/devices.sh --bless --install",
    );
    lane.step("the largest errors, the table of hard cases and tables of the study", |shell| {
        let shell = shell.again().with("NANOSPECTRA_BLESS", "1");
        // Afresh, for an error on record only grows. These are all the tests that measure one.
        shell.bash("sed -i '/^[^#]/d' tests/data/measured_errors.txt")?;
        each(&packages, &shell, |name| format!("cargo test --release -p {name} -- --skip doc_claims"))?;
        shell.run(&format!("cargo test --release -p nanospectra --all-features {}", harnesses(&STATIONS)))?;
        let every = shell.again().with("NANOSPECTRA_STRIDE", "1");
        every.filtered("cargo test --release -p nanospectra --test spectrum every_f32")?;
        benches(&shell, &packages)
    });
    lane.run(
        "the cost study, with its chart and the tables of the README",
        "cargo run --release -p nanospectra-cost -- --bless",
    );
    lane.step("the sizes of the web package", |shell| {
        shell.again().with("NANOSPECTRA_BLESS", "1").run("bash examples/web/test.sh")
    });
    // Last, since these figures are taken from all the records.
    lane.step("figures in the documentation", |shell| {
        let shell = shell.again().with("NANOSPECTRA_BLESS", "1");
        shell.filtered("cargo test --release -p nanospectra --test promises doc_claims")
    });
    lane.step("what has changed", |shell| {
        shell.run(&format!("git --no-pager diff --stat -- {DERIVED}"))?;
        shell.run(&format!("git --no-pager diff --unified=0 -- {DERIVED} :!*.svg :!*.json"))
    });
    lane.report()
}
