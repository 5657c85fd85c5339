//! Follows light from a lamp through a glass and over a surface to XYZ, without other effects.
//! `tests/devices.sh` checks that this image has no code of fluorescence or polarization. Linking it proves
//! that it cannot panic.
#![no_std]
#![no_main]

mod without_panic;

use core::hint::black_box;
use nanospectra::observer::{CIE_1931, Curve, Observer};
use nanospectra::{Light, Power, Reflectance};

static EYE: Observer<3, 31, Power> = CIE_1931.fold(Curve::Spline);

#[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
#[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
fn main() -> ! {
    loop {
        let sun = Light::<31>::from_bins(black_box([1.0; 31]));
        let (glass, paper) =
            (Reflectance::from_bins(black_box([0.8; 31])), Reflectance::flat(black_box(0.5)));
        black_box(EYE.sees(sun.through(&glass).onto(&paper)));
    }
}
