//! 8 counts of a chip to XYZ, CCT, Duv and Lab, saturation checked, and nothing else.
//!
//! `tests/devices.sh` looks into this image as it does into `fold16`: no tables but 3 * 8 weights and the locus, no
//! `core::fmt`, no soft f64, no allocator. That it cannot panic is proved here, by linking.
#![no_std]
#![no_main]

use core::hint::black_box;
use nanospectra::sensor::Unusable;
use nanospectra_firmware::pipeline::{Color, measure};

/// What the bus left in memory.
static COUNTS: [u16; 8] = [1000; 8];

#[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
#[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
fn main() -> ! {
    loop {
        black_box(&reading(black_box(&COUNTS)));
    }
}

/// As an instrument calls it: apart from this loop, which would keep its constants in registers between readings.
#[inline(never)]
fn reading(counts: &[u16; 8]) -> Result<Color, Unusable> {
    measure(counts)
}

unsafe extern "C" {
    /// Defined nowhere: an image with a reachable panic does not link.
    safe fn this_image_can_panic() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    this_image_can_panic()
}
