//! Prints the instructions of each function of each math backend, and of calls that use them, as lines
//! `math-function-backend count`. They are counted as in `count`.
//!
//! This is an image of its own because `Libm` computes in software f64, which `count` must not contain.
#![no_std]
#![no_main]

use nanospectra::color::{Rgb, Srgb, Xyz, transfer};
use nanospectra::light::blackbody_with;
use nanospectra::math::{Fast, Libm, Math, Micromath, Portable};
use nanospectra::matter::{Dielectric, Glass, N_BK7};
use nanospectra_firmware::clock::Clock;
use semihosting::{println, process};

static WHITE: Xyz = Xyz { x: 95.047, y: 100.0, z: 108.883 };

#[nanospectra_firmware::entry]
fn main() -> ! {
    let clock = Clock::start();
    backend::<Portable>(&clock, "portable");
    backend::<Fast>(&clock, "fast");
    backend::<Libm>(&clock, "libm");
    backend::<Micromath>(&clock, "micromath");
    // These take no backend: they only need a square root, which the core has or which is taken in integers.
    let fresnel =
        clock.longest(|cos, shares| *shares = Some(Dielectric::new(1.5).fresnel(*cos)), &[1.0, 0.5, 0.1]);
    let sellmeier = clock.longest(|nm, index| *index = N_BK7.index(*nm), &[400.0, 589.3, 700.0]);
    println!("math-fresnel {fresnel}");
    println!("math-sellmeier {sellmeier}");
    process::exit(0)
}

/// Counts each function of a backend over large and small numbers, of both signs where the function takes
/// both.
fn backend<M: Math>(clock: &Clock, name: &str) {
    let all = [2.0, 1e-30, 1e30, 0.18, 1.0];
    let signed = [2.0, -1e-30, 1e30, 0.18, -20.0];
    let signals = [0.0031, 0.18, 0.5, 1.0, 100.0];
    let angles = [0.1, -0.3, 0.6, 0.9, 12.4];
    let logs = [0.4, -0.7, 5.0, -20.0, 80.0];
    let points = [[1.0, 2.0], [-2.0, 1.0], [3.0, -1.0], [-1.0, -4.0], [0.0, 1.0]];
    let colors = [[40.0, 50.0, 45.0], [0.3, 0.4, 0.2], [20.0, 10.0, 90.0], [40.0, 20.0, 0.5]].map(Xyz::from);
    // Pairs of nm and K: the blue and the red of a lamp, and a pair where e^x nearly overflows.
    let glowing = [[450.0, 2856.0], [700.0, 6500.0], [400.0, 430.0]];
    let rgbs = [[0.002, 0.18, 1.0], [0.5, 0.5, 0.5]].map(|[r, g, b]| Rgb::<Srgb>::new(r, g, b));
    let count = |function, f, inputs: &[f32]| of_backend(clock, function, name, f, inputs);
    count("sqrt", |x, root| *root = M::sqrt(*x), &all);
    count("cbrt", |x, root| *root = M::cbrt(*x), &signed);
    count("exp", |x, power| *power = M::exp(*x), &logs);
    count("expm1", |x, power| *power = M::expm1(*x), &logs);
    count("ln", |x, ln| *ln = M::ln(*x), &all);
    count("pow24", |x, power| *power = M::powf(*x, 2.4), &signals);
    count("root24", |x, power| *power = M::powf(*x, 1.0 / 2.4), &signals);
    of_backend(clock, "atan2", name, |[x, y], angle| *angle = M::atan2(*y, *x), &points);
    count("cos", |turns, cos| *cos = M::cos_turns(*turns), &angles);
    count("sin", |turns, sin| *sin = M::sin_turns(*turns), &angles);
    of_backend(clock, "planck", name, |[nm, k], power| *power = blackbody_with::<M>(*nm, *k), &glowing);
    of_backend(clock, "lab", name, |xyz, out| *out = xyz.lab_with::<M>(WHITE), &colors);
    of_backend(
        clock,
        "srgb",
        name,
        |rgb, code| *code = rgb.encode_with::<transfer::SrgbTransfer, M>(),
        &rgbs,
    );
}

fn of_backend<A, R: Default>(clock: &Clock, function: &str, backend: &str, f: fn(&A, &mut R), inputs: &[A]) {
    println!("math-{function}-{backend} {}", clock.longest(f, inputs));
}
