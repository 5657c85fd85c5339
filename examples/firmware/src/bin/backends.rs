//! Prints the instructions that each function of each maths backend takes, and what is made of one, one
//! `maths-function-backend count` per line.
//!
//! An image of its own beside `count`: `Libm` runs in soft f64, and that one must have none. Counted as there.
#![no_std]
#![no_main]

use nanospectra::color::{EncodedRgb, Lab, Rgb, Srgb, Xyz, transfer};
use nanospectra::light::blackbody_with;
use nanospectra::math::{Fast, Libm, Math, Micromath, Portable};
use nanospectra::matter::{Components, Dielectric, Glass, N_BK7};
use nanospectra_firmware::clock::Clock;
use semihosting::{println, process};

static WHITE: Xyz = Xyz { x: 95.047, y: 100.0, z: 108.883 };

#[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
#[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
fn main() -> ! {
    let clock = Clock::start();
    backend::<Portable>(&clock, "portable");
    backend::<Fast>(&clock, "fast");
    backend::<Libm>(&clock, "libm");
    backend::<Micromath>(&clock, "micromath");
    // These take a square root, which is the core's own or one in integers, and no backend.
    println!("maths-fresnel {}", longest(&clock, fresnel, &[1.0, 0.5, 0.1]));
    println!("maths-sellmeier {}", longest(&clock, sellmeier, &[400.0, 589.3, 700.0]));
    process::exit(0)
}

/// Everyday numbers: large and small, of both signs where the function has both.
fn backend<M: Math>(clock: &Clock, name: &str) {
    let all = [2.0, 1e-30, 1e30, 0.18, 1.0];
    let signed = [2.0, -1e-30, 1e30, 0.18, -20.0];
    let signals = [0.0031, 0.18, 0.5, 1.0, 100.0];
    let angles = [0.1, -0.3, 0.6, 0.9, 12.4];
    let logs = [0.4, -0.7, 5.0, -20.0, 80.0];
    let points = [[1.0, 2.0], [-2.0, 1.0], [3.0, -1.0], [-1.0, -4.0], [0.0, 1.0]];
    let colors = [[40.0, 50.0, 45.0], [0.3, 0.4, 0.2], [20.0, 10.0, 90.0], [40.0, 20.0, 0.5]].map(Xyz::from);
    // Nm and K: the blue and the red of a lamp, and where e^x nearly overflows.
    let glowing = [[450.0, 2856.0], [700.0, 6500.0], [400.0, 430.0]];
    let rgbs = [[0.002, 0.18, 1.0], [0.5, 0.5, 0.5]].map(|[r, g, b]| Rgb::new(r, g, b));
    let count = |function, f, inputs: &[f32]| of_backend(clock, function, name, f, inputs);
    count("sqrt", sqrt::<M>, &all);
    count("cbrt", cbrt::<M>, &signed);
    count("exp", exp::<M>, &logs);
    count("expm1", expm1::<M>, &logs);
    count("ln", ln::<M>, &all);
    count("pow24", pow24::<M>, &signals);
    count("root24", root24::<M>, &signals);
    of_backend(clock, "atan2", name, atan2::<M>, &points);
    count("cos", cos::<M>, &angles);
    count("sin", sin::<M>, &angles);
    of_backend(clock, "planck", name, planck::<M>, &glowing);
    of_backend(clock, "lab", name, lab::<M>, &colors);
    of_backend(clock, "srgb", name, srgb::<M>, &rgbs);
}

fn of_backend<A, R: Default>(clock: &Clock, function: &str, backend: &str, f: fn(&A, &mut R), inputs: &[A]) {
    println!("maths-{function}-{backend} {}", longest(clock, f, inputs));
}

fn longest<A, R: Default>(clock: &Clock, f: fn(&A, &mut R), inputs: &[A]) -> u32 {
    inputs.iter().map(|input| clock.count(f, input, &mut R::default())).max().unwrap_or(0)
}

#[inline(never)]
fn sqrt<M: Math>(x: &f32, root: &mut f32) {
    *root = M::sqrt(*x);
}

#[inline(never)]
fn cbrt<M: Math>(x: &f32, root: &mut f32) {
    *root = M::cbrt(*x);
}

#[inline(never)]
fn exp<M: Math>(x: &f32, power: &mut f32) {
    *power = M::exp(*x);
}

#[inline(never)]
fn expm1<M: Math>(x: &f32, power: &mut f32) {
    *power = M::expm1(*x);
}

#[inline(never)]
fn ln<M: Math>(x: &f32, ln: &mut f32) {
    *ln = M::ln(*x);
}

#[inline(never)]
fn pow24<M: Math>(x: &f32, power: &mut f32) {
    *power = M::powf(*x, 2.4);
}

#[inline(never)]
fn root24<M: Math>(x: &f32, power: &mut f32) {
    *power = M::powf(*x, 1.0 / 2.4);
}

#[inline(never)]
fn atan2<M: Math>([x, y]: &[f32; 2], angle: &mut f32) {
    *angle = M::atan2(*y, *x);
}

#[inline(never)]
fn cos<M: Math>(turns: &f32, cos: &mut f32) {
    *cos = M::cos_turns(*turns);
}

#[inline(never)]
fn sin<M: Math>(turns: &f32, sin: &mut f32) {
    *sin = M::sin_turns(*turns);
}

#[inline(never)]
fn lab<M: Math>(xyz: &Xyz, out: &mut Option<Lab>) {
    *out = xyz.lab_with::<M>(WHITE);
}

#[inline(never)]
fn planck<M: Math>([nm, kelvin]: &[f32; 2], radiance: &mut f32) {
    *radiance = blackbody_with::<M>(*nm, *kelvin);
}

#[inline(never)]
fn srgb<M: Math>(rgb: &Rgb<Srgb>, code: &mut EncodedRgb<Srgb>) {
    *code = rgb.encode_with::<transfer::Srgb, M>();
}

#[inline(never)]
fn fresnel(cos_i: &f32, reflected: &mut Option<Components>) {
    *reflected = Some(Dielectric::new(1.5).fresnel(*cos_i));
}

#[inline(never)]
fn sellmeier(nm: &f32, index: &mut Option<f32>) {
    *index = N_BK7.index(*nm);
}
