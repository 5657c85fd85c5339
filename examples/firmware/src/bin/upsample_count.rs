//! Prints the instructions that it takes to find a reflectance of 31 bands for an RGB color: the mean and the
//! most over 729 colors of the sRGB cube, for each start map. It also prints the instructions for reading 31
//! bands of the result, and those of the linear methods, which give the 31 bands at once.
#![no_std]
#![no_main]

use nanospectra::color::{Rgb, Srgb};
use nanospectra::light::D65;
use nanospectra::observer::CIE_1931;
use nanospectra::upsample::{
    Basis, CubicStart, LinearStart, QuinticStart, Sigmoid, SigmoidReflectance, Smits, Solved, StartMap,
    Status, Viewing,
};
use nanospectra::{Curve, Nodes, Reflectance};
use nanospectra_firmware::clock::Clock;
use semihosting::{println, process};

type Grid = Nodes<400, 700>;
type Answer = Solved<SigmoidReflectance>;

static EYE: Viewing<31, Grid> = Viewing::new(&CIE_1931.under(&D65.fine()).fold(Curve::Step));
static LINEAR: Sigmoid<31, Grid, Srgb, LinearStart> = Sigmoid::new(&EYE);
static CUBIC: Sigmoid<31, Grid, Srgb, CubicStart> = Sigmoid::new(&EYE);
static QUINTIC: Sigmoid<31, Grid, Srgb, QuinticStart> = Sigmoid::new(&EYE);
static BASIS: Basis<31, Grid> = Basis::new(&EYE);
static SMITS: Smits<31, Grid> = Smits::new();

#[nanospectra_firmware::entry]
fn main() -> ! {
    let clock = Clock::start();
    count(&clock, "linear", by_linear);
    count(&clock, "cubic", by_cubic);
    count(&clock, "quintic", by_quintic);
    let curve = SigmoidReflectance::from_texel([3.0, -4.0, 0.5, 0.75]);
    println!("upsample-read-31 {}", clock.count(read, &curve, &mut Reflectance::flat(0.0)));
    let orange = Rgb::new(0.8, 0.2, 0.1);
    println!("upsample-basis-31 {}", clock.count(by_basis, &orange, &mut Reflectance::flat(0.0)));
    println!("upsample-smits-31 {}", clock.count(by_smits, &orange, &mut Reflectance::flat(0.0)));
    process::exit(0)
}

fn count(clock: &Clock, map: &str, f: fn(&Rgb<Srgb>, &mut Answer)) {
    let (mut sum, mut most, mut colors) = (0, 0, 0);
    // About the linear light of encoded steps of an eighth.
    let levels = [0.0, 0.0144, 0.0508, 0.1163, 0.2140, 0.3467, 0.5225, 0.7379, 1.0];
    for r in levels {
        for g in levels {
            for b in levels {
                let mut answer = Solved { spectrum: SigmoidReflectance::gray(0.0), status: Status::Exact };
                let steps = clock.count(f, &Rgb::new(r, g, b), &mut answer);
                if answer.status != Status::Exact {
                    println!("{map}: a color of sRGB was not solved");
                    process::exit(1)
                }
                (sum, most, colors) = (sum + steps, steps.max(most), colors + 1);
            }
        }
    }
    println!("upsample-{map}-31 {}", sum / colors);
    println!("upsample-{map}-31-most {most}");
}

fn solve<M: StartMap>(sigmoid: &Sigmoid<31, Grid, Srgb, M>, rgb: &Rgb<Srgb>, answer: &mut Answer) {
    *answer = sigmoid.reflectance(*rgb);
}

#[inline(never)]
fn by_linear(rgb: &Rgb<Srgb>, answer: &mut Answer) {
    solve(&LINEAR, rgb, answer);
}

#[inline(never)]
fn by_cubic(rgb: &Rgb<Srgb>, answer: &mut Answer) {
    solve(&CUBIC, rgb, answer);
}

#[inline(never)]
fn by_quintic(rgb: &Rgb<Srgb>, answer: &mut Answer) {
    solve(&QUINTIC, rgb, answer);
}

#[inline(never)]
fn read(curve: &SigmoidReflectance, bins: &mut Reflectance<31, Grid>) {
    *bins = curve.on_grid();
}

#[inline(never)]
fn by_basis(rgb: &Rgb<Srgb>, bins: &mut Reflectance<31, Grid>) {
    *bins = BASIS.reflectance(*rgb);
}

#[inline(never)]
fn by_smits(rgb: &Rgb<Srgb>, bins: &mut Reflectance<31, Grid>) {
    *bins = SMITS.reflectance(*rgb);
}
