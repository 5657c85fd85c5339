//! CIECAM02 and CAM16 with their uniform spaces; TM-30 measures in CAM02-UCS.

use super::linear::{Matrix3, apply, inverse};

const CAT02: Matrix3 = [[0.7328, 0.4296, -0.1624], [-0.7036, 1.6975, 0.0061], [0.0030, 0.0136, 0.9834]];
const HUNT_POINTER_ESTEVEZ: Matrix3 =
    [[0.38971, 0.68898, -0.07868], [-0.22981, 1.18340, 0.04641], [0.0, 0.0, 1.0]];

const CAT16: Matrix3 =
    [[0.401288, 0.650173, -0.051461], [-0.250268, 1.204414, 0.045854], [-0.002079, 0.048952, 0.953127]];

/// F, c and Nc of the surround.
pub const AVERAGE: [f64; 3] = [1.0, 0.69, 1.0];
pub const DIM: [f64; 3] = [0.9, 0.59, 0.9];
pub const DARK: [f64; 3] = [0.8, 0.525, 0.8];

/// What the color is seen in; a perfect white surface has Y = 100.
#[derive(Clone, Copy, Debug)]
pub struct Viewing {
    pub white: [f64; 3],
    /// Luminance of the adapting field, cd/m2.
    pub la: f64,
    /// Relative luminance of the background.
    pub yb: f64,
    /// Degree of adaptation, 0 to 1.
    pub d: f64,
    /// F, c and Nc.
    pub surround: [f64; 3],
}

#[derive(Clone, Copy, Debug)]
pub struct Seen {
    pub lightness: f64,
    pub chroma: f64,
    pub hue_deg: f64,
    pub saturation: f64,
    pub brightness: f64,
    pub colorfulness: f64,
}

/// The degree of adaptation the model computes for a surround.
pub fn degree_of_adaptation(la: f64, surround: [f64; 3]) -> f64 {
    surround[0] * (1.0 - (-(la + 42.0) / 92.0).exp() / 3.6)
}

pub fn ciecam02(xyz: [f64; 3], viewing: Viewing) -> Seen {
    seen(xyz, viewing, CAT02, |adapted| apply(HUNT_POINTER_ESTEVEZ, apply(inverse(CAT02), adapted)))
}

pub fn cam16(xyz: [f64; 3], viewing: Viewing) -> Seen {
    seen(xyz, viewing, CAT16, |adapted| adapted)
}

/// NaN where a number below a root is negative.
fn seen(xyz: [f64; 3], viewing: Viewing, cat: Matrix3, compressed: fn([f64; 3]) -> [f64; 3]) -> Seen {
    let Viewing { white, la, yb, d, surround: [_, c, nc] } = viewing;
    let k = 1.0 / (5.0 * la + 1.0);
    let fl = 0.2 * k.powi(4) * 5.0 * la + 0.1 * (1.0 - k.powi(4)).powi(2) * (5.0 * la).cbrt();
    let n = yb / white[1];
    let z = 1.48 + n.sqrt();
    let nbb = 0.725 * n.powf(-0.2);

    let cone_white = apply(cat, white);
    let compress = |xyz: [f64; 3]| -> [f64; 3] {
        let cone = apply(cat, xyz);
        let adapted = [0, 1, 2].map(|i| (d * white[1] / cone_white[i] + 1.0 - d) * cone[i]);
        compressed(adapted).map(|v| {
            let p = (fl * v.abs() / 100.0).powf(0.42);
            v.signum() * 400.0 * p / (27.13 + p) + 0.1
        })
    };
    let achromatic = |[r, g, b]: [f64; 3]| (2.0 * r + g + b / 20.0 - 0.305) * nbb;

    let [r, g, b] = compress(xyz);
    let (red_green, yellow_blue) = (r - 12.0 * g / 11.0 + b / 11.0, (r + g - 2.0 * b) / 9.0);
    let hue = yellow_blue.atan2(red_green);
    let eccentricity = 0.25 * ((hue + 2.0).cos() + 3.8);
    let white_response = achromatic(compress(white));
    let lightness = 100.0 * (achromatic([r, g, b]) / white_response).powf(c * z);
    let t =
        50000.0 / 13.0 * nc * nbb * eccentricity * red_green.hypot(yellow_blue) / (r + g + 21.0 * b / 20.0);
    let chroma = t.powf(0.9) * (lightness / 100.0).sqrt() * (1.64 - 0.29f64.powf(n)).powf(0.73);
    let colorfulness = chroma * fl.powf(0.25);
    let brightness = 4.0 / c * (lightness / 100.0).sqrt() * (white_response + 4.0) * fl.powf(0.25);
    Seen {
        lightness,
        chroma,
        hue_deg: hue.to_degrees().rem_euclid(360.0),
        saturation: 100.0 * (colorfulness / brightness).sqrt(),
        brightness,
        colorfulness,
    }
}

/// J', a', b' of CAM02-UCS.
pub fn cam02_ucs(xyz: [f64; 3], viewing: Viewing) -> [f64; 3] {
    uniform(ciecam02(xyz, viewing))
}

/// J', a', b' of CAM02-UCS or CAM16-UCS.
pub fn uniform(seen: Seen) -> [f64; 3] {
    let j = 1.7 * seen.lightness / (1.0 + 0.007 * seen.lightness);
    let m = (1.0 + 0.0228 * seen.colorfulness).ln() / 0.0228;
    let (sin, cos) = seen.hue_deg.to_radians().sin_cos();
    [j, m * cos, m * sin]
}
