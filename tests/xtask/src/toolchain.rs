//! Which compilers there are, and how they are installed.

use crate::lane::Lane;
use crate::shell::{Outcome, Shell};

/// The compiler that the records of instructions, bytes and errors belong to.
pub const OF_RECORDS: &str = "1.95.0";
/// The oldest compiler that builds everything.
pub const OLDEST: &str = "1.88.0";

/// Cores that devices have.
pub const BOARDS: [&str; 4] = [
    "thumbv6m-none-eabi",
    "thumbv7em-none-eabihf",
    "thumbv8m.main-none-eabihf",
    "riscv32imac-unknown-none-elf",
];
pub const WASM: &str = "wasm32-unknown-unknown";

/// Fails if the compiler of the records is not here with its formatter and lints, and says what to type.
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

/// Installs the compiler of the records, valgrind, and those targets that can be had, which it returns.
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
        lane.skip(format!("target {target} cannot be installed: nothing was built for it"));
    }
    let apt = "sudo=; [[ $(id -u) == 0 ]] || sudo=sudo
        $sudo apt-get update && $sudo apt-get install -y --no-install-recommends valgrind";
    if !shell.succeeds("valgrind --version") && shell.bash(apt).is_err() {
        lane.skip("valgrind cannot be installed: no instructions of paths were counted on the host");
    }
    Ok(here)
}

/// Whether a compiler answers, once rustup has installed it if it did not. If not, the log says what that
/// means.
pub fn has(shell: &Shell, probe: &str, arguments: &str, without: &str) -> bool {
    let install = format!("rustup toolchain install {arguments} --profile minimal");
    let found = shell.succeeds(probe) || shell.run(&install).is_ok();
    if !found {
        shell.say(&format!("SKIPPED  {without}"));
    }
    found
}
