//! Turns 8 counts of a chip into XYZ, lux, CCT and Duv in integers, checks for saturation, and does nothing
//! else.
//!
//! `tests/devices.sh` checks, as for `fold16`, that this image has no tables except 3 * 8 weights and the
//! Planckian locus, no `core::fmt`, no software f64 and no allocator. Linking it proves that it cannot panic.
#![no_std]
#![no_main]

mod without_panic;

use core::hint::black_box;
use nanospectra_firmware::pipeline::measure_fixed;

/// The counts that the bus has left in memory.
static COUNTS: [u16; 8] = [1000; 8];

#[nanospectra_firmware::entry]
fn main() -> ! {
    loop {
        black_box(&measure_fixed(black_box(&COUNTS)));
    }
}
