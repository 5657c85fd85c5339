//! The compilers and targets, and how they are installed.

use crate::lane::Lane;
use crate::shell::{Outcome, Shell};

/// The compiler that the records of instructions, bytes and errors belong to.
pub const OF_RECORDS: &str = "1.95.0";
/// The oldest compiler that builds everything.
pub const OLDEST: &str = "1.88.0";

/// The targets of boards.
pub const BOARDS: [&str; 4] = [
    "thumbv6m-none-eabi",
    "thumbv7em-none-eabihf",
    "thumbv8m.main-none-eabihf",
    "riscv32imac-unknown-none-elf",
];
pub const WASM: &str = "wasm32-unknown-unknown";

/// Fails if the compiler of the records is not installed with its formatter and lints, and says what to type.
pub fn required() -> Outcome {
    let shell = Shell::new();
    if shell.succeeds("cargo fmt --version") && shell.succeeds("cargo clippy --version") {
        return Ok(());
    }
    Err(format!("Rust {OF_RECORDS} is not installed with its formatter and lints; type\n    {}", install()))
}

fn install() -> String {
    format!("rustup toolchain install {OF_RECORDS} --profile minimal --component rustfmt --component clippy")
}

/// Installs the compiler of the records, valgrind and the targets, and returns the targets that are
/// installed.
pub fn install_all(lane: &mut Lane) -> Outcome<Vec<&'static str>> {
    let shell = Shell::new();
    if required().is_err() {
        shell.run(&install())?;
    }
    let (here, missing): (Vec<_>, Vec<_>) = BOARDS
        .into_iter()
        .chain([WASM])
        .partition(|target| shell.run(&format!("rustup target add {target}")).is_ok());
    for target in missing {
        lane.skip(format!("target {target} cannot be installed, so nothing was built for it"));
    }
    let apt = "sudo=; [[ $(id -u) == 0 ]] || sudo=sudo
        $sudo apt-get update && $sudo apt-get install -y --no-install-recommends valgrind";
    if !shell.succeeds("valgrind --version") && shell.bash(apt).is_err() {
        lane.skip("valgrind cannot be installed, so the instructions of paths were not counted on the host");
    }
    Ok(here)
}

/// Returns whether a compiler is installed, after rustup has tried to install it if it was missing. If it
/// still is, the log says what was skipped.
pub fn has(shell: &Shell, probe: &str, arguments: &str, without: &str) -> bool {
    let install = format!("rustup toolchain install {arguments} --profile minimal");
    let found = shell.succeeds(probe) || shell.run(&install).is_ok();
    if !found {
        shell.say(&format!("SKIPPED  {without}"));
    }
    found
}
