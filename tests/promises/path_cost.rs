//! On x86-64 a path of factors takes the instructions of the loop that a hand would write with the same
//! buffer and row kernel: counted by callgrind, at opt-level 3 and "s". (`tests/devices.sh` counts on
//! Cortex-M.)
#![cfg(all(target_arch = "x86_64", target_os = "linux"))]

use crate::programs::Package;
use std::path::Path;
use std::process::Command;

/// Instructions of one call of a function of the program, those that it calls with them.
fn instructions(binary: &Path, function: &str) -> u64 {
    let out = binary.with_extension(format!("{function}.callgrind"));
    let status = Command::new("valgrind")
        .arg("--tool=callgrind")
        .arg(format!("--callgrind-out-file={}", out.display()))
        .arg(format!("--toggle-collect=program::{function}"))
        .arg(binary)
        .output()
        .expect("valgrind runs");
    assert!(status.status.success(), "{}", String::from_utf8_lossy(&status.stderr));
    let counts = std::fs::read_to_string(&out).expect("callgrind writes its counts");
    let total = counts.lines().find_map(|line| line.strip_prefix("totals: ")).expect("a line of totals");
    total.trim().parse().expect("one kind of event")
}

#[test]
fn a_path_of_factors_takes_what_the_loop_by_hand_takes() {
    if !Command::new("valgrind").arg("--version").output().is_ok_and(|output| output.status.success()) {
        println!("SKIPPED: valgrind is not installed, so no instructions of paths were counted");
        return;
    }
    let manifest = format!(
        "[package]\nname = \"path_cost\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n\
         [dependencies]\nnanospectra = {{ path = {:?}, default-features = false }}\n\n\
         [profile.release]\nlto = \"fat\"\ncodegen-units = 1\n\n\
         [profile.small]\ninherits = \"release\"\nopt-level = \"s\"\n\n[workspace]\n",
        env!("CARGO_MANIFEST_DIR")
    );
    let package = Package::new("path_cost", &manifest);
    package.write("src/bin/program.rs", include_str!("path_cost/program.rs"));
    for profile in ["release", "small"] {
        let output = package.cargo(&["build", "--profile", profile]);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let binary = package.folder.join("target").join(profile).join("program");
        for what in ["surface", "glass_surface"] {
            let path = instructions(&binary, &format!("{what}_by_path"));
            let hand = instructions(&binary, &format!("{what}_by_hand"));
            println!("{profile}: {what} takes {path} instructions, by hand {hand}");
            assert!(path > 100 && hand > 100, "nothing was counted");
            // (At "s" three iterators in one by hand take an instruction more for each of the 31 bins.)
            let equal = path * 100 <= hand * 102 && hand <= path + 31;
            assert!(equal, "{profile}: {what} takes {path} instructions, by hand {hand}");
        }
    }
}
