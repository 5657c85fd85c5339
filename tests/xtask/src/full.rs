//! The tests of everything that is promised.

use crate::check::{STATIONS, documentation, each, format, harnesses, lints, walls};
use crate::lane::Lane;
use crate::shell::{Outcome, Shell, root};
use crate::toolchain::{self, BOARDS, OLDEST, WASM};
use crate::workspace::{self, APART, Package};

/// The features of the library, each of which must build by itself.
const FEATURES: [&str; 6] = ["libm", "std", "simd", "micromath", "heapless", "defmt"];

/// The packages for crates.io. The program comes last, since it depends on the others.
const PUBLISHED: [&str; 3] = ["nanospectra", "nanospectra-files", "nanospectra-cli"];

/// The texts of licenses that each of them must contain, and that of the CIE's tables, which the reader of files has
/// not.
const LICENSES: [&str; 2] = ["LICENSE-APACHE", "LICENSE-MIT"];
const LICENSE_OF_TABLES: &str = "LICENSE-CC-BY-SA-4.0";

pub fn run(lane: Lane) -> Outcome {
    // Nobody debugs these builds, and without debug information they compile a quarter less.
    let mut lane = lane.with("CARGO_PROFILE_DEV_DEBUG", "0");
    println!("== installing what is missing");
    let targets = toolchain::install_all(&mut lane)?;
    let packages = workspace::packages()?;
    format(&mut lane);
    walls(&mut lane);
    lane.beside(|lane| beside(lane, &targets, &packages), |lane| tests(lane, &packages))?;
    lane.report()
}

/// Runs the tests for the target of this machine.
fn tests(lane: &mut Lane, packages: &[Package]) {
    lints(lane, packages);
    documentation(lane, packages);
    lane.step("tests of every package, in the release profile", |shell| {
        each(packages, shell, |name| format!("cargo test --release --no-fail-fast -p {name}"))
    });
    lane.step("the math backend Fast, over every fifth f32", |shell| {
        let shell = shell.again().with("NANOSPECTRA_STRIDE", "5");
        shell.filtered("cargo test --release -p nanospectra --test spectrum every_f32")
    });
    lane.step("all 2^24 sRGB colors with the default map, every eighth with the others", |shell| {
        let upsample = "cargo test --release -p nanospectra --test upsample";
        shell.again().with("NANOSPECTRA_STRIDE", "1").filtered(&format!("{upsample} cubic_map"))?;
        let others = format!("{upsample} all:: -- --skip cubic_map");
        shell.again().with("NANOSPECTRA_STRIDE", "2").filtered(&others)
    });
    lane.step("tests that check for overflow: with all features, then with none", |shell| {
        let test = "cargo test --no-fail-fast -p nanospectra";
        let some = harnesses(&["spectrum", "path", "sensor", "upsample"]);
        let most = harnesses(&STATIONS);
        shell.run(&format!("{test} --all-features --lib {some}"))?;
        shell.run("cargo test -p nanospectra-bits --features simd")?;
        shell.run(&format!("{test} --all-features --doc"))?;
        shell.run(&format!("{test} --no-default-features --lib {most}"))?;
        shell.run(&format!("{test} --no-default-features --doc"))
    });
    lane.step("the benches run and check their results", |shell| benches(shell, packages));
    lane.run(
        "the cost study: every figure on record, and the tables of the README and the guides",
        "cargo run --release -p nanospectra-cost -- --quick --check",
    );
    lane.step("the examples and the first command of the README run", |shell| {
        for name in workspace::examples()? {
            shell.run(&format!("cargo run --release -p nanospectra --example {name}"))?;
        }
        shell.run("cargo run --release")
    });
    lane.step("the packages are complete", |shell| {
        PUBLISHED.iter().try_for_each(|name| has_licenses(shell, name))?;
        // Cargo unpacks and builds the first package for the second only once per version, so an earlier run
        // would leave it stale.
        shell.bash(r#"rm -rf target/packaged "${CARGO_HOME:-$HOME/.cargo}"/registry/{src,cache}/*/nanospectra-[0-9]*"#)?;
        // They are packed together, since the second depends on the first, which no registry has in this
        // version.
        let shell = shell.again().with("CARGO_TARGET_DIR", "target/packaged");
        shell.run(&format!("cargo package -p {} --allow-dirty", PUBLISHED.join(" -p ")))
    });
}

/// Checks that a package has the texts of its licenses, those of the code and that of the CIE's tables.
fn has_licenses(shell: &Shell, package: &str) -> Outcome {
    let files = shell.output(&format!("cargo package --list --allow-dirty -p {package}"))?;
    let lacks = |license: &&str| !files.lines().any(|file| file == *license);
    let of_tables = Some(LICENSE_OF_TABLES).filter(|_| package != "nanospectra-files");
    match LICENSES.into_iter().chain(of_tables).find(lacks) {
        Some(license) => Err(format!("the package {package} does not contain {license}")),
        None => Ok(()),
    }
}

/// Runs every bench once, which compares the results with those of other crates.
pub fn benches(shell: &Shell, packages: &[Package]) -> Outcome {
    packages.iter().filter(|package| !package.benches.is_empty()).try_for_each(|package| {
        let benches: String = package.benches.iter().map(|name| format!("--bench {name} ")).collect();
        shell.run(&format!("cargo bench -p {} {benches}-- --test", package.name))
    })
}

/// Runs the tests for other compilers and other targets.
fn beside(lane: &mut Lane, targets: &[&str], packages: &[Package]) {
    lane.step("lints with each feature, none and all; with none and all on other targets", |shell| {
        lints_with_features(shell, targets)
    });
    lane.step("x86 without SSE2: a program for UEFI takes no vectors, and the x87 is refused", without_sse2);
    lane.step("lints of the packages for devices and for the web", |shell| lints_apart(shell, targets));
    lane.step("the oldest compiler builds everything", |shell| oldest_compiler(shell, packages));
    lane.step("Miri interprets the kernel for x86-64", miri);
    lane.run("devices: bits, instructions and bytes", "bash tests/devices.sh --install");
    lane.run("the web: the package in node, the page in a browser", "bash examples/web/test.sh");
}

fn lints_with_features(shell: &Shell, targets: &[&str]) -> Outcome {
    let shell = shell.again().with("CARGO_TARGET_DIR", "target/features");
    let (none, all) = (String::new(), format!("--features {}", FEATURES.join(",")));
    let lint = |target: &str, features: &str| {
        shell.run(&format!(
            "cargo clippy -p nanospectra {target} --no-default-features {features} -- -D warnings"
        ))
    };
    // The default features are not tried here, since the packages for devices and for the web use them.
    for feature in FEATURES {
        lint("", &format!("--features {feature}"))?;
    }
    for features in [&none, &all] {
        lint("", features)?;
        let others = ["thumbv6m-none-eabi", "thumbv7em-none-eabihf", WASM];
        for target in others.into_iter().filter(|target| targets.contains(target)) {
            lint(&format!("--target {target}"), features)?;
        }
    }
    Ok(())
}

fn without_sse2(shell: &Shell) -> Outcome {
    let shell = shell.again().with("CARGO_TARGET_DIR", "target/features");
    let (uefi, x87) = ("x86_64-unknown-uefi", "i586-unknown-linux-gnu");
    for target in [uefi, x87] {
        if !shell.succeeds(&format!("rustup target add {target}")) {
            shell.say(&format!("SKIPPED  {target} cannot be installed, so nothing was built for it"));
            return Ok(());
        }
    }
    // The files that were compiled, as a build system asks for them.
    let files = "target/features/uefi.d";
    shell.run(&format!(
        "cargo rustc -p nanospectra --lib --features simd --target {uefi} -- --emit dep-info={files}"
    ))?;
    let compiled =
        std::fs::read_to_string(root().join(files)).map_err(|error| format!("{files}: {error}"))?;
    if !compiled.contains("src/sum/scalar.rs") || compiled.contains("src/sum/x86.rs") {
        return Err(format!("{uefi} has no SSE2, but the library does not sum in scalars there"));
    }
    let check = format!("cargo check -p nanospectra --target {x87}");
    shell.bash(&format!("{check} 2>&1 | grep 'this target computes on the x87'"))?;
    shell.again().with("RUSTFLAGS", "--cfg nanospectra_x87").run(&check)
}

fn lints_apart(shell: &Shell, targets: &[&str]) -> Outcome {
    let [firmware, decode, web] = APART.map(|folder| shell.again().at(folder));
    for target in BOARDS.into_iter().filter(|target| targets.contains(target)) {
        firmware.run(&format!("cargo clippy --quiet --target {target} --bins --tests -- -D warnings"))?;
    }
    if targets.contains(&"thumbv7em-none-eabihf") {
        let measure = "--target thumbv7em-none-eabihf --no-default-features --features measure";
        firmware.run(&format!("cargo clippy --quiet {measure} -- -D warnings"))?;
        let no_panic = "--target thumbv7em-none-eabihf --no-default-features --features no-panic";
        firmware.run(&format!("cargo clippy --quiet {no_panic} -- -D warnings"))?;
    }
    firmware.run("cargo clippy --quiet --bins --tests -- -D warnings")?;
    decode.run("cargo clippy --quiet -- -D warnings")?;
    if targets.contains(&WASM) { web.run("cargo clippy --quiet -- -D warnings") } else { Ok(()) }
}

fn oldest_compiler(shell: &Shell, packages: &[Package]) -> Outcome {
    let without =
        format!("Rust {OLDEST} cannot be installed, so it was not tried whether it builds everything");
    if !toolchain::has(shell, &format!("cargo +{OLDEST} --version"), OLDEST, &without) {
        return Ok(());
    }
    let shell = shell.again().with("CARGO_TARGET_DIR", root().join("target/oldest"));
    let check = format!("cargo +{OLDEST} check --quiet --locked");
    each(packages, &shell, |name| format!("{check} -p {name} --all-targets"))?;
    shell.run(&format!("{check} -p nanospectra --all-features"))?;
    shell.run(&format!("{check} -p nanospectra --no-default-features"))?;
    let [firmware, decode, web] = APART.map(|folder| shell.again().at(folder));
    firmware.run(&format!("{check} --bins --tests"))?;
    decode.run(&format!("{check} --all-targets"))?;
    if !shell.succeeds(&format!("rustup target add --toolchain {OLDEST} {WASM}")) {
        shell.say(&format!(
            "SKIPPED  {WASM} cannot be installed for Rust {OLDEST}, so the web package was not tried"
        ));
        return Ok(());
    }
    web.run(&check)
}

/// Checks the order of additions with four lanes and with eight, which executes every load of the kernel.
fn miri(shell: &Shell) -> Outcome {
    if !shell.output("rustc -vV")?.contains("host: x86_64") {
        shell.say("SKIPPED  Miri: this is not an x86-64, so there is no unsafe code in the kernel");
        return Ok(());
    }
    let components = "nightly --component miri --component rust-src";
    let without = "a nightly compiler with Miri cannot be installed, so the unsafe code of the kernel was not interpreted";
    if !toolchain::has(shell, "cargo +nightly miri --version", components, without) {
        return Ok(());
    }
    let test = "order::sums_are_taken_in_the_promised_order";
    let line = format!("cargo +nightly miri test -p nanospectra --test promises -- {test} --exact");
    shell.filtered(&line)?;
    shell.again().with("RUSTFLAGS", "-Ctarget-cpu=x86-64-v3").filtered(&line)
}
