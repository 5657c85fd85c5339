//! Rows 1 to 6: Planck's law.

use super::Cases;
use super::textbook::exp;
use nanospectra::light::{blackbody, blackbody_relative, blackbody_with};
use nanospectra::math::Micromath;

pub fn rows(cases: &mut impl Cases) {
    cases.row("1", &SEEN, naive, ours);
    cases.row("2", &HOT, naive, ours);
    cases.row("3", &SHORT, naive, ours);
    cases.row("4", &FADING, naive, ours);
    cases.row("5", &SHAPE, naive_shape, ours_shape);
    cases.row("6", &SEEN, by_micromath, ours);
}

/// Pairs of nm and K, from 500 K to 1e5 K.
const SEEN: [[f32; 2]; 31] = {
    let (nm, kelvin) = ([360.0, 450.0, 555.0, 680.0, 830.0], [500.0, 1000.0, 2856.0, 6504.0, 2e4, 1e5]);
    // The last pair is the worst of a million that were tried.
    let (mut points, mut k) = ([[738.6631, 67_746.71]; 31], 0);
    while k < 30 {
        points[k] = [nm[k % 5], kelvin[k / 5]];
        k += 1;
    }
    points
};

const HOT: [[f32; 2]; 10] = [
    [555.0, 1e8],
    [555.0, 1e10],
    [555.0, 1e12],
    [360.0, 1e8],
    [360.0, 1e10],
    [360.0, 1e12],
    [830.0, 1e8],
    [830.0, 1e10],
    [830.0, 1e12],
    [528.295_65, 434_802_020.0],
];

/// X-rays of bodies that are hot enough to emit them and of bodies that are not.
const SHORT: [[f32; 2]; 7] = [
    [0.1, 1e10],
    [0.1, 1e12],
    [0.356_360_97, 1.002_171e11],
    [1.0, 1e8],
    [1.0, 1e10],
    [1.0, 300.0],
    [0.1, 6500.0],
];

/// Pairs at which e^x overflows; at 250 K the radiance is below 1e-38.
const FADING: [[f32; 2]; 8] = [
    [555.0, 250.0],
    [555.0, 255.097_56],
    [555.0, 256.0],
    [555.0, 262.0],
    [555.0, 270.0],
    [555.0, 285.0],
    [555.0, 300.0],
    [555.0, 320.0],
];

const SHAPE: [[f32; 2]; 13] = [
    [383.614, 177.229_81],
    [373.2828, 178.689_97],
    [830.0, 100.0],
    [700.0, 100.0],
    [500.0, 150.0],
    [830.0, 150.0],
    [360.0, 200.0],
    [450.0, 200.0],
    [830.0, 200.0],
    [360.0, 300.0],
    [700.0, 300.0],
    [830.0, 1000.0],
    [552.5, 1e5],
];

/// Computes Planck's law in SI units and returns the radiance per nm.
fn radiance(nm: f32, kelvin: f32) -> f32 {
    let length = nm * 1e-9;
    let fifth = length * length * length * length * length;
    1e-9 * (1.191_043e-16 / fifth / (exp(1.438_776_9e-2 / (length * kelvin)) - 1.0))
}

fn naive(&[nm, kelvin]: &[f32; 2]) -> [f32; 1] {
    [radiance(nm, kelvin)]
}

fn ours(&[nm, kelvin]: &[f32; 2]) -> [f32; 1] {
    [blackbody(nm, kelvin)]
}

fn naive_shape(&[nm, kelvin]: &[f32; 2]) -> [f32; 1] {
    [radiance(nm, kelvin) / radiance(560.0, kelvin)]
}

fn ours_shape(&[nm, kelvin]: &[f32; 2]) -> [f32; 1] {
    [blackbody_relative(nm, kelvin)]
}

fn by_micromath(&[nm, kelvin]: &[f32; 2]) -> [f32; 1] {
    [blackbody_with::<Micromath>(nm, kelvin)]
}
