//! The same bits on every machine: what this host computes, in this build with these features, is what is on
//! record.
//!
//! `tests/devices.sh` holds Cortex-M0, Cortex-M4F, RV32 and wasm to the same record, by the same source file.
#![cfg(feature = "libm")]

#[path = "../examples/firmware/src/bits/mod.rs"]
mod bits;
#[path = "order/program.rs"]
mod order;
#[cfg(target_arch = "x86_64")]
mod programs;

#[test]
fn this_machine_computes_the_recorded_bits() {
    let mut computed = String::new();
    let mut line = |group: &str, hash: u32| computed += &format!("{group} {hash:08x}\n");
    bits::run(&mut line);
    bits::run_large(&mut line);
    let recorded = include_str!("data/bits.txt").lines().filter(|line| !line.starts_with('#'));
    let recorded: String = recorded.flat_map(|line| [line, "\n"]).collect();
    assert_eq!(
        computed, recorded,
        "if the results were meant to change, `tests/devices.sh --bless` records these"
    );
}

/// Whatever vectors a host has, and whatever is left over by them.
#[test]
fn sums_are_taken_in_the_promised_order() {
    order::main();
}

#[cfg(target_arch = "x86_64")]
#[test]
fn sums_are_taken_in_the_promised_order_by_eight_lanes_too() {
    if !std::arch::is_x86_feature_detected!("avx2") {
        println!("SKIPPED: this host has no AVX2");
        return;
    }
    let package =
        programs::Package::using_the_crate("order", &[("program", include_str!("order/program.rs"))]);
    let flags = "build.rustflags=['-Ctarget-cpu=x86-64-v3']";
    let output = package.cargo(&["run", "--release", "--config", flags]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}
