//! Finds a reflectance of 31 bands for one RGB color by the default start map, and does nothing else.
//!
//! `tests/devices.sh` checks that the weights, the start map and the solver take at most 2.5 KB of flash, and
//! that there is no `core::fmt` and no software f64. Linking the image proves that it cannot panic.
#![no_std]
#![no_main]

mod without_panic;

use core::hint::black_box;
use nanospectra::color::Rgb;
use nanospectra::light::D65;
use nanospectra::observer::CIE_1931;
use nanospectra::upsample::{Sigmoid, Viewing};
use nanospectra::{Curve, Nodes};

type Eye = Viewing<31, Nodes<400, 700>>;

static SIGMOID: Sigmoid<31, Nodes<400, 700>> =
    Sigmoid::new(&Eye::new(&CIE_1931.under(&D65.fine()).fold(Curve::Step)));

#[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
#[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
fn main() -> ! {
    loop {
        let [r, g, b] = black_box([0.8, 0.2, 0.1]);
        black_box(SIGMOID.solve(Rgb::new(r, g, b)));
    }
}
