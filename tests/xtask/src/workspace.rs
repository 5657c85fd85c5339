//! The packages, and the walls between them.

use crate::shell::{Outcome, Shell, root};
use crate::toolchain::{BOARDS, OLDEST};
use serde_json::Value;

/// What is built in workspaces of its own.
pub const APART: [&str; 3] = ["examples/firmware", "examples/firmware/decode", "examples/web"];

/// What the tests of the library must not make a user of the repository compile.
const PEERS: [&str; 5] = ["nalgebra", "criterion", "colorimetry", "palette", "rgb2spec"];

/// A package of the workspace at the root.
pub struct Package {
    pub name: String,
    /// Whether there is a library to document and to look at with other features.
    pub has_library: bool,
    pub benches: Vec<String>,
}

/// The packages of the workspace at the root, the library first.
pub fn packages() -> Outcome<Vec<Package>> {
    let mut packages: Vec<Package> = metadata("")?.iter().map(package).collect();
    packages.sort_by_key(|package| package.name.clone());
    Ok(packages)
}

fn package(package: &Value) -> Package {
    let targets = package["targets"].as_array().into_iter().flatten();
    let of_kind = |kind: &str| -> Vec<String> {
        let targets = targets.clone().filter(|target| target["kind"][0] == kind);
        targets.map(|target| text(&target["name"])).collect()
    };
    Package {
        name: text(&package["name"]),
        has_library: !of_kind("lib").is_empty(),
        benches: of_kind("bench"),
    }
}

fn metadata(folder: &'static str) -> Outcome<Vec<Value>> {
    let json = Shell::new().at(folder).output("cargo metadata --format-version 1 --no-deps")?;
    let metadata: Value = serde_json::from_str(&json).map_err(|error| format!("cargo metadata: {error}"))?;
    Ok(metadata["packages"].as_array().cloned().unwrap_or_default())
}

fn text(value: &Value) -> String {
    value.as_str().unwrap_or_default().to_owned()
}

/// Names of the small examples, `examples/*.rs`.
pub fn examples() -> Outcome<Vec<String>> {
    let folder = root().join("examples");
    let entries = std::fs::read_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let paths = entries.filter_map(|entry| Some(entry.ok()?.path()));
    let sources = paths.filter(|path| path.extension().is_some_and(|extension| extension == "rs"));
    let mut names: Vec<String> =
        sources.filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned())).collect();
    names.sort();
    Ok(names)
}

/// No module is taken out of another package's folder.
pub fn no_module_from_elsewhere(shell: &Shell) -> Outcome {
    // (Of git grep, 1 is the exit code for nothing found.)
    shell.bash(r##"git grep --untracked -nE '#\[path *= *"\.\./' -- '*.rs'; [[ $? == 1 ]]"##)
}

/// The library's tests do without its peers, and bare metal without everything that tests need.
pub fn few_dependencies(shell: &Shell) -> Outcome {
    let tree = shell.output("cargo tree -p nanospectra -e normal,dev --depth 1 --prefix none")?;
    let name = |line: &str| line.split(' ').next().unwrap_or_default().to_owned();
    if let Some(peer) = tree.lines().map(name).find(|name| PEERS.contains(&name.as_str())) {
        return Err(format!(
            "nanospectra depends on {peer}, which belongs into the package nanospectra-benches"
        ));
    }
    for target in BOARDS {
        let line = format!("cargo tree -p nanospectra -e dev --depth 1 --prefix none --target {target}");
        if let Some(other) = shell.output(&line)?.lines().map(name).find(|name| name != "nanospectra") {
            return Err(format!("for {target} the tests of nanospectra depend on {other}, which needs std"));
        }
    }
    Ok(())
}

/// Every package names the oldest compiler that is tried.
pub fn one_oldest_compiler(_: &Shell) -> Outcome {
    for folder in [""].into_iter().chain(APART) {
        for package in metadata(folder)? {
            let version = text(&package["rust_version"]);
            if OLDEST.strip_suffix(".0") != Some(&version) {
                let place = text(&package["manifest_path"]);
                return Err(format!("{place}: rust-version is '{version}', and {OLDEST} is what is tried"));
            }
        }
    }
    Ok(())
}
