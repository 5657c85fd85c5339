//! Prints the instructions that paths take from light to XYZ at 31 bands, as lines `name count`: a chain of
//! factors beside a loop written by hand, a dye, a Donaldson matrix, and two mirrors. All parts are read from
//! memory, so the compiler cannot use their values.
#![no_std]
#![no_main]

use nanospectra::light::FL11;
use nanospectra::matter::{Donaldson, Dye, Mirror};
use nanospectra::observer::{CIE_1931, Curve, Observer};
use nanospectra::{Light, Power, Reflectance};
use nanospectra_firmware::clock::Clock;
use nanospectra_firmware::vest::VEST;
use semihosting::{println, process};

static EYE: Observer<3, 31, Power> = CIE_1931.fold(Curve::Step);
/// The parts of the paths.
struct Parts {
    sun: Light<31>,
    glass: Reflectance<31>,
    paper: Reflectance<31>,
    vest: &'static Dye<31>,
    matrix: Donaldson<31, 496>,
    lake: Mirror<31>,
}

#[nanospectra_firmware::entry]
fn main() -> ! {
    let clock = Clock::start();
    let parts = Parts {
        sun: FL11.resample(),
        glass: Reflectance::flat(0.8),
        paper: Reflectance::flat(0.5),
        vest: &VEST,
        matrix: Donaldson::from_reflectance(&Reflectance::flat(0.5)),
        lake: Mirror::dielectric(&[1.33; 31], 0.6, 0.0),
    };
    count(&clock, "path-surface", |parts, xyz| *xyz = EYE.sees(parts.sun.onto(&parts.paper)), &parts);
    count(&clock, "path-surface-by-hand", surface_by_hand, &parts);
    count(
        &clock,
        "path-glass-surface",
        |parts, xyz| *xyz = EYE.sees(parts.sun.through(&parts.glass).onto(&parts.paper)),
        &parts,
    );
    count(&clock, "path-glass-surface-by-hand", glass_surface_by_hand, &parts);
    count(&clock, "path-dye", |parts, xyz| *xyz = EYE.sees(parts.sun.onto(parts.vest)), &parts);
    count(&clock, "path-donaldson", |parts, xyz| *xyz = EYE.sees(parts.sun.onto(&parts.matrix)), &parts);
    count(&clock, "path-two-mirrors", two_mirrors, &parts);
    process::exit(0)
}

fn count(clock: &Clock, name: &str, f: fn(&Parts, &mut [f32; 3]), parts: &Parts) {
    println!("{name} {}", clock.count(f, parts, &mut [0.0; 3]));
}

#[inline(never)]
fn surface_by_hand(parts: &Parts, xyz: &mut [f32; 3]) {
    let (sun, paper) = (parts.sun.values(), parts.paper.values());
    let mut bins = Light::flat(0.0);
    for (bin, (sun, paper)) in bins.values_mut().iter_mut().zip(sun.iter().zip(paper)) {
        *bin = sun * paper;
    }
    *xyz = EYE.sees(&bins);
}

#[inline(never)]
fn glass_surface_by_hand(parts: &Parts, xyz: &mut [f32; 3]) {
    let (sun, glass, paper) = (parts.sun.values(), parts.glass.values(), parts.paper.values());
    let mut bins = Light::flat(0.0);
    for (bin, ((sun, glass), paper)) in bins.values_mut().iter_mut().zip(sun.iter().zip(glass).zip(paper)) {
        *bin = sun * glass * paper;
    }
    *xyz = EYE.sees(&bins);
}

#[inline(never)]
fn two_mirrors(parts: &Parts, xyz: &mut [f32; 3]) {
    *xyz = EYE.sees(parts.sun.polarized().onto(&parts.lake).onto(&parts.lake).ignoring_polarization());
}
