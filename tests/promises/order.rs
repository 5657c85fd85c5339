//! The order of additions is promised, whatever vectors a host has, and whatever is left over by them.

mod program;

#[cfg(target_arch = "x86_64")]
use crate::programs::Package;

#[test]
fn sums_are_taken_in_the_promised_order() {
    program::main();
}

#[cfg(target_arch = "x86_64")]
#[test]
fn sums_are_taken_in_the_promised_order_by_eight_lanes_too() {
    if !std::arch::is_x86_feature_detected!("avx2") {
        println!("SKIPPED: this host has no AVX2");
        return;
    }
    let package = Package::using_the_crate("order", &[("program", include_str!("order/program.rs"))]);
    let flags = "build.rustflags=['-Ctarget-cpu=x86-64-v3']";
    let output = package.cargo(&["run", "--release", "--config", flags]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}
