//! 16 bands of a surface to XYZ under FL11, folded while compiling, and nothing else.
//!
//! `tests/devices.sh` looks into this image: 3 * 16 weights and not one more byte of tables, no `core::fmt`,
//! no soft f64. That it cannot panic is proved here, by linking.
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
