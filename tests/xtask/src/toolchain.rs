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

/// What could be installed.
pub struct Installed {
    /// Of [`BOARDS`] and [`WASM`].
    pub targets: Vec<&'static str>,
    /// Whether there is the compiler [`OLDEST`].
    pub oldest: bool,
    /// Whether there is a nightly compiler with Miri.
    pub miri: bool,
}

impl Installed {
    pub fn has(&self, target: &str) -> bool {
        self.targets.contains(&target)
    }
}

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

/// Installs every compiler, every target and valgrind. Only the compiler of the records is indispensable.
pub fn install_all(lane: &mut Lane) -> Outcome<Installed> {
    let shell = Shell::new();
    if required().is_err() {
        shell.run(&install())?;
    }
    let mut targets = Vec::new();
    for target in BOARDS.into_iter().chain([WASM]) {
        if shell.run(&format!("rustup target add {target}")).is_ok() {
            targets.push(target);
        } else {
            lane.skip(format!("target {target} cannot be installed: nothing was built for it"));
        }
    }
    let mut compiler = |probe: &str, install: &str, without: &str| {
        let found = shell.succeeds(probe) || shell.run(install).is_ok();
        if !found {
            lane.skip(without);
        }
        found
    };
    let oldest = compiler(
        &format!("cargo +{OLDEST} --version"),
        &format!("rustup toolchain install {OLDEST} --profile minimal"),
        &format!(
            "Rust {OLDEST} cannot be installed: it was not tried whether that compiler builds everything"
        ),
    );
    let miri = compiler(
        "cargo +nightly miri --version",
        "rustup toolchain install nightly --profile minimal --component miri --component rust-src",
        "a nightly compiler with Miri cannot be installed: the unsafe code of the x86-64 kernel was not interpreted",
    );
    let apt = "sudo=; [[ $(id -u) == 0 ]] || sudo=sudo
        $sudo apt-get update && $sudo apt-get install -y --no-install-recommends valgrind";
    if !shell.succeeds("valgrind --version") && shell.bash(apt).is_err() {
        lane.skip("valgrind cannot be installed: no instructions of paths were counted on the host");
    }
    Ok(Installed { targets, oldest, miri })
}
