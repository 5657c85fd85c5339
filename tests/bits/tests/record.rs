//! The same bits on every machine: what this host computes, in this build with these features, is what is on
//! record.
//!
//! `tests/devices.sh` holds Cortex-M0, Cortex-M4F, RV32 and wasm to the same record.

#[test]
fn this_machine_computes_the_recorded_bits() {
    let mut computed = Vec::new();
    let mut line = |group: &str, hash: u32| computed.push(format!("{group} {hash:08x}"));
    nanospectra_bits::run(&mut line);
    nanospectra_bits::run_large(&mut line);
    let recorded: Vec<&str> =
        include_str!("../../data/bits.txt").lines().filter(|line| !line.starts_with('#')).collect();
    for (computed, recorded) in computed.iter().zip(&recorded) {
        assert_eq!(
            computed, recorded,
            "if this group was meant to change, write what was computed into tests/data/bits.txt"
        );
    }
    assert_eq!(computed.len(), recorded.len(), "groups");
}
