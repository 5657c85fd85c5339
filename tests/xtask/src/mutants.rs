//! Changes the library in small ways, one at a time, and looks whether a test fails for each of them.
//!
//! The tool is cargo-mutants. A change that no test sees has either an explanation in data/mutants.txt, such
//! as that it has no effect, or it asks for a test.

use crate::check::STATIONS as HARNESSES;
use crate::shell::{Outcome, Shell, root};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::process::Stdio;

/// The version whose names of changes the explanations use.
const TOOL: &str = "27.1.0";

/// The version of cargo-nextest, which runs the tests because it stops at the first that fails.
const RUNNER: &str = "0.9.143";

/// The folders of the library that are changed. Each of them has a test harness of the same name.
const STATIONS: [&str; 5] = ["color", "path", "radiometry", "sensor", "upsample"];

/// The share of changes that a test has to see, in percent.
const SEEN: usize = 97;

#[derive(clap::Args)]
pub struct Choice {
    /// How many changes are drawn at random
    #[arg(long, value_name = "NUMBER", default_value_t = 600)]
    count: usize,
    /// The seed of the draw, where another number draws other changes
    #[arg(long, value_name = "NUMBER", default_value_t = 1)]
    seed: u64,
    /// Try all changes of the lines that differ from this commit, instead of a draw
    #[arg(long, value_name = "COMMIT")]
    since: Option<String>,
    /// Try only changes whose description contains this text, such as src/color/cct.rs
    #[arg(long, value_name = "TEXT")]
    only: Option<String>,
}

pub fn run(choice: &Choice) -> Outcome {
    let shell = Shell::new();
    if !shell.succeeds("cargo mutants --version") {
        shell.run(&format!("cargo install cargo-mutants --version {TOOL} --locked"))?;
    }
    if !shell.succeeds("cargo nextest --version") {
        shell.run(&format!("cargo install cargo-nextest --version {RUNNER} --locked"))?;
    }
    let chosen = choose(&shell, choice)?;
    println!("{} changes", chosen.len());
    let mut all = Tried::default();
    for station in STATIONS {
        let here = format!("src/{station}/");
        let ours: Vec<&String> = chosen.iter().filter(|change| change.starts_with(&here)).collect();
        let tried = try_all(&shell, station, &ours, &[station], "")?;
        all.seen += tried.seen;
        all.unseen.extend(tried.unseen);
    }
    // What the tests of a folder do not see may be seen by those that use the folder, or with all features.
    let again =
        try_all(&shell, "everywhere", &all.unseen.iter().collect::<Vec<_>>(), &HARNESSES, " --all-features")?;
    all.seen += all.unseen.len() - again.unseen.len();
    report(&Tried { unseen: again.unseen, ..all })
}

/// What became of changes that compile.
#[derive(Default)]
struct Tried {
    /// How many made a test fail, or run for ever.
    seen: usize,
    /// The descriptions of the others.
    unseen: Vec<String>,
}

/// Returns the changes to try.
fn choose(shell: &Shell, choice: &Choice) -> Outcome<Vec<String>> {
    let files: String = STATIONS.iter().map(|station| format!(" -f src/{station}/**")).collect();
    let mut list = format!("cargo mutants --list -p nanospectra{files}");
    if let Some(commit) = &choice.since {
        let changes = root().join("target/mutants.diff");
        let diff = shell.output(&format!("git diff {commit} -- src"))?;
        fs::write(&changes, diff).map_err(|error| error.to_string())?;
        list += " --in-diff target/mutants.diff";
    }
    let list = shell.output(&list)?;
    let wanted = |name: &&str| choice.only.as_ref().is_none_or(|text| name.contains(text.as_str()));
    let mut names: Vec<String> = list.lines().filter(wanted).map(str::to_owned).collect();
    if choice.since.is_none() {
        names.sort_by_key(|name| shuffled(name, choice.seed));
        names.truncate(choice.count);
    }
    Ok(names)
}

/// Returns a number that depends on the description and the seed only (FNV-1a), so that a draw changes little
/// when the library does.
fn shuffled(name: &str, seed: u64) -> u64 {
    let bytes = seed.to_le_bytes().into_iter().chain(name.bytes());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

/// Tries the changes with some harnesses.
///
/// The tool adds changes of its own in the same files: it also takes fields away whose values would then be
/// defaults, whether they were asked for or not.
fn try_all(
    shell: &Shell,
    name: &str,
    changes: &[&String],
    harnesses: &[&str],
    features: &str,
) -> Outcome<Tried> {
    if changes.is_empty() {
        return Ok(Tried::default());
    }
    let folder = format!("target/mutants/{name}");
    let _ = fs::remove_dir_all(root().join(&folder));
    fs::create_dir_all(root().join(&folder)).map_err(|error| error.to_string())?;
    let files: BTreeSet<&str> = changes.iter().filter_map(|change| change.split(':').next()).collect();
    let files: String = files.iter().map(|file| format!(" -f {file}")).collect();
    let exact: String = changes.iter().map(|change| format!(" -F ^{}$", literal(change))).collect();
    // Given to cargo each time, or all harnesses would be built for each change.
    let tests: String = harnesses.iter().map(|harness| format!(" --cargo-arg=--test={harness}")).collect();
    let line = format!(
        "cargo mutants -p nanospectra --profile mutants --test-tool nextest --no-shuffle --colors never \
         --timeout 60 -o {folder}{files}{exact}{tests}{features} -- --max-fail 1:immediate"
    );
    println!("== {} changes, {name}", changes.len());
    // Its exit code says whether something was missed, which the lists below say better.
    let status = shell.command(line.split_whitespace()).stderr(Stdio::inherit()).status();
    status.map_err(|error| format!("cargo mutants does not start: {error}"))?;
    let list = |name: &str| {
        let text = fs::read_to_string(root().join(&folder).join("mutants.out").join(name));
        text.map_err(|_| format!("cargo mutants did not finish; see {folder}/mutants.out/log"))
    };
    let seen = list("caught.txt")?.lines().count() + list("timeout.txt")?.lines().count();
    Ok(Tried { seen, unseen: list("missed.txt")?.lines().map(str::to_owned).collect() })
}

/// Returns a regular expression without blanks that matches only this text.
fn literal(text: &str) -> String {
    let character =
        |c: char| if c.is_ascii_alphanumeric() { c.into() } else { format!("\\x{{{:x}}}", c as u32) };
    text.chars().map(character).collect()
}

/// Fails if too many changes were not seen, or one that has no explanation.
fn report(Tried { seen, unseen }: &Tried) -> Outcome {
    let explained = explanations()?;
    let (known, open): (Vec<_>, Vec<_>) =
        unseen.iter().partition(|change| explained.contains_key(&without_place(change)));
    for change in &known {
        println!("not seen: {change}\n    because {}", explained[&without_place(change)]);
    }
    for change in &open {
        println!("NOT SEEN: {change}");
    }
    let all = seen + unseen.len();
    println!("{seen} of {all} changes were seen; {} more are explained", known.len());
    if !open.is_empty() {
        return Err(format!(
            "{} changes were not seen by any test; write tests of what they change, or explain them in \
             tests/xtask/data/mutants.txt",
            open.len()
        ));
    }
    if seen * 100 < SEEN * all {
        return Err(format!("less than {SEEN} % of the changes were seen"));
    }
    Ok(())
}

/// Returns a description without line and column, which change with every edit above them.
fn without_place(change: &str) -> String {
    let mut parts = change.splitn(4, ':');
    match (parts.next(), parts.nth(2)) {
        (Some(file), Some(what)) => format!("{file}:{what}"),
        _ => change.to_owned(),
    }
}

/// Returns why some changes have no effect, by their descriptions.
fn explanations() -> Outcome<BTreeMap<String, String>> {
    let path = root().join("tests/xtask/data/mutants.txt");
    let text = fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    let entries = text.lines().filter(|line| !line.is_empty() && !line.starts_with('#'));
    entries
        .map(|line| {
            let pair = line.split_once(" | ").map(|(what, why)| (what.to_owned(), why.to_owned()));
            pair.ok_or(format!("{}: `{line}` is not `description | reason`", path.display()))
        })
        .collect()
}
