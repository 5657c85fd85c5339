//! Turns 8 counts of a chip into XYZ, CCT, Duv and Lab, checks for saturation, and does nothing else.
//!
//! `tests/devices.sh` checks, as for `fold16`, that this image has no tables except 3 * 8 weights and the
//! Planckian locus, no `core::fmt`, no software f64 and no allocator. Linking it proves that it cannot panic.
#![no_std]
#![no_main]

mod without_panic;

use core::hint::black_box;
use nanospectra::sensor::ReadingError;
use nanospectra_firmware::pipeline::{Color, measure};

/// The counts that the bus has left in memory.
static COUNTS: [u16; 8] = [1000; 8];

#[nanospectra_firmware::entry]
fn main() -> ! {
    loop {
        black_box(&reading(black_box(&COUNTS)));
    }
}

/// Takes one reading, as an instrument does. It is a function of its own because the loop in `main` would
/// keep constants in registers from one reading to the next.
#[inline(never)]
fn reading(counts: &[u16; 8]) -> Result<Color, ReadingError> {
    measure(counts)
}
