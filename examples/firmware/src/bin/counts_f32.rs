//! 8 counts of a chip to XYZ, CCT, Duv and Lab, saturation checked, and nothing else.
//!
//! `tests/devices.sh` looks into this image as it does into `fold16`: no tables but 3 * 8 weights and the
//! locus, no `core::fmt`, no soft f64, no allocator. That it cannot panic is proved here, by linking.
#![no_std]
#![no_main]

mod without_panic;

use core::hint::black_box;
use nanospectra::sensor::ReadingError;
use nanospectra_firmware::pipeline::{Color, measure};

/// What the bus left in memory.
static COUNTS: [u16; 8] = [1000; 8];

#[nanospectra_firmware::entry]
fn main() -> ! {
    loop {
        black_box(&reading(black_box(&COUNTS)));
    }
}

/// As an instrument calls it: apart from this loop, which would keep its constants in registers between
/// readings.
#[inline(never)]
fn reading(counts: &[u16; 8]) -> Result<Color, ReadingError> {
    measure(counts)
}
