//! The checks of every change.

use crate::docs;
use crate::images;
use crate::lane::Lane;
use crate::shell::{Outcome, Shell};
use crate::toolchain;
use crate::workspace::{self, APART, Package};

/// The test harnesses of the library, without `promises`, which is slow because it builds programs and counts
/// instructions.
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
            lane.step(
                "tests of the documentation, the bits, the model, the reader of files and the program",
                |shell| {
                    let test = "cargo test --quiet --no-fail-fast";
                    shell.run(&format!("{test} -p nanospectra --doc"))?;
                    shell.filtered("cargo test -p nanospectra --test promises doc_claims")?;
                    shell.filtered("cargo test -p nanospectra --test promises modules")?;
                    ["bits", "model", "files", "cli"]
                        .iter()
                        .try_for_each(|name| shell.run(&format!("{test} -p nanospectra-{name}")))
                },
            );
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
        // These are workspaces of their own, which `cargo fmt --all` does not reach.
        APART.iter().try_for_each(|folder| shell.again().at(folder).run("cargo fmt --check"))
    });
}

pub fn walls(lane: &mut Lane) {
    lane.step("dependencies between the packages", |shell| {
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
        let page = |name: &str, flags: &str| {
            let shell = shell.again().with("RUSTDOCFLAGS", flags);
            shell.run(&format!("cargo doc --no-deps --all-features -p {name}"))
        };
        // What `cargo doc` shows to users. Links to items that need a feature which is off must lead
        // somewhere, too.
        let users = shell.again().with("RUSTDOCFLAGS", "-D warnings");
        users.run("cargo doc --no-deps -p nanospectra")?;
        page("nanospectra", "-D warnings")?;
        // The documentation of the other packages is for their developers.
        let others = packages.iter().filter(|package| package.has_library && package.name != "nanospectra");
        others.map(|package| &package.name).try_for_each(|name| {
            page(name, "-D warnings --document-private-items -A rustdoc::private_intra_doc_links")
        })
    });
    lane.step("documentation of every public item", docs::check);
    lane.step("every public function is in an image that cannot panic", images::check);
    lane.step("documentation as docs.rs builds it", |shell| {
        docs::labels::check(shell)?;
        docs::links::check(shell)
    });
}

/// Runs a command for every package by itself. If it fails for one, the others still run.
pub fn each<'a>(
    packages: impl IntoIterator<Item = &'a Package>,
    shell: &Shell,
    line: impl Fn(&str) -> String,
) -> Outcome {
    let failures: Vec<String> =
        packages.into_iter().filter_map(|package| shell.run(&line(&package.name)).err()).collect();
    if failures.is_empty() { Ok(()) } else { Err(failures.join("; ")) }
}
