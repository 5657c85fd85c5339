//! One hash for each group of results, over their raw bits.
//!
//! The library promises the same bits on every target, and this package is compiled for all of them: into the
//! firmware images, the wasm module, and `tests/record.rs` on a host. What each reports is compared with
//! `tests/data/bits.txt`.

#![no_std]

mod appearance;
mod colors;
mod hash;
mod paths;
mod scenes;
pub mod sensor;
mod surfaces;

pub use hash::Hash;

/// Computes all groups and tells `report` the name and hash of each.
pub fn run(report: &mut impl FnMut(&str, u32)) {
    colors::run(report);
    sensor::run(report);
    paths::run(report);
    surfaces::run(report);
    appearance::run(report);
}

/// The groups whose code (37 KB on a Cortex-M0) or tables (159 KB) do not fit a small part beside the others.
pub fn run_large(report: &mut impl FnMut(&str, u32)) {
    scenes::run(report);
    report("tm30", Hash::of(colors::fidelity));
}
