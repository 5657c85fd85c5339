//! From spectra to colors, and the math below.

use super::hash::{Hash, Random};
use core::array::from_fn;
use nanospectra::color::{
    Cct, Lab, Rgb, Srgb, Uv1960, Xy, Xyz, ciede2000, cmc, cri, dominant_wavelength, tm30,
};
use nanospectra::light::{A, D65, FL11, LED_B1, blackbody, blackbody_relative, daylight_xy};
use nanospectra::math::{Fast, Math, Portable};
use nanospectra::matter::TCS;
use nanospectra::observer::{CIE_1931, CIE_1964, CIE_2015_2, Curve, FineObserver, Observer};
use nanospectra::upsample::{Basis, Sigmoid, Smits, Viewing};
use nanospectra::{Factor, Fine, Interpolation, Light, Outside, Power, Reflectance};

/// An eye that reads reflectances under FL11, one that reads lights: both folded from 1 nm while compiling.
struct Eyes<const N: usize> {
    paper: Observer<3, N>,
    light: Observer<3, N, Power>,
}

impl<const N: usize> Eyes<N> {
    const fn new(curve: Curve) -> Self {
        Eyes { paper: CIE_1931.under(&LAMPS[2]).fold(curve).with_white_y(100.0), light: CIE_1964.fold(curve) }
    }
}

/// A smooth light, a stepped one, one with lines, a mixed one; at 1 nm.
pub static LAMPS: [Fine<Power>; 4] = [
    A.fine(),
    D65.interpolate(Interpolation::Sprague),
    FL11.fine(),
    LED_B1.interpolate(Interpolation::Sprague),
];
static EYES_16: Eyes<16> = Eyes::new(Curve::Spline);
static EYES_31: Eyes<31> = Eyes::new(Curve::Parabola);
static EYES_81: Eyes<81> = Eyes::new(Curve::Step);

pub fn run(report: &mut impl FnMut(&str, u32)) {
    report("folded-16", Hash::of(|hash| folded(hash, &EYES_16)));
    report("folded-31", Hash::of(|hash| folded(hash, &EYES_31)));
    report("folded-81", Hash::of(|hash| folded(hash, &EYES_81)));
    report("fine-471", Hash::of(|hash| fine(hash, &[&CIE_1931, &CIE_1964, &CIE_2015_2])));
    report("samples", Hash::of(samples));
    report("chromaticity", Hash::of(chromaticity));
    report("cct-duv", Hash::of(cct_duv));
    report("dominant", Hash::of(dominant));
    report("lab", Hash::of(lab));
    report("spaces", Hash::of(spaces));
    report("differences", Hash::of(differences));
    report("cri", Hash::of(rendering_index));
    report("lights", Hash::of(lights));
    report("roots", Hash::of(roots));
    report("fast", Hash::of(fast));
    report("exp-ln-pow", Hash::of(exp_ln_pow));
    report("angles", Hash::of(angles));
    report("upsample", Hash::of(upsampled));
}

/// RGB to spectrum: what the compiler made, then random colors one by one and eight at a time, a few of them
/// out of reach.
fn upsampled(hash: &mut Hash) {
    static VIEWING: Viewing<31> = Viewing::new(&CIE_1931.under(&LAMPS[1]).fold(Curve::Step));
    static SIGMOID: Sigmoid<31> = Sigmoid::new(&VIEWING);
    static BASIS: Basis<31> = Basis::new(&VIEWING);
    static SMITS: Smits<31> = Smits::new();
    let mut random = Random(0x5eed_0808);
    for _ in 0..8 {
        let colors: [Rgb<Srgb>; 8] = from_fn(|_| {
            let [r, g, b] = random.bins();
            Rgb::new(1.1 * r - 0.05, 1.1 * g - 0.05, 1.1 * b - 0.05)
        });
        for (rgb, solved) in colors.iter().zip(SIGMOID.reflectance_8(&colors)) {
            hash.all(&solved.spectrum.to_texel());
            hash.all(&SIGMOID.reflectance(*rgb).spectrum.to_texel());
            let spectrum: Reflectance<31> = solved.spectrum.on_grid();
            hash.all(spectrum.values());
            hash.all(BASIS.reflectance(*rgb).values());
            hash.all(SMITS.reflectance(*rgb).values());
            hash.all(&VIEWING.rgb(&spectrum).to_array());
        }
    }
}

/// The weights, and what they see: 64 random spectra one by one and as a batch, surfaces and lamps.
fn folded<const N: usize>(hash: &mut Hash, eyes: &Eyes<N>) {
    eyes.paper.weights().iter().for_each(|row| hash.all(row));
    eyes.light.weights().iter().for_each(|row| hash.all(row));
    let mut random = Random(0x5eed_0000 + N as u32);
    for _ in 0..16 {
        let papers: [Reflectance<N>; 4] = from_fn(|_| Reflectance::from_bins(random.bins()));
        let mut batch = [[0.0; 3]; 4];
        eyes.paper.sees_each(&papers, &mut batch);
        for (paper, xyz) in papers.iter().zip(&batch) {
            hash.all(xyz);
            hash.all(&eyes.paper.sees(paper));
        }
    }
    for surface in &TCS {
        let paper: Reflectance<N> = surface.resample();
        hash.all(paper.values());
        hash.all(&eyes.paper.sees(&paper));
    }
    for lamp in &LAMPS {
        let light: Light<N> = lamp.resample();
        hash.all(light.values());
        hash.all(&eyes.light.sees(&light));
        hash.one(light.power());
    }
}

/// 1 nm sums: lamps, lamps on surfaces, random lights.
fn fine(hash: &mut Hash, eyes: &[&FineObserver<3>]) {
    let mut random = Random(0x5eed_0471);
    for eye in eyes {
        for lamp in &LAMPS {
            hash.all(&eye.sees(lamp));
            for surface in &TCS {
                hash.all(&eye.sees(&(*lamp * *surface)));
            }
        }
        for _ in 0..8 {
            hash.all(&eye.sees(&Fine::from_bins(random.bins())));
        }
    }
}

/// Irregular measured samples onto bins and nodes, and a laser line.
fn samples(hash: &mut Hash) {
    let mut random = Random(0x5eed_5a3e);
    for _ in 0..4 {
        let mut nm = 371.5;
        let knots: [(f32, f32); 90] = from_fn(|_| {
            nm += 0.25 + 8.0 * random.unit();
            (nm, random.unit())
        });
        for outside in [Outside::Zero, Outside::Hold] {
            if let Ok(mut light) = Light::<31>::from_samples_outside(&knots, outside) {
                hash.one(light.add_line(400.0 + 300.0 * random.unit(), 2.5));
                hash.all(light.values());
            }
            if let Ok(fine) = Fine::<Factor>::interpolated_outside(&knots, Interpolation::Linear, outside) {
                hash.all(fine.values());
            }
        }
        let regular: [(f32, f32); 36] = from_fn(|k| (380.0 + 10.0 * k as f32, random.unit()));
        if let Ok(fine) = Fine::<Power>::interpolated(&regular, Interpolation::Sprague) {
            hash.all(fine.values());
        }
    }
}

/// xy, uv and u'v' of random colors, some of them black or imaginary.
fn chromaticity(hash: &mut Hash) {
    let mut random = Random(0x5eed_c0de);
    for _ in 0..256 {
        let [x, y, z]: [f32; 3] = from_fn(|_| 110.0 * random.unit() - 10.0);
        let xyz = Xyz { x, y, z };
        hash.maybe(xyz.xy().map(|p| [p.x, p.y]));
        hash.maybe(xyz.uv1960().map(|p| [p.u, p.v]));
        hash.maybe(xyz.uv1976().map(|p| [p.u, p.v]));
    }
}

/// A grid of points on both sides of the locus, from beyond its cold end to beyond its hot one.
fn cct_duv(hash: &mut Hash) {
    for i in 0..32 {
        for k in 0..16 {
            let point = Uv1960 { u: 0.17 + 0.008 * i as f32, v: 0.26 + 0.007 * k as f32 };
            match point.cct() {
                Cct::Near { cct_k, duv } => hash.all(&[cct_k, duv]),
                Cct::TooCold => hash.word(1),
                Cct::TooHot => hash.word(2),
                _ => hash.word(3),
            }
        }
    }
}

/// All the way round the white, from pale to beyond the spectrum.
fn dominant(hash: &mut Hash) {
    for k in 0..48 {
        let (angle, radius) = (k as f32 / 48.0, 0.002 * (k * k % 97) as f32);
        let (x, y) =
            (WHITE.x + radius * Portable::cos_turns(angle), WHITE.y + radius * Portable::sin_turns(angle));
        hash.maybe(dominant_wavelength(Xy { x, y }, WHITE, &CIE_1931).map(|d| [d.nm, d.purity]));
    }
}

/// The white of D65.
pub const WHITE: Xy = Xy { x: 0.3127, y: 0.3290 };

/// A lattice of colors that reaches below black and above white, and crosses the knee of the cube root.
pub fn lattice() -> impl Iterator<Item = Xyz> {
    let step = |n: u32| 0.3 * (n * n * n) as f32 - 0.2;
    (0..512).map(move |n| Xyz { x: step(n / 64), y: step(n / 8 % 8), z: step(n % 8) })
}

fn lattice_lab() -> impl Iterator<Item = Lab> {
    let white = WHITE.xyz(100.0).unwrap_or_default();
    lattice().filter_map(move |xyz| xyz.lab(white))
}

/// Lab there and back, and Lch.
fn lab(hash: &mut Hash) {
    let white = WHITE.xyz(100.0).unwrap_or_default();
    for lab in lattice_lab() {
        let lch = lab.lch();
        hash.all(&[lab.l, lab.a, lab.b, lch.c, lch.h_deg]);
        hash.all(&lab.xyz(white).to_array());
    }
}

/// Luv, Oklab and sRGB.
fn spaces(hash: &mut Hash) {
    let white = WHITE.xyz(100.0).unwrap_or_default();
    for xyz in lattice() {
        if let Some(luv) = xyz.luv(white) {
            hash.all(&[luv.l, luv.u, luv.v]);
        }
        let oklab = xyz.oklab();
        hash.all(&[oklab.l, oklab.a, oklab.b]);
        hash.all(&Rgb::<Srgb>::from_xyz(xyz).encode().to_array());
    }
}

/// From each color of the lattice to the one 37 further on.
fn differences(hash: &mut Hash) {
    for (one, other) in lattice_lab().zip(lattice_lab().skip(37)) {
        hash.all(&[ciede2000(one, other), cmc(one, other, 2.0, 1.0)]);
    }
}

/// Color rendering indices of the lamps.
fn rendering_index(hash: &mut Hash) {
    for lamp in &LAMPS {
        match cri(lamp) {
            Ok(index) => {
                hash.all(&[index.ra, index.cct_k, index.duv, index.dc]);
                hash.all(&index.r);
            }
            Err(_) => hash.word(0),
        }
    }
}

/// TM-30 of the lamps.
pub fn fidelity(hash: &mut Hash) {
    for lamp in &LAMPS {
        match tm30(lamp) {
            Ok(result) => {
                hash.all(&[result.rf, result.rg, result.cct_k, result.duv]);
                hash.all(&result.rf_ces);
                for bin in result.bins.iter().flatten() {
                    hash.all(&[bin.rf, bin.chroma_shift, bin.hue_shift]);
                }
            }
            Err(_) => hash.word(0),
        }
    }
}

/// Black bodies over five decades of temperature, daylight from 4000 K to 25 000 K and beyond both ends.
fn lights(hash: &mut Hash) {
    let mut kelvin = 100.0;
    while kelvin < 1e7 {
        for nm in [200.0, 360.0, 555.0, 830.0, 2500.0] {
            hash.all(&[blackbody(nm, kelvin), blackbody_relative(nm, kelvin)]);
        }
        hash.maybe(daylight_xy(kelvin).map(|p| [p.x, p.y]));
        kelvin *= 1.25;
    }
}

/// Square and cube roots of every kind of float: subnormal, negative, infinite, not a number.
fn roots(hash: &mut Hash) {
    for x in (0..=u32::MAX).step_by(0x003f_1357).map(f32::from_bits) {
        hash.all(&[Portable::sqrt(x), Portable::cbrt(x)]);
    }
}

/// The functions of `Fast`, over what each is for.
fn fast(hash: &mut Hash) {
    for x in (0x0080_0000..0x7f80_0000_u32).step_by(0x003f_1357).map(f32::from_bits) {
        hash.all(&[Fast::sqrt(x), Fast::cbrt(x), Fast::ln(x), Fast::powf(x, 2.4), Fast::powf(x, 1.0 / 2.4)]);
    }
    for k in 0..512 {
        let x = 0.4125 * k as f32 - 105.0;
        hash.all(&[Fast::exp(x), Fast::expm1(x), Fast::cos_turns(0.01 * x), Fast::sin_turns(0.01 * x)]);
        hash.one(Fast::atan2(x, 31.0));
    }
}

/// From underflow to overflow.
fn exp_ln_pow(hash: &mut Hash) {
    for k in 0..512 {
        let x = 0.4125 * k as f32 - 105.0;
        hash.all(&[Portable::exp(x), Portable::expm1(x)]);
    }
    for x in (0..=0x7f80_0000_u32).step_by(0x003f_1357).map(f32::from_bits) {
        hash.one(Portable::ln(x));
        hash.all(&[2.4, 1.0 / 2.4, 5.0, -3.0].map(|y| Portable::powf(x, y)));
    }
}

/// All the way round and beyond, on circles of four sizes.
fn angles(hash: &mut Hash) {
    for k in 0..256 {
        let turns = 0.0117 * k as f32 - 1.5;
        let (cos, sin) = (Portable::cos_turns(turns), Portable::sin_turns(turns));
        hash.all(&[cos, sin]);
        hash.all(&[1e-30, 0.01, 1.0, 1e20].map(|r| Portable::atan2(r * sin, r * cos)));
    }
}
