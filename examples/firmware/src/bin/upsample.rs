//! One RGB to the reflectance that has it, on 31 bands, by the default start map, and nothing else.
//!
//! `tests/devices.sh` looks into this image: the weights, the start map and the solver in 2.5 KB of flash, no
//! `core::fmt`, no soft f64, nothing of libm. That it cannot panic is proved here, by linking.
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
