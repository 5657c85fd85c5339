//! Prints the instructions that N bands of light take over a surface to XYZ, as lines `name count`. Nothing
//! is folded, because the light changes from call to call. It is an image of its own, since in `path_count`
//! 31 bands share the observer's loop with other paths.
#![no_std]
#![no_main]

use nanospectra::light::FL11;
use nanospectra::observer::{CIE_1931, Curve, Observer};
use nanospectra::{Light, Power, Reflectance};
use nanospectra_firmware::clock::Clock;
use semihosting::{println, process};

struct Parts<const N: usize> {
    lamp: Light<N>,
    paper: Reflectance<N>,
}

impl<const N: usize> Parts<N> {
    const EYE: &'static Observer<3, N, Power> = &CIE_1931.fold(Curve::Step);

    fn new() -> Self {
        Parts { lamp: FL11.resample(), paper: Reflectance::flat(0.5) }
    }
}

#[nanospectra_firmware::entry]
fn main() -> ! {
    let clock = Clock::start();
    macro_rules! each {
        ($($n:literal)*) => { $(count::<$n>(&clock);)* };
    }
    each!(3 8 12 16 20 24 31 36 40 60 81 95);
    process::exit(0)
}

fn count<const N: usize>(clock: &Clock) {
    println!("path-surface-{N} {}", clock.count(surface::<N>, &Parts::new(), &mut [0.0; 3]));
}

#[inline(never)]
fn surface<const N: usize>(Parts { lamp, paper }: &Parts<N>, xyz: &mut [f32; 3]) {
    *xyz = Parts::<N>::EYE.sees(lamp.onto(paper));
}
