//! Prints the instructions of a static scene with a fluorescent vest that is folded into the observer. What
//! is left at run time is a filter before the lamp, whose effect on the vest's color is computed. Like
//! `price_whole`, it is an image of its own, so that nothing else shares the sum.
#![no_std]
#![no_main]

use nanospectra::observer::{CIE_1931, Curve, Observer};
use nanospectra::{Power, Reflectance};
use nanospectra_firmware::clock::Clock;
use nanospectra_firmware::vest::{LAMP, VEST};
use semihosting::{println, process};

const EYE: Observer<3, 31, Power> = CIE_1931.fold(Curve::Spline);
static SCENE: Observer<3, 31> = EYE.looking_at_dye(&VEST).under(&LAMP);

#[nanospectra_firmware::entry]
fn main() -> ! {
    let clock = Clock::start();
    let filter = Reflectance::flat(0.8);
    println!(
        "path-vest-folded {}",
        clock.count(|filter, xyz| *xyz = SCENE.sees(filter), &filter, &mut [0.0; 3])
    );
    process::exit(0)
}
