//! The task runner. Call `cargo xtask check` while you work, `full` before a change is merged, and `bless` to
//! renew records.

mod bless;
mod check;
mod docs;
mod full;
mod images;
mod lane;
mod mutants;
mod random;
mod shell;
mod toolchain;
mod workspace;

use clap::Parser;
use lane::Lane;
use shell::Shell;
use std::process::ExitCode;

/// Checks changes to nanospectra, tests everything that it promises, and renews its records.
///
/// Every task builds one package at a time. Packages that are built together share their features, so the
/// tests of one would see the features that another asks for.
#[derive(Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask")]
enum Task {
    /// Check format, lints, fast tests and documentation, as before every commit, in about three minutes
    ///
    /// It installs nothing and needs no root. If the compiler is missing, it says what to type.
    Check(Steps),
    /// Run the tests of the library in the dev profile, or those of some stations
    ///
    /// A station is a file tests/STATION/main.rs, such as color, matter or sensor.
    Test {
        /// The stations to test, or all of them if none is named
        station: Vec<String>,
        /// The arguments of the test harness, such as a part of a test's name
        #[arg(last = true)]
        harness: Vec<String>,
    },
    /// Change the library in small ways, at random, and look whether a test fails for each of them
    ///
    /// It installs cargo-mutants, and takes about ten seconds for a change. With `--since COMMIT` it tries
    /// the lines that were edited since then, which is the habit before a change is merged.
    Mutants(mutants::Choice),
    /// Run the tests that draw random cases, and no others, with each seed of a range, in the dev profile
    ///
    /// A seed takes about 12 seconds on one idle core, so 150 of them take half an hour.
    Seeds { first: u32, last: u32 },
    /// Run the fuzzers of the library in the dev profile, so many times each
    ///
    /// They are the files tests/STATION/STATION_bits.rs. The tests run them 2,000 times each.
    Fuzz {
        #[arg(default_value_t = 100_000)]
        runs: u32,
    },
    /// Test everything that is promised, as CI does, in about half an hour on two cores
    ///
    /// It installs what it needs: compilers and targets by rustup, and valgrind, QEMU and Chromium by apt-get
    /// (with sudo, unless it runs as root). Checks that need something which cannot be installed are listed
    /// at the end as SKIPPED. All steps run even if one fails, and then the exit code is 1.
    Full(Steps),
    /// Renew every record and every figure that is derived from one, and show the changes
    ///
    /// The records are the bits, instructions and bytes of devices, the largest errors of the tests, the hard
    /// cases, the cost study and the sizes of the web package. The figures in the README and in the
    /// documentation are taken from them. The tables in tables/upsample are no records but a part of the
    /// library. To compute them again, run `UPSAMPLE_FIT=write cargo test --release -p nanospectra --test
    /// upsample tables`.
    Bless(Steps),
}

#[derive(clap::Args)]
struct Steps {
    /// Run only the steps whose name contains this text
    #[arg(long, value_name = "TEXT")]
    only: Option<String>,
}

fn main() -> ExitCode {
    let result = match Task::parse() {
        Task::Check(steps) => check::run(Lane::new(steps.only)),
        Task::Test { station, harness } => test(&station, &harness),
        Task::Mutants(choice) => mutants::run(&choice),
        Task::Seeds { first, last } => random::seeds(first, last),
        Task::Fuzz { runs } => random::fuzz(runs),
        Task::Full(steps) => full::run(Lane::new(steps.only)),
        Task::Bless(steps) => bless::run(Lane::new(steps.only)),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("error: {why}");
            ExitCode::FAILURE
        }
    }
}

fn test(stations: &[String], harness: &[String]) -> shell::Outcome {
    toolchain::required()?;
    let stations: Vec<String> = stations.iter().map(|station| format!(" --test {station}")).collect();
    Shell::new().run(&format!(
        "cargo test --no-fail-fast -p nanospectra{} -- {}",
        stations.concat(),
        harness.join(" ")
    ))
}
