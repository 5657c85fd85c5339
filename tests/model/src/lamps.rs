//! Lamps that stand in no table: mixtures as physics makes them, of ten kinds, from numbers between 0 and 1.
//!
//! A seed draws them, so that checks can ask for lamps that nothing was tuned to; and a search can move the
//! numbers to where an error is largest.

use super::cct::cct;
use super::chromaticity::uv1960;
use super::daylight;
use super::interpolation::{Interpolation, Outside};
use super::noise::Noise;
use super::planck::{C2_CIE, relative};
use super::tables::Observer;
use super::tristimulus::dot;

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    BlackBody,
    Daylight,
    /// An incandescent lamp behind glass that absorbs a band.
    FilteredTungsten,
    /// A blue diode with one or two phosphors.
    WhiteLed,
    /// A violet diode with three phosphors.
    VioletLed,
    /// Mercury and three narrow phosphors.
    Triphosphor,
    /// Mercury and a broad phosphor.
    Halophosphate,
    /// Three or four narrow diodes.
    NarrowDiodes,
    /// Laser lines with a phosphor.
    LasersAndPhosphor,
    /// Three or four lines of a single nanometer.
    Lines,
}

pub const KINDS: [Kind; 10] = [
    Kind::BlackBody,
    Kind::Daylight,
    Kind::FilteredTungsten,
    Kind::WhiteLed,
    Kind::VioletLed,
    Kind::Triphosphor,
    Kind::Halophosphate,
    Kind::NarrowDiodes,
    Kind::LasersAndPhosphor,
    Kind::Lines,
];

/// What a lamp is made of: each kind takes from these what it needs, all between 0 and 1.
pub type Numbers = [f64; 14];

/// Power at 360, 361, ..., 830 nm.
pub type Power = Vec<f64>;

#[derive(Clone, Debug)]
pub struct Lamp {
    pub kind: Kind,
    pub numbers: Numbers,
}

impl Lamp {
    /// Draws a lamp of this kind whose distance from the Planckian locus is within `duv`.
    pub fn drawn(kind: Kind, duv: f64, noise: &mut Noise) -> Lamp {
        for _ in 0..10_000 {
            let lamp = Lamp { kind, numbers: std::array::from_fn(|_| noise.uniform()) };
            if is_white(&lamp.power(), duv) {
                return lamp;
            }
        }
        panic!("no white among ten thousand lamps of {kind:?}")
    }

    /// The power at every nanometer, of which the largest is 1.
    pub fn power(&self) -> Power {
        let mut power = self.kind.power(&self.numbers);
        let largest = power.iter().copied().fold(0.0, f64::max);
        power.iter_mut().for_each(|value| *value /= largest);
        power
    }
}

/// Whether a light has a color temperature from 1000 K to a million, and is so near to the locus.
pub fn is_white(power: &[f64], duv: f64) -> bool {
    use std::sync::OnceLock;
    static CMF: OnceLock<[Vec<f64>; 3]> = OnceLock::new();
    let cmf = CMF.get_or_init(|| Observer::Cie1931.on_cie_grid());
    let uv = uv1960([0, 1, 2].map(|c| dot(power, &cmf[c])));
    let [u, v] = uv;
    // Far from all whites the search for the nearest is not worth its time.
    if !(0.15..0.6).contains(&u) || !(0.2..0.45).contains(&v) {
        return false;
    }
    let found = cct(uv);
    (1010.0..900_000.0).contains(&found.cct_k) && found.duv.abs() < duv
}

fn between(share: f64, low: f64, high: f64) -> f64 {
    low + share * (high - low)
}

/// A bell of height 1 with different widths, full at half its height, below and above its peak.
fn bell(nm: f64, peak: f64, below: f64, above: f64) -> f64 {
    let width = if nm < peak { below } else { above };
    (-4.0 * std::f64::consts::LN_2 * ((nm - peak) / width).powi(2)).exp()
}

/// A line of one nanometer and of area 1, between the two nodes beside it.
fn line(nm: f64, at: f64) -> f64 {
    (1.0 - (nm - at).abs()).max(0.0)
}

const MERCURY: [(f64, f64); 6] =
    [(365.0, 0.3), (404.7, 0.35), (435.8, 1.0), (546.1, 0.9), (577.0, 0.12), (579.1, 0.12)];

fn mercury(nm: f64) -> f64 {
    MERCURY.iter().map(|(at, strength)| strength * bell(nm, *at, 2.5, 2.5)).sum()
}

impl Kind {
    fn power(self, n: &Numbers) -> Power {
        let every = |f: &dyn Fn(f64) -> f64| -> Power { (360..=830).map(|nm| f(f64::from(nm))).collect() };
        let mired = |share: f64, low: f64, high: f64| 1e6 / between(share, 1e6 / high, 1e6 / low);
        match self {
            Kind::BlackBody => {
                let kelvin = mired(n[0], 1000.0, 25_000.0);
                every(&|nm| relative(nm, kelvin, C2_CIE))
            }
            Kind::Daylight => {
                let kelvin = mired(n[0], 4000.0, 25_000.0);
                let [m1, m2] = daylight::factors(kelvin);
                let day = daylight::spectrum([m1 + 0.2 * (n[1] - 0.5), m2 + 0.2 * (n[2] - 0.5)]);
                every(&|nm| day.at(nm, Interpolation::Linear, Outside::Zero).max(0.0))
            }
            Kind::FilteredTungsten => {
                let kelvin = mired(n[0], 1800.0, 3400.0);
                let (depth, at, width) =
                    (4.0 * n[1], between(n[2], 400.0, 750.0), between(n[3], 20.0, 200.0));
                every(&|nm| relative(nm, kelvin, C2_CIE) * (-depth * bell(nm, at, width, width)).exp())
            }
            Kind::WhiteLed => every(&|nm| {
                bell(nm, between(n[0], 430.0, 475.0), between(n[1], 12.0, 25.0), between(n[2], 15.0, 35.0))
                    * between(n[3], 0.1, 1.5)
                    + bell(nm, between(n[4], 515.0, 600.0), between(n[5], 50.0, 100.0), 70.0 + 80.0 * n[6])
                    + n[7]
                        * bell(nm, between(n[8], 600.0, 660.0), between(n[9], 5.0, 90.0), 10.0 + 90.0 * n[10])
            }),
            Kind::VioletLed => every(&|nm| {
                bell(nm, between(n[0], 395.0, 430.0), between(n[1], 10.0, 20.0), between(n[2], 12.0, 25.0))
                    * n[3]
                    + bell(nm, between(n[4], 440.0, 490.0), 30.0, between(n[5], 30.0, 80.0))
                        * between(n[6], 0.1, 1.5)
                    + bell(nm, between(n[7], 515.0, 560.0), 50.0, between(n[8], 50.0, 110.0))
                    + bell(nm, between(n[9], 600.0, 660.0), between(n[10], 8.0, 90.0), 80.0) * 1.5 * n[11]
            }),
            Kind::Triphosphor => every(&|nm| {
                let blue =
                    bell(nm, between(n[0], 445.0, 460.0), 30.0, between(n[1], 40.0, 70.0)) * 0.6 * n[2];
                let green = bell(nm, between(n[3], 541.0, 546.0), 6.0, 8.0)
                    + 0.25 * bell(nm, 487.0, 8.0, 10.0)
                    + 0.2 * bell(nm, 585.0, 8.0, 10.0);
                let red = bell(nm, between(n[4], 609.0, 614.0), 4.0, 5.0)
                    + 0.15 * bell(nm, 630.0, 4.0, 6.0)
                    + 0.1 * bell(nm, 650.0 + 60.0 * n[5], 5.0, 8.0);
                blue + green + 2.5 * n[6] * red + 0.8 * n[7] * mercury(nm) + 0.1 * n[8]
            }),
            Kind::Halophosphate => every(&|nm| {
                bell(nm, between(n[0], 560.0, 620.0), between(n[1], 50.0, 110.0), between(n[2], 60.0, 120.0))
                    + n[3] * bell(nm, between(n[4], 460.0, 500.0), 60.0, between(n[5], 60.0, 120.0))
                    + 3.0 * n[6] * mercury(nm)
            }),
            Kind::NarrowDiodes => every(&|nm| {
                bell(nm, between(n[0], 430.0, 480.0), between(n[1], 3.0, 30.0), between(n[2], 3.0, 35.0))
                    * between(n[3], 0.1, 1.5)
                    + bell(
                        nm,
                        between(n[4], 500.0, 570.0),
                        between(n[5], 3.0, 40.0),
                        between(n[6], 3.0, 50.0),
                    )
                    + bell(
                        nm,
                        between(n[7], 590.0, 670.0),
                        between(n[8], 3.0, 25.0),
                        between(n[9], 3.0, 25.0),
                    ) * between(n[10], 0.1, 3.0)
                    + bell(nm, between(n[11], 480.0, 600.0), 15.0, between(n[12], 5.0, 40.0)) * n[13]
            }),
            Kind::LasersAndPhosphor => every(&|nm| {
                40.0 * n[0] * line(nm, between(n[1], 400.0, 480.0))
                    + 40.0 * n[2] * n[2] * line(nm, between(n[3], 500.0, 670.0))
                    + bell(
                        nm,
                        between(n[4], 520.0, 610.0),
                        between(n[5], 30.0, 90.0),
                        between(n[6], 50.0, 140.0),
                    )
                    + n[7] * bell(nm, between(n[8], 590.0, 670.0), 40.0, 60.0)
            }),
            Kind::Lines => every(&|nm| {
                between(n[0], 0.1, 1.5) * line(nm, between(n[1], 420.0, 490.0))
                    + between(n[2], 0.1, 1.0) * line(nm, between(n[3], 500.0, 580.0))
                    + between(n[4], 0.1, 2.0) * line(nm, between(n[5], 570.0, 680.0))
                    + n[6] * line(nm, between(n[7], 380.0, 700.0))
            }),
        }
    }
}
