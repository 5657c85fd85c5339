//! Prints the instructions of public calls as lines `name count`. In QEMU they are exact and repeatable.
//!
//! Inputs come from memory and results go to memory, so the counts include loads and stores, but not the call
//! itself (see [`Clock::count`]). Where the count depends on the data, the highest of several inputs is
//! printed.
#![no_std]
#![no_main]

use nanospectra::color::{Lab, Xy, Xyz, ciede2000};
use nanospectra::light::{D65, FL11};
use nanospectra::observer::{CIE_1931, Curve, Observer};
use nanospectra::{Fine, Power, Reflectance, math};
use nanospectra_firmware::clock::Clock;
use semihosting::{println, process};

static FL11_FINE: Fine<Power> = FL11.fine();
static WHITE: Xyz = Xyz { x: 95.047, y: 100.0, z: 108.883 };

#[nanospectra_firmware::entry]
fn main() -> ! {
    let clock = Clock::start();

    macro_rules! each {
        ($($n:literal)*) => { $(folded::<$n>(&clock);)* };
    }
    each!(3 8 12 16 20 24 31 36 40 60 81 95);
    count(&clock, "xyz-471", |light, xyz| *xyz = CIE_1931.sees(light), &[D65.fine()]);

    // A pale color, a dark one, a strong blue and a strong red, on both sides of the knee of Lab.
    let colors = [[40.0, 50.0, 45.0], [0.3, 0.4, 0.2], [20.0, 10.0, 90.0], [40.0, 20.0, 0.5]].map(Xyz::from);
    count(&clock, "xy", |xyz, out| *out = xyz.xy(), &colors);
    count(&clock, "uv1976", |xyz, out| *out = xyz.uv1976(), &colors);
    count(&clock, "lab", |xyz, out| *out = xyz.lab(WHITE), &colors);

    // Two blues (Sharma's first pair), opposite hues (his tenth), two greens, and a gray beside a color.
    let pairs = [
        [[50.0, 2.6772, -79.7751], [50.0, 0.0, -82.7485]],
        [[50.0, -0.001, 2.49], [50.0, 0.0011, -2.49]],
        [[60.2574, -34.0099, 36.2677], [60.4626, -34.1751, 39.4387]],
        [[50.0, 0.0, 0.0], [50.0, -1.0, 2.0]],
    ]
    .map(|pair| pair.map(|[l, a, b]| Lab { l, a, b }));
    count(&clock, "ciede2000", |[x, y], out| *out = ciede2000(*x, *y), &pairs);

    // A candle, an incandescent and a fluorescent lamp, daylight, an overcast sky, a clear sky, and points on
    // the green and on the pink side of the locus.
    let lights = [
        [0.5268, 0.4133],
        [0.4476, 0.4074],
        [0.3805, 0.3769],
        [0.3127, 0.3290],
        [0.2807, 0.2884],
        [0.2525, 0.2522],
        [0.3600, 0.4000],
        [0.3800, 0.3300],
    ]
    .map(|[x, y]| Xy { x, y });
    count(&clock, "cct-duv", |xy, out| *out = Some(xy.uv1960().cct()), &lights);

    count(&clock, "sqrt", |x, root| *root = math::sqrt(*x), &[2.0, 1e-40, 1e30]);
    count(&clock, "cbrt", |x, root| *root = math::cbrt(*x), &[2.0, 1e-40, -1e30]);
    process::exit(0)
}

fn count<A, R: Default>(clock: &Clock, name: &str, f: fn(&A, &mut R), inputs: &[A]) {
    println!("{name} {}", clock.longest(f, inputs));
}

/// Counts the way from a surface of N bands to XYZ, with the lamp folded into the observer.
fn folded<const N: usize>(clock: &Clock) {
    println!("xyz-{N} {}", clock.count(xyz::<N>, &Reflectance::flat(0.5), &mut [0.0; 3]));
}

#[inline(never)]
fn xyz<const N: usize>(paper: &Reflectance<N>, xyz: &mut [f32; 3]) {
    let eye: &Observer<3, N> = const { &CIE_1931.under(&FL11_FINE).fold(Curve::Spline).with_white_y(100.0) };
    *xyz = eye.sees(paper);
}
