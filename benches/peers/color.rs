//! What follows from XYZ. The crate `colorimetry` is the peer for color temperature and color rendering, and
//! `palette` in f32 for CIELAB, CIEDE2000 and sRGB.

use crate::race::{Races, each};
use colorimetry::illuminant::Illuminant;
use colorimetry::observer::Observer as StdObserver;
use colorimetry::spectrum::Spectrum as StdSpectrum;
use colorimetry::xyz::XYZ;
use model::noise::Noise;
use model::{cct, cri, delta_e, lab, transfer};
use nanospectra::color::{Cct, Lab, Rgb, Srgb, Xyz, ciede2000, cri as rendering, tm30};
use nanospectra::{Fine, Power, light};
use palette::LinSrgb;
use palette::color_difference::Ciede2000;
use palette::convert::FromColorUnclamped;
use palette::white_point::D65;
use std::hint::black_box;

type TheirLab = palette::Lab<D65, f32>;
type TheirXyz = palette::Xyz<D65, f32>;

pub fn all(races: &mut Races) {
    temperature(races);
    color_rendering(races);
    lab_of_xyz(races);
    difference(races);
    srgb(races);
}

/// The color temperature of 64 colors near white, from 1700 to 20000 K.
fn temperature(races: &mut Races) {
    let mut noise = Noise(1);
    let points: Vec<[f64; 2]> = (0..64)
        .map(|_| cct::uv_at(1e6 / (50.0 + 530.0 * noise.uniform()), 0.04 * noise.uniform() - 0.02))
        .collect();
    // u = 4 X / (X + 15 Y + 3 Z), v = 6 Y / (..), with Y = 1.
    let xyz = |[u, v]: &[f64; 2]| [1.5 * u / v, 1.0, (4.0 - u - 10.0 * v) / (2.0 * v)];
    let ours: Vec<Xyz> = points.iter().map(|p| xyz(p).map(|v| v as f32).into()).collect();
    let theirs: Vec<XYZ> = points.iter().map(|p| XYZ::new(xyz(p), StdObserver::Cie1931)).collect();
    let (mut worst, mut their_worst) = (0.0f64, 0.0f64);
    for ((point, ours), theirs) in points.iter().zip(&ours).zip(&theirs) {
        let mired = 1e6 / cct::cct(*point).cct_k;
        let (found, _) = ours.cct().and_then(Cct::near).expect("a white");
        worst = worst.max((1e6 / f64::from(found) - mired).abs());
        their_worst = their_worst.max((1e6 / theirs.cct().expect("a white").t() - mired).abs());
    }
    assert!(worst < 0.015, "{worst} mired");
    races.run(
        "XYZ to CCT, Duv (errors in mired)",
        10.0,
        1.0,
        each(&ours, |xyz| xyz.cct()),
        ("colorimetry, f64", each(&theirs, |xyz| xyz.cct())),
    );
    races.errors(worst, their_worst);
}

/// The color rendering of one fluorescent lamp.
fn color_rendering(races: &mut Races) {
    let lamp: Fine<Power> = light::FL2_1NM.fine();
    let std_lamp = Illuminant::new(StdSpectrum::from(light::FL2_1NM.values().map(f64::from)));
    let truth = cri::Method::new(cri::Mode::OneNm).of_values(&lamp.values().map(f64::from)).ra;
    let (ours, theirs) = (rendering(&lamp).expect("white").ra, std_lamp.cri().expect("white").ra());
    assert!((f64::from(ours) - truth).abs() < 1e-3, "{ours} {truth}");
    races.run(
        "CRI of FL2",
        10.0,
        1.0,
        || rendering(black_box(&lamp)),
        ("colorimetry, f64", || black_box(&std_lamp).cri()),
    );
    races.errors((f64::from(ours) - truth).abs(), (theirs - truth).abs());

    let rf = tm30(&lamp).expect("white").rf;
    assert!((rf - 70.1).abs() < 0.3, "{rf}");
    races.run(
        "TM-30 of FL2",
        None,
        1.0,
        || tm30(black_box(&lamp)),
        ("colorimetry, f64", || black_box(&std_lamp).cfi()),
    );
}

/// CIELAB of 1024 colors below the white.
fn lab_of_xyz(races: &mut Races) {
    // The white point that `palette` uses.
    let white: [f32; 3] = [0.950_47, 1.0, 1.088_83];
    let mut noise = Noise(1);
    let colors: Vec<[f32; 3]> = (0..1024).map(|_| white.map(|w| w * noise.uniform() as f32)).collect();
    let theirs: Vec<TheirXyz> = colors.iter().map(|[x, y, z]| TheirXyz::new(*x, *y, *z)).collect();
    let ours: Vec<Xyz> = colors.iter().map(|c| Xyz::from(*c)).collect();
    let mut worst = [0.0f64; 2];
    for ((color, ours), theirs) in colors.iter().zip(&ours).zip(&theirs) {
        let truth = lab::lab(color.map(f64::from), white.map(f64::from));
        let (a, b) = (ours.lab(white.into()).expect("a white"), TheirLab::from_color_unclamped(*theirs));
        for (worst, found) in worst.iter_mut().zip([[a.l, a.a, a.b], [b.l, b.a, b.b]]) {
            for (found, truth) in found.iter().zip(truth) {
                *worst = worst.max((f64::from(*found) - truth).abs());
            }
        }
    }
    assert!(worst[0] < 5e-4, "{worst:?}");
    races.run(
        "XYZ to Lab",
        None,
        1.0,
        each(&ours, |xyz| xyz.lab(white.into())),
        ("palette, f32", each(&theirs, |xyz| TheirLab::from_color_unclamped(*xyz))),
    );
    races.errors(worst[0], worst[1]);
}

/// CIEDE2000 of pairs of unlike colors, and of as many pairs that nearly match.
fn difference(races: &mut Races) {
    let mut noise = Noise(1);
    let mut pairs = Vec::new();
    for k in 0..1024 {
        let mut color =
            || [100.0 * noise.uniform(), 200.0 * noise.uniform() - 100.0, 200.0 * noise.uniform() - 100.0];
        let (one, far) = (color(), color());
        let near = [0, 1, 2].map(|i| one[i] + 0.01 * (far[i] - one[i]));
        pairs.push([one, if k % 2 == 0 { far } else { near }].map(|lab| lab.map(|v| v as f32)));
    }
    let ours: Vec<[Lab; 2]> = pairs.iter().map(|p| p.map(|[l, a, b]| Lab::new(l, a, b))).collect();
    let theirs: Vec<[TheirLab; 2]> =
        pairs.iter().map(|p| p.map(|[l, a, b]| TheirLab::new(l, a, b))).collect();
    let mut worst = [0.0f64; 2];
    for ((pair, [a, b]), [c, d]) in pairs.iter().zip(&ours).zip(&theirs) {
        let [one, two] = pair.map(|lab| lab.map(f64::from));
        let truth = delta_e::de2000(one, two);
        for (worst, found) in worst.iter_mut().zip([ciede2000(*a, *b), Ciede2000::difference(*c, *d)]) {
            *worst = worst.max((f64::from(found) / truth - 1.0).abs());
        }
    }
    assert!(worst[0] < 1e-6 && worst[0] <= worst[1], "{worst:?}");
    races.run(
        "CIEDE2000 (relative errors)",
        1.0,
        1.0,
        each(&ours, |[a, b]| ciede2000(*a, *b)),
        ("palette, f32", each(&theirs, |[a, b]| Ciede2000::difference(*a, *b))),
    );
    races.errors(worst[0], worst[1]);
}

/// The sRGB encoding of 1024 colors.
fn srgb(races: &mut Races) {
    let mut noise = Noise(1);
    let colors: Vec<[f32; 3]> = (0..1024).map(|_| [(); 3].map(|()| noise.uniform() as f32)).collect();
    let ours: Vec<Rgb<Srgb>> = colors.iter().map(|[r, g, b]| Rgb::new(*r, *g, *b)).collect();
    let theirs: Vec<LinSrgb<f32>> = colors.iter().map(|[r, g, b]| LinSrgb::new(*r, *g, *b)).collect();
    let encode = |rgb: &LinSrgb<f32>| palette::Srgb::<f32>::from_linear(*rgb);
    let mut worst = [0.0f64; 2];
    for ((color, ours), theirs) in colors.iter().zip(&ours).zip(&theirs) {
        let b = encode(theirs);
        for (worst, found) in worst.iter_mut().zip([ours.encode().to_array(), [b.red, b.green, b.blue]]) {
            for (found, linear) in found.iter().zip(color) {
                *worst = worst.max((f64::from(*found) - transfer::srgb_encode(f64::from(*linear))).abs());
            }
        }
    }
    assert!(worst[0] < 1e-6, "{worst:?}");
    races.run(
        "linear RGB to sRGB",
        None,
        1.0,
        each(&ours, |rgb| rgb.encode()),
        ("palette, f32", each(&theirs, encode)),
    );
    races.errors(worst[0], worst[1]);
}
