//! Turns 16 bands of a surface into XYZ under FL11, with the lamp folded into the observer by the compiler,
//! and does nothing else.
//!
//! `tests/devices.sh` checks that this image has 3 * 16 weights and not one more byte of tables, no
//! `core::fmt` and no software f64. Linking it proves that it cannot panic.
#![no_std]
#![no_main]

mod without_panic;

use core::hint::black_box;
use nanospectra::Reflectance;
use nanospectra::light::FL11;
use nanospectra::observer::{CIE_1931, Curve, Observer};

static EYE: Observer<3, 16> = CIE_1931.under(&FL11.fine()).fold(Curve::Spline).with_white_y(100.0);

#[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
#[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
fn main() -> ! {
    loop {
        let paper = Reflectance::<16>::from_bins(black_box([0.5; 16]));
        black_box(EYE.sees(&paper));
    }
}
