//! Runs the tests that draw random cases, and no others, with other seeds or with more cases.

use crate::check::STATIONS;
use crate::shell::{Outcome, Shell, root};
use crate::toolchain;
use std::fs;
use std::path::Path;

/// Runs the random tests of every station with each of these seeds, in the dev profile.
pub fn seeds(first: u32, last: u32) -> Outcome {
    toolchain::required()?;
    let mut failed = Vec::new();
    for seed in first..=last {
        println!("\n== seed {seed}, of {first} to {last}");
        let shell = Shell::new().with("PROPTEST_RNG_SEED", seed.to_string());
        if let Err(why) = stations(&shell, |_| true) {
            failed.push(format!("seed {seed}: {why}"));
        }
    }
    if failed.is_empty() { Ok(()) } else { Err(failed.join("\n")) }
}

/// Runs the fuzzers of the library, tests/STATION/STATION_bits.rs, so many times each, in the dev profile.
pub fn fuzz(runs: u32) -> Outcome {
    toolchain::required()?;
    let shell = Shell::new().with("NANOSPECTRA_RUNS", runs.to_string());
    stations(&shell, |file| file.file_stem().is_some_and(|stem| stem.to_string_lossy().ends_with("_bits")))
}

/// Runs the random tests in those files of the stations that are wanted. If one fails, the others still run.
fn stations(shell: &Shell, is_wanted: impl Fn(&Path) -> bool) -> Outcome {
    let mut failed = Vec::new();
    for station in STATIONS {
        let mut names = Vec::new();
        for file in sources(station)?.into_iter().filter(|file| is_wanted(file)) {
            let text = fs::read_to_string(&file).map_err(|error| format!("{}: {error}", file.display()))?;
            names.extend(random_tests(&text).iter().map(|name| format!("::{name}")));
        }
        if names.is_empty() {
            continue;
        }
        let line = format!("cargo test --quiet -p nanospectra --test {station} -- {}", names.join(" "));
        if let Err(why) = shell.filtered(&line) {
            failed.push(why);
        }
    }
    if failed.is_empty() { Ok(()) } else { Err(failed.join("\n")) }
}

/// Returns the files of a station, in their order.
fn sources(station: &str) -> Outcome<Vec<std::path::PathBuf>> {
    let folder = root().join("tests").join(station);
    let entries = fs::read_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let paths = entries.filter_map(|entry| Some(entry.ok()?.path()));
    let mut sources: Vec<_> = paths.filter(|path| path.extension().is_some_and(|end| end == "rs")).collect();
    sources.sort();
    Ok(sources)
}

/// Returns the names of the tests in all blocks `proptest! { .. }` of a formatted file.
fn random_tests(text: &str) -> Vec<&str> {
    let mut names = Vec::new();
    let mut lines = text.lines();
    while let Some(start) = lines.find(|line| line.trim_start() == "proptest! {") {
        let indent = start.len() - start.trim_start().len();
        let end = format!("{:indent$}}}", "");
        for line in lines.by_ref().take_while(|line| *line != end) {
            let name = line[indent.min(line.len())..]
                .strip_prefix("    fn ")
                .and_then(|rest| rest.split('(').next());
            names.extend(name);
        }
    }
    names
}
