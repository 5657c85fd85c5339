//! The packages of the repository, and the rules about what one may take from another.

use crate::shell::{Outcome, Shell, root};
use crate::toolchain::{BOARDS, OLDEST};
use serde_json::Value;

/// The folders that are workspaces of their own.
pub const APART: [&str; 3] = ["examples/firmware", "examples/firmware/decode", "examples/web"];

/// The packages that tests of the library must not depend on, because they take long to compile.
const PEERS: [&str; 5] = ["nalgebra", "criterion", "colorimetry", "palette", "rgb2spec"];

/// A package of the workspace at the root.
pub struct Package {
    pub name: String,
    /// Whether the package has a library, which is documented.
    pub has_library: bool,
    pub benches: Vec<String>,
}

/// Returns the packages of the workspace at the root, with the library first.
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

/// Returns the names of the small examples, `examples/*.rs`.
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

/// Checks that no module is taken from the folder of another package.
pub fn no_module_from_elsewhere(shell: &Shell) -> Outcome {
    // The exit code of git grep is 1 if it finds nothing.
    shell.bash(r##"git grep --untracked -nE '#\[path *= *"\.\./' -- '*.rs'; [[ $? == 1 ]]"##)
}

/// Checks that the tests of the library do not depend on other crates of its kind, and that on bare metal
/// they depend on nothing.
pub fn few_dependencies(shell: &Shell) -> Outcome {
    let tree = shell.output("cargo tree -p nanospectra -e normal,dev --depth 1 --prefix none")?;
    let name = |line: &str| line.split(' ').next().unwrap_or_default().to_owned();
    if let Some(peer) = tree.lines().map(name).find(|name| PEERS.contains(&name.as_str())) {
        return Err(format!(
            "the tests of nanospectra depend on {peer}; move that to the package nanospectra-benches"
        ));
    }
    for target in BOARDS {
        let line = format!("cargo tree -p nanospectra -e dev --depth 1 --prefix none --target {target}");
        if let Some(other) = shell.output(&line)?.lines().map(name).find(|name| name != "nanospectra") {
            return Err(format!(
                "for {target} the tests of nanospectra depend on {other}, which needs std; remove it"
            ));
        }
    }
    Ok(())
}

/// Checks that every package names the oldest compiler that is tried.
pub fn one_oldest_compiler(_: &Shell) -> Outcome {
    for folder in [""].into_iter().chain(APART) {
        for package in metadata(folder)? {
            let version = text(&package["rust_version"]);
            if OLDEST.strip_suffix(".0") != Some(&version) {
                let place = text(&package["manifest_path"]);
                return Err(format!(
                    "{place}: rust-version is '{version}', but {OLDEST} is the oldest that is tried"
                ));
            }
        }
    }
    Ok(())
}
