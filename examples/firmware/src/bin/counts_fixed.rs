//! 8 counts of a chip to XYZ, lux, CCT and Duv in integers, saturation checked, and nothing else.
//!
//! `tests/devices.sh` looks into this image as it does into `fold16`: no tables but 3 * 8 weights and the
//! locus, no `core::fmt`, no soft f64, no allocator. That it cannot panic is proved here, by linking.
#![no_std]
#![no_main]

mod without_panic;

use core::hint::black_box;
use nanospectra_firmware::pipeline::measure_fixed;

/// What the bus left in memory.
static COUNTS: [u16; 8] = [1000; 8];

#[nanospectra_firmware::entry]
fn main() -> ! {
    loop {
        black_box(&measure_fixed(black_box(&COUNTS)));
    }
}
