//! Rows 34 to 36: CIEDE2000 of the published pairs, near pairs, opposite hues and large chromas.

use super::Cases;
use super::noise::Noise;
use super::textbook::{self, exp, powf};
use core::f32::consts::PI;
use nanospectra::color::{Lab, ciede2000};
use nanospectra::math::{Libm, Math, sqrt};

pub fn rows(cases: &mut impl Cases) {
    cases.row("34a", &SHARMA, |pair| naive(pair, by_angles), ours);
    cases.row("34b", &FAR, |pair| naive(pair, by_angles), ours);
    cases.row("34c", &near(), |pair| naive(pair, by_angles), ours);
    cases.row("35", &OPPOSITE, |pair| naive(pair, by_cross_product), ours);
    cases.row("36", &LARGE, |pair| naive(pair, by_angles), ours);
}

/// L*, a*, b* of two colors.
type Pair = [f32; 6];

/// The pairs of table 1 of Sharma, Wu and Dalal 2005.
const SHARMA: [Pair; 34] = [
    [50.0, 2.6772, -79.7751, 50.0, 0.0, -82.7485],
    [50.0, 3.1571, -77.2803, 50.0, 0.0, -82.7485],
    [50.0, 2.8361, -74.0200, 50.0, 0.0, -82.7485],
    [50.0, -1.3802, -84.2814, 50.0, 0.0, -82.7485],
    [50.0, -1.1848, -84.8006, 50.0, 0.0, -82.7485],
    [50.0, -0.9009, -85.5211, 50.0, 0.0, -82.7485],
    [50.0, 0.0, 0.0, 50.0, -1.0, 2.0],
    [50.0, -1.0, 2.0, 50.0, 0.0, 0.0],
    [50.0, 2.4900, -0.0010, 50.0, -2.4900, 0.0009],
    [50.0, 2.4900, -0.0010, 50.0, -2.4900, 0.0010],
    [50.0, 2.4900, -0.0010, 50.0, -2.4900, 0.0011],
    [50.0, 2.4900, -0.0010, 50.0, -2.4900, 0.0012],
    [50.0, -0.0010, 2.4900, 50.0, 0.0009, -2.4900],
    [50.0, -0.0010, 2.4900, 50.0, 0.0010, -2.4900],
    [50.0, -0.0010, 2.4900, 50.0, 0.0011, -2.4900],
    [50.0, 2.5, 0.0, 50.0, 0.0, -2.5],
    [50.0, 2.5, 0.0, 73.0, 25.0, -18.0],
    [50.0, 2.5, 0.0, 61.0, -5.0, 29.0],
    [50.0, 2.5, 0.0, 56.0, -27.0, -3.0],
    [50.0, 2.5, 0.0, 58.0, 24.0, 15.0],
    [50.0, 2.5, 0.0, 50.0, 3.1736, 0.5854],
    [50.0, 2.5, 0.0, 50.0, 3.2972, 0.0],
    [50.0, 2.5, 0.0, 50.0, 1.8634, 0.5757],
    [50.0, 2.5, 0.0, 50.0, 3.2592, 0.3350],
    [60.2574, -34.0099, 36.2677, 60.4626, -34.1751, 39.4387],
    [63.0109, -31.0961, -5.8663, 62.8187, -29.7946, -4.0864],
    [61.2901, 3.7196, -5.3901, 61.4292, 2.2480, -4.9620],
    [35.0831, -44.1164, 3.7933, 35.0232, -40.0716, 1.5901],
    [22.7233, 20.0904, -46.6940, 23.0331, 14.9730, -42.5619],
    [36.4612, 47.8580, 18.3852, 36.2715, 50.5065, 21.2231],
    [90.8027, -2.0831, 1.4410, 91.1528, -1.6435, 0.0447],
    [90.9257, -0.5406, -0.9208, 88.6381, -0.8985, -0.7239],
    [6.7747, -0.2908, -2.4247, 5.8714, -0.0985, -2.2286],
    [2.0776, 0.0795, -1.1350, 0.9033, -0.0636, -0.5514],
];

/// Sharma's pairs 9 to 14, whose hues are opposite.
const OPPOSITE: [Pair; 6] = [SHARMA[8], SHARMA[9], SHARMA[10], SHARMA[11], SHARMA[12], SHARMA[13]];

/// Pairs of nearly opposite hues, where the mean hue turns fastest: the worst of a million random pairs.
const FAR: [Pair; 3] = [
    [19.855_652, 90.198_006, -47.310_173, 29.593_237, -91.061_51, -31.913_725],
    [50.0, 60.0, 20.0, 60.0, -60.0, -21.0],
    [30.0, -5.0, 80.0, 40.0, 70.0, -60.0],
];

/// Colors of huge chroma, such as lasers and matrices can give.
const LARGE: [Pair; 5] = [
    [50.0, 1e5, 100.0, 50.0, 1e5, -200.0],
    [50.0, 2e5, 1e5, 40.0, 1e5, 2e5],
    [50.0, 4e5, 1e4, 55.0, 4e5, -1e4],
    [50.0, -1e6, 1e6, 50.0, -1e6, 1.1e6],
    [10.0, 3e7, 1.0, 90.0, 2e7, 5e6],
];

/// Returns pairs of saturated colors that are a hundredth apart.
fn near() -> [Pair; 24] {
    let mut noise = Noise(34);
    [(); 24].map(|()| {
        let [l, a, b] = [50.0 + 40.0 * noise.offset(), 90.0 * noise.offset(), 90.0 * noise.offset()];
        let mut moved = |x: f32| x + 0.01 * noise.offset();
        [l, a, b, moved(l), moved(a), moved(b)]
    })
}

fn ours(&[l1, a1, b1, l2, a2, b2]: &Pair) -> [f32; 1] {
    [ciede2000(Lab::new(l1, a1, b1), Lab::new(l2, a2, b2))]
}

/// A function that returns the difference of hue of (a1, b1) and (a2, b2), times root(C1 C2).
type HueDifference = fn([f32; 2], [f32; 2]) -> f32;

fn chroma([a, b]: [f32; 2]) -> f32 {
    sqrt(a * a + b * b)
}

/// Returns the hue in degrees.
fn hue([a, b]: [f32; 2]) -> f32 {
    if a == 0.0 && b == 0.0 {
        return 0.0;
    }
    let hue = Libm::atan2(b, a) * 180.0 / PI;
    if hue < 0.0 { hue + 360.0 } else { hue }
}

fn sin(degrees: f32) -> f32 {
    textbook::sin(degrees * PI / 180.0)
}

fn cos(degrees: f32) -> f32 {
    textbook::cos(degrees * PI / 180.0)
}

fn by_angles(one: [f32; 2], two: [f32; 2]) -> f32 {
    let (c1, c2) = (chroma(one), chroma(two));
    let mut turn = if c1 * c2 == 0.0 { 0.0 } else { hue(two) - hue(one) };
    if turn > 180.0 {
        turn -= 360.0;
    } else if turn < -180.0 {
        turn += 360.0;
    }
    2.0 * sqrt(c1 * c2) * sin(0.5 * turn)
}

/// Returns the cross product over root((C1 C2 + the scalar product) / 2), whatever the two hues are.
fn by_cross_product(one: [f32; 2], two: [f32; 2]) -> f32 {
    let scalar = one[0] * two[0] + one[1] * two[1];
    let below = 0.5 * (chroma(one) * chroma(two) + scalar);
    if below > 0.0 { (one[0] * two[1] - two[0] * one[1]) / sqrt(below) } else { 0.0 }
}

/// Returns root(C^7 / (C^7 + 25^7)) by the seventh powers.
fn by_powers(c: f32) -> f32 {
    let seventh = powf(c, 7.0);
    sqrt(seventh / (seventh + 6_103_515_625.0))
}

/// Computes CIEDE2000 by Sharma's formulas as they are printed.
fn naive(&[l1, a1, b1, l2, a2, b2]: &Pair, hue_difference: HueDifference) -> [f32; 1] {
    let mean = 0.5 * (chroma([a1, b1]) + chroma([a2, b2]));
    let g = 0.5 * (1.0 - by_powers(mean));
    let (one, two) = ([(1.0 + g) * a1, b1], [(1.0 + g) * a2, b2]);
    let (c1, c2) = (chroma(one), chroma(two));
    let (delta_l, delta_c, delta_h) = (l2 - l1, c2 - c1, hue_difference(one, two));
    let (l, c) = (0.5 * (l1 + l2), 0.5 * (c1 + c2));
    let (h1, h2) = (hue(one), hue(two));
    let apart = if h1 > h2 { h1 - h2 } else { h2 - h1 };
    let h = if c1 * c2 == 0.0 {
        h1 + h2
    } else if apart <= 180.0 {
        0.5 * (h1 + h2)
    } else if h1 + h2 < 360.0 {
        0.5 * (h1 + h2 + 360.0)
    } else {
        0.5 * (h1 + h2 - 360.0)
    };
    let t = 1.0 - 0.17 * cos(h - 30.0) + 0.24 * cos(2.0 * h) + 0.32 * cos(3.0 * h + 6.0)
        - 0.20 * cos(4.0 * h - 63.0);
    let from_blue = (h - 275.0) / 25.0;
    let turn = 30.0 * exp(-from_blue * from_blue);
    let l50 = (l - 50.0) * (l - 50.0);
    let sl = 1.0 + 0.015 * l50 / sqrt(20.0 + l50);
    let (sc, sh) = (1.0 + 0.045 * c, 1.0 + 0.015 * c * t);
    let rt = -2.0 * by_powers(c) * sin(2.0 * turn);
    let (l, c, h) = (delta_l / sl, delta_c / sc, delta_h / sh);
    [sqrt(l * l + c * c + h * h + rt * c * h)]
}
