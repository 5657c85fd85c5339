//! Color differences between two CIELAB colors; the first is the standard where it matters.

use super::lab::hue_degrees;

pub fn de76(one: [f64; 3], two: [f64; 3]) -> f64 {
    (0..3).map(|c| (one[c] - two[c]).powi(2)).sum::<f64>().sqrt()
}

pub fn hyab(one: [f64; 3], two: [f64; 3]) -> f64 {
    (one[0] - two[0]).abs() + (one[1] - two[1]).hypot(one[2] - two[2])
}

/// The differences of lightness and chroma, and the square of the hue difference, from the first color to the
/// second. Nothing cancels, however near the two are.
fn parts(one: [f64; 3], two: [f64; 3]) -> (f64, f64, f64) {
    let (c1, c2) = (one[1].hypot(one[2]), two[1].hypot(two[2]));
    let (da, db) = (two[1] - one[1], two[2] - one[2]);
    let chroma =
        if c1 + c2 > 0.0 { ((one[1] + two[1]) * da + (one[2] + two[2]) * db) / (c1 + c2) } else { 0.0 };
    let (cross, dot) = (one[1] * db - one[2] * da, one[1] * two[1] + one[2] * two[2]);
    let hue2 = if dot > 0.0 { cross * cross / (0.5 * (c1 * c2 + dot)) } else { 2.0 * (c1 * c2 - dot) };
    (two[0] - one[0], chroma, hue2)
}

fn de94_with(one: [f64; 3], two: [f64; 3], kl: f64, k1: f64, k2: f64) -> f64 {
    let (lightness, chroma, hue2) = parts(one, two);
    let c1 = one[1].hypot(one[2]);
    let (sc, sh) = (1.0 + k1 * c1, 1.0 + k2 * c1);
    ((lightness / kl).powi(2) + (chroma / sc).powi(2) + hue2 / (sh * sh)).sqrt()
}

/// CIE94 for graphic arts.
pub fn de94(one: [f64; 3], two: [f64; 3]) -> f64 {
    de94_with(one, two, 1.0, 0.045, 0.015)
}

pub fn de94_textiles(one: [f64; 3], two: [f64; 3]) -> f64 {
    de94_with(one, two, 2.0, 0.048, 0.014)
}

/// CMC(l:c).
pub fn cmc(one: [f64; 3], two: [f64; 3], l: f64, c: f64) -> f64 {
    let (lightness, chroma, hue2) = parts(one, two);
    let c1 = one[1].hypot(one[2]);
    let h1 = hue_degrees(one[1], one[2]);
    let t = if (164.0..=345.0).contains(&h1) {
        0.56 + (0.2 * (h1 + 168.0).to_radians().cos()).abs()
    } else {
        0.36 + (0.4 * (h1 + 35.0).to_radians().cos()).abs()
    };
    let f = (c1.powi(4) / (c1.powi(4) + 1900.0)).sqrt();
    let sl = if one[0] < 16.0 { 0.511 } else { 0.040975 * one[0] / (1.0 + 0.01765 * one[0]) };
    let sc = 0.0638 * c1 / (1.0 + 0.0131 * c1) + 0.638;
    let sh = sc * (f * t + 1.0 - f);
    ((lightness / (l * sl)).powi(2) + (chroma / (c * sc)).powi(2) + hue2 / (sh * sh)).sqrt()
}

/// CIEDE2000 with kL = kC = kH = 1, after Sharma, Wu and Dalal 2005.
pub fn de2000(one: [f64; 3], two: [f64; 3]) -> f64 {
    let mean_c = 0.5 * (one[1].hypot(one[2]) + two[1].hypot(two[2]));
    let c7 = mean_c.powi(7);
    let g = 0.5 * (1.0 - (c7 / (c7 + 25f64.powi(7))).sqrt());
    let [one, two] = [one, two].map(|[l, a, b]| [l, (1.0 + g) * a, b]);
    let (c1, c2) = (one[1].hypot(one[2]), two[1].hypot(two[2]));
    let (h1, h2) = (hue_degrees(one[1], one[2]), hue_degrees(two[1], two[2]));
    let gray = c1 * c2 == 0.0;
    let (delta_l, delta_c, hue2) = parts(one, two);
    let clockwise = one[1] * (two[2] - one[2]) < one[2] * (two[1] - one[1]);
    let delta_h = if gray { 0.0 } else { hue2.sqrt().copysign(if clockwise { -1.0 } else { 1.0 }) };

    let l = 0.5 * (one[0] + two[0]);
    let c = 0.5 * (c1 + c2);
    let h = if gray {
        h1 + h2
    } else if (h1 - h2).abs() <= 180.0 {
        0.5 * (h1 + h2)
    } else if h1 + h2 < 360.0 {
        0.5 * (h1 + h2 + 360.0)
    } else {
        0.5 * (h1 + h2 - 360.0)
    };
    let cos = |degrees: f64| degrees.to_radians().cos();
    let t = 1.0 - 0.17 * cos(h - 30.0) + 0.24 * cos(2.0 * h) + 0.32 * cos(3.0 * h + 6.0)
        - 0.20 * cos(4.0 * h - 63.0);
    let turn = 30.0 * (-((h - 275.0) / 25.0).powi(2)).exp();
    let c7 = c.powi(7);
    let rc = 2.0 * (c7 / (c7 + 25f64.powi(7))).sqrt();
    let l50 = (l - 50.0).powi(2);
    let sl = 1.0 + 0.015 * l50 / (20.0 + l50).sqrt();
    let sc = 1.0 + 0.045 * c;
    let sh = 1.0 + 0.015 * c * t;
    let rt = -(2.0 * turn).to_radians().sin() * rc;
    let (l, c, h) = (delta_l / sl, delta_c / sc, delta_h / sh);
    (l * l + c * c + h * h + rt * c * h).sqrt()
}
