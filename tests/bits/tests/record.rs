//! The same bits on every machine: what this host computes, in this build with these features, is what is on
//! record.
//!
//! `tests/devices.sh` holds Cortex-M0, Cortex-M4F, RV32 and wasm to the same record.

#[test]
fn this_machine_computes_the_recorded_bits() {
    let mut computed = String::new();
    let mut line = |group: &str, hash: u32| computed += &format!("{group} {hash:08x}\n");
    nanospectra_bits::run(&mut line);
    nanospectra_bits::run_large(&mut line);
    let recorded = include_str!("../../data/bits.txt").lines().filter(|line| !line.starts_with('#'));
    let recorded: String = recorded.flat_map(|line| [line, "\n"]).collect();
    assert_eq!(computed, recorded, "if the results were meant to change, `cargo xtask bless` records these");
}
