//! Prints the instructions of what colors look like and of how cinema and television encode them, as lines
//! `name count`. They are counted as in `count`, for the input with the highest cost.
#![no_std]
#![no_main]

use nanospectra::color::transfer::{Bt709, DciTransfer, Hlg, Pq, ProPhotoTransfer, Transfer};
use nanospectra::color::{
    Appearance, AppearanceModel, Bt2020, Cam16, CamUcs, Ciecam02, DciP3, EncodedRgb, Ictcp, ProPhoto, Rgb,
    RgbSpace, Surround, Uv1960, ViewingConditions, Xyz,
};
use nanospectra::math::{Fast, Math, Portable};
use nanospectra_firmware::clock::Clock;
use semihosting::{println, process};

static WHITE: Xyz = Xyz { x: 95.047, y: 100.0, z: 108.883 };

/// A pale color, a dark one, a strong blue and a strong red.
const COLORS: [[f32; 3]; 4] = [[40.0, 50.0, 45.0], [0.3, 0.4, 0.2], [20.0, 10.0, 90.0], [40.0, 20.0, 0.5]];

#[nanospectra_firmware::entry]
fn main() -> ! {
    let clock = Clock::start();
    appearance::<Cam16, Portable>(
        &clock,
        ["cam16-conditions", "cam16", "cam16-xyz", "cam16-ucs", "cam16-ucs-xyz"],
    );
    appearance::<Ciecam02, Portable>(
        &clock,
        ["ciecam02-conditions", "ciecam02", "ciecam02-xyz", "ciecam02-ucs", "ciecam02-ucs-xyz"],
    );
    appearance::<Cam16, Fast>(
        &clock,
        ["cam16-conditions-fast", "cam16-fast", "cam16-xyz-fast", "cam16-ucs-fast", "cam16-ucs-xyz-fast"],
    );
    high_dynamic_range(&clock);

    let temperatures = [1000.0, 2856.0, 6504.0, 25_000.0, 1e6];
    count(&clock, "planckian", |cct_k, out| *out = Uv1960::planckian(*cct_k), &temperatures);
    let whites = temperatures.map(|cct_k| [cct_k, 0.0032]);
    count(&clock, "of-cct", |[cct_k, duv], out| *out = Uv1960::of_cct(*cct_k, *duv), &whites);

    encoding::<Bt2020, Bt709>(&clock, ["encode-bt709", "decode-bt709"]);
    encoding::<DciP3, DciTransfer>(&clock, ["encode-dci", "decode-dci"]);
    encoding::<ProPhoto, ProPhotoTransfer>(&clock, ["encode-prophoto", "decode-prophoto"]);
    process::exit(0)
}

fn count<A, R: Default>(clock: &Clock, name: &str, f: fn(&A, &mut R), inputs: &[A]) {
    println!("{name} {}", clock.longest(f, inputs));
}

/// Counts the conditions of a scene, and what is computed for each color in it, there and back.
fn appearance<A: AppearanceModel, M: Math>(clock: &Clock, names: [&str; 5]) {
    let [conditions, there, back, place, back_from_place] = names;
    let made = |la: &f32, out: &mut Option<_>| {
        *out = ViewingConditions::<A>::new_with::<M>(WHITE, *la, 20.0, Surround::Average);
    };
    count(clock, conditions, made, &[4.0, 64.0, 318.31]);
    let mut seen = None;
    made(&64.0, &mut seen);
    let Some(seen) = seen else { return };
    let with = |xyz: [f32; 3]| (seen, Xyz::from(xyz));
    let colors = COLORS.map(with);
    count(clock, there, |(seen, xyz), out| *out = seen.appearance_with::<M>(*xyz), &colors);
    count(clock, place, |(seen, xyz), out| *out = seen.ucs_with::<M>(*xyz), &colors);
    let looks: [(_, Appearance); 4] =
        colors.map(|(seen, xyz)| (seen, seen.appearance_with::<M>(xyz).unwrap_or_default()));
    count(clock, back, |(seen, looks), out| *out = seen.xyz_with::<M>(*looks), &looks);
    let places: [(_, CamUcs); 4] =
        colors.map(|(seen, xyz)| (seen, seen.ucs_with::<M>(xyz).unwrap_or_default()));
    count(clock, back_from_place, |(seen, place), out| *out = seen.xyz_of_ucs_with::<M>(*place), &places);
}

/// Counts ICtCp and Jzazbz, there and back.
fn high_dynamic_range(clock: &Clock) {
    // A white of 1, the peak of the scene, and one of 100 cd/m2.
    let scene = COLORS.map(|xyz| Rgb::<Bt2020>::from_xyz(Xyz::from(xyz)));
    let shown = scene.map(|rgb| rgb * 0.01);
    count(clock, "ictcp-pq", |rgb, out| *out = Ictcp::<Pq>::from_rgb(*rgb), &shown);
    count(clock, "ictcp-hlg", |rgb, out| *out = Ictcp::<Hlg>::from_rgb(*rgb), &scene);
    let back = |code: &Ictcp<Pq>, out: &mut Option<_>| *out = code.rgb();
    count(clock, "ictcp-pq-rgb", back, &shown.map(Ictcp::from_rgb));
    let back = |code: &Ictcp<Hlg>, out: &mut Option<_>| *out = code.rgb();
    count(clock, "ictcp-hlg-rgb", back, &scene.map(Ictcp::from_rgb));
    let colors = COLORS.map(Xyz::from);
    count(clock, "jzazbz", |xyz, out| *out = xyz.jzazbz(), &colors);
    count(clock, "jzazbz-xyz", |jzazbz, out| *out = jzazbz.xyz(), &colors.map(Xyz::jzazbz));
}

/// Counts the three components of a color by a transfer function, on both sides of its knee.
fn encoding<S: RgbSpace, T: Transfer>(clock: &Clock, [encode, decode]: [&str; 2]) {
    let colors = [[0.002, 0.18, 1.0], [0.5, 0.5, 0.5]].map(|[r, g, b]| Rgb::<S>::new(r, g, b));
    let coded = |rgb: &Rgb<S>, out: &mut [f32; 3]| *out = rgb.encode_with::<T, Portable>().to_array();
    count(clock, encode, coded, &colors);
    let codes: [EncodedRgb<S, T>; 2] = colors.map(|rgb| rgb.encode_with::<T, Portable>());
    count(clock, decode, |code, out| *out = code.decode_with::<Portable>().to_array(), &codes);
}
