//! Rows 37 to 40: correlated color temperature by the crate's method and by methods of others.

use super::{Cases, answered};
use crate::yardstick::cct::{mccamy, ohno, robertson};
use nanospectra::color::Uv1960;

pub fn rows(cases: &mut impl Cases) {
    cases.row("37", &PLANE, by_mccamy, ours);
    cases.row("38", &PLANE, |uv| kelvin(robertson(*uv)), ours);
    cases.row("39", &PLANE, |uv| kelvin(ohno(*uv)), ours);
    cases.row("40", &OFF, |uv| answered(Some(by_mccamy(uv)[0])), |uv| answered(near(uv)));
}

/// u and v of lights from 1001 K to 990 000 K, at Duv of -0.0499, 0 and 0.0499.
const PLANE: [[f32; 2]; 24] = [
    [0.4434701, 0.3049315],
    [0.4477768, 0.3546453],
    [0.4520835, 0.4043591],
    [0.3566908, 0.3104449],
    [0.3579111, 0.3603300],
    [0.3591314, 0.4102151],
    [0.3094380, 0.3093593],
    [0.3050484, 0.3590658],
    [0.3006588, 0.4087724],
    [0.2718895, 0.3022342],
    [0.2559530, 0.3495210],
    [0.2400166, 0.3968078],
    [0.2534240, 0.2932977],
    [0.2251106, 0.3343874],
    [0.1967971, 0.3754770],
    [0.2408296, 0.2810459],
    [0.2004285, 0.3103335],
    [0.1600274, 0.3396210],
    [0.2306662, 0.2595288],
    [0.1829329, 0.2740733],
    [0.1351996, 0.2886177],
    [0.2285935, 0.2519032],
    [0.1801207, 0.2637522],
    [0.1316479, 0.2756011],
];

/// Points further than 0.05 from the locus, at 5192 K near the center of its curvature, and the primaries of
/// sRGB.
const OFF: [[f32; 2]; 7] = [
    [0.2367910, 0.4063788],
    [0.2815025, 0.2737105],
    [0.1356572, 0.3572874],
    [0.2815643, 0.2516986],
    [0.4507042, 0.3485915],
    [0.1250000, 0.3750000],
    [0.1754386, 0.1052632],
];

fn near(&[u, v]: &[f32; 2]) -> Option<f32> {
    Uv1960 { u, v }.cct().near().map(|(cct_k, _)| cct_k)
}

fn ours(uv: &[f32; 2]) -> [f32; 1] {
    [near(uv).unwrap_or(f32::NAN)]
}

fn by_mccamy(&[u, v]: &[f32; 2]) -> [f32; 1] {
    let below = 2.0 * u - 8.0 * v + 4.0;
    [mccamy([3.0 * u / below, 2.0 * v / below])]
}

fn kelvin(answer: Option<[f32; 2]>) -> [f32; 1] {
    [answer.map_or(f32::NAN, |[kelvin, _]| kelvin)]
}
