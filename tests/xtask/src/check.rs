//! What every change is checked with.

use crate::lane::Lane;
use crate::shell::{Outcome, Shell};
use crate::toolchain;
use crate::workspace::{self, APART, Package};

/// The harnesses of the library but `promises`, which is slow: it builds programs and counts instructions.
pub const STATIONS: [&str; 7] = ["spectrum", "color", "matter", "path", "radiometry", "sensor", "upsample"];

pub fn run(mut lane: Lane) -> Outcome {
    toolchain::required()?;
    let packages = workspace::packages()?;
    format(&mut lane);
    walls(&mut lane);
    lane.beside(
        |lane| {
            lints(lane, &packages);
            documentation(lane, &packages);
        },
        |lane| {
            lane.step("tests of the library, in the dev profile", |shell| {
                shell.run(&format!(
                    "cargo test --quiet --no-fail-fast -p nanospectra --lib {}",
                    harnesses(&STATIONS)
                ))
            });
        },
    )?;
    lane.report()
}

pub fn harnesses(stations: &[&str]) -> String {
    stations.iter().map(|station| format!("--test {station} ")).collect()
}

pub fn format(lane: &mut Lane) {
    lane.step("format", |shell| {
        shell.run("cargo fmt --all --check")?;
        APART.iter().try_for_each(|folder| shell.again().at(folder).run("cargo fmt --check"))
    });
}

pub fn walls(lane: &mut Lane) {
    lane.step("walls between the packages", |shell| {
        workspace::no_module_from_elsewhere(shell)?;
        workspace::few_dependencies(shell)?;
        workspace::one_oldest_compiler(shell)
    });
}

pub fn lints(lane: &mut Lane, packages: &[Package]) {
    lane.step("lints of every package", |shell| {
        each(packages, shell, |name| format!("cargo clippy -p {name} --all-targets -- -D warnings"))?;
        shell.run("cargo clippy -p nanospectra --all-targets --all-features -- -D warnings")
    });
}

pub fn documentation(lane: &mut Lane, packages: &[Package]) {
    lane.step("documentation", |shell| {
        let shell = shell.again().with("RUSTDOCFLAGS", "-D warnings");
        let libraries = packages.iter().filter(|package| package.has_library);
        // Of the others a page is for those who work on them.
        each(libraries, &shell, |name| {
            let private = if name == "nanospectra" { "" } else { " --document-private-items" };
            format!("cargo doc --no-deps --all-features -p {name}{private}")
        })
    });
}

/// Runs a command for every package by itself, and for the others too if it fails for one.
pub fn each<'a>(
    packages: impl IntoIterator<Item = &'a Package>,
    shell: &Shell,
    line: impl Fn(&str) -> String,
) -> Outcome {
    let failures: Vec<String> =
        packages.into_iter().filter_map(|package| shell.run(&line(&package.name)).err()).collect();
    if failures.is_empty() { Ok(()) } else { Err(failures.join("; ")) }
}
