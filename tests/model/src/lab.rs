//! CIELAB, CIELUV and Oklab.

use super::chromaticity::uv1976;

/// CIE 15: the exact fractions 216/24389 and 24389/27.
fn lightness_root(t: f64) -> f64 {
    if t > 216.0 / 24389.0 { t.cbrt() } else { (24389.0 / 27.0 * t + 16.0) / 116.0 }
}

pub fn lab(xyz: [f64; 3], white: [f64; 3]) -> [f64; 3] {
    let [x, y, z] = [0, 1, 2].map(|c| lightness_root(xyz[c] / white[c]));
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// L, C, h with h in degrees from 0 to 360.
pub fn lch([l, a, b]: [f64; 3]) -> [f64; 3] {
    [l, a.hypot(b), hue_degrees(a, b)]
}

pub fn hue_degrees(a: f64, b: f64) -> f64 {
    b.atan2(a).to_degrees().rem_euclid(360.0)
}

/// CIELUV; black is (0, 0, 0).
pub fn luv(xyz: [f64; 3], white: [f64; 3]) -> [f64; 3] {
    let l = 116.0 * lightness_root(xyz[1] / white[1]) - 16.0;
    if xyz == [0.0; 3] {
        return [l, 0.0, 0.0];
    }
    let ([u, v], [un, vn]) = (uv1976(xyz), uv1976(white));
    [l, 13.0 * l * (u - un), 13.0 * l * (v - vn)]
}

/// Oklab of XYZ with Y = 1 for D65 white, Ottosson's matrices of 2021.
pub fn oklab([x, y, z]: [f64; 3]) -> [f64; 3] {
    let l = (0.8189330101 * x + 0.3618667424 * y - 0.1288597137 * z).cbrt();
    let m = (0.0329845436 * x + 0.9293118715 * y + 0.0361456387 * z).cbrt();
    let s = (0.0482003018 * x + 0.2643662691 * y + 0.6338517070 * z).cbrt();
    [
        0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
        1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
        0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s,
    ]
}
