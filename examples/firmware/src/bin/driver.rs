//! Reads a sensor by a published driver: the crate `as7341` turns bytes on a bus into counts, and this crate
//! turns the counts into color.
//!
//! The bus is simulated, with an AS7341 under an LED. On a board, the I2C and the delay of your HAL take its
//! place. The image runs on a host (`cargo run --bin driver`) and on boards (`--target <triple>`).
#![cfg_attr(target_os = "none", no_std, no_main)]

use as7341::{As7341, Gain};
use nanospectra::color::{Cct, Xyz};
use nanospectra::sensor::chip;
use nanospectra_firmware::mock_bus::{As7341Registers, NoDelay};
use nanospectra_firmware::pipeline::TO_XYZ;
#[cfg(target_os = "none")]
use semihosting::{println, process};
#[cfg(not(target_os = "none"))]
use std::process;

#[cfg(not(target_os = "none"))]
fn main() {
    process::exit(read())
}

#[cfg(target_os = "none")]
#[nanospectra_firmware::entry]
fn main() -> ! {
    process::exit(read())
}

/// The counts of F1 to F8, Clear and NIR under LED-B1 at 500 lx.
const DIODES: [u16; 10] = [106, 1023, 1182, 2001, 3619, 5224, 6082, 3066, 6231, 240];

/// Takes one reading and returns the exit code.
fn read() -> i32 {
    let mut chip = As7341::new(As7341Registers::counting(DIODES), NoDelay);
    let (gain, atime, astep) = (Gain::X16, 29, 599);
    let reading = chip
        .init()
        .and_then(|()| chip.set_gain(gain))
        .and_then(|()| chip.set_atime(atime))
        .and_then(|()| chip.set_astep(astep))
        .and_then(|()| chip.read_all_channels());
    let Ok(reading) = reading else {
        println!("the chip does not answer");
        return 1;
    };
    // The first eight of the ten counts are those of F1 to F8.
    let [counts @ .., _clear, _nir] = reading.as_array();
    let exposure = chip::as7341::exposure(gain.multiplier(), atime, astep);

    let color = exposure.basic_counts(&counts).and_then(|basic| TO_XYZ.xyz(&basic));
    let cct = color.ok().and_then(Xyz::cct);
    let Some(Cct::Near { cct_k, duv }) = cct else {
        println!("no color temperature: {color:?}");
        return 1;
    };
    println!("counts {counts:?}: {cct_k:.0} K, Duv {duv:.4}");
    // By `nanospectra measure`, which uses the whole spectrum, LED-B1 has 2735 K.
    i32::from((cct_k - 2735.0).abs() > 2.0)
}
