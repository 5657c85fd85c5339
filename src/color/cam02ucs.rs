//! CAM02-UCS, the uniform space of CIECAM02, for the one viewing condition that TM-30 prescribes.

use crate::color::matrix::{Matrix, apply, inverse64, product64, rounded};
use crate::color::{Cat02, ConeResponses, Xyz};
use crate::math::{Math, Portable, cbrt, sqrt};

// The viewing condition of TM-30: an adapting luminance of 100 cd/m2, a background with Y = 20, an average
// surround and complete adaptation.
const ADAPTING: f32 = 100.0;
const BACKGROUND: f32 = 0.2;
const IMPACT: f32 = 0.69;
const INDUCTION: f32 = 1.0;

/// A color in CAM02-UCS.
#[derive(Clone, Copy, Default)]
pub(super) struct Cam02Ucs {
    pub(super) j: f32,
    pub(super) a: f32,
    pub(super) b: f32,
}

impl Cam02Ucs {
    pub(super) fn distance(self, other: Self) -> f32 {
        let d = [self.j - other.j, self.a - other.a, self.b - other.b];
        sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2])
    }
}

/// The quantities of the model that depend on the white and the surround alone.
pub(super) struct Viewing {
    /// The factor of each CAT02 channel, for complete adaptation to the white.
    gain: [f32; 3],
    /// F_L, the factor of the adapting luminance.
    luminance: f32,
    /// N_bb, which is equal to N_cb.
    contrast: f32,
    /// c z, the exponent of lightness.
    exponent: f32,
    /// A_w, the achromatic response to the white.
    achromatic_white: f32,
    /// (1.64 - 0.29^n)^0.73, a factor of chroma.
    chroma: f32,
    /// F_L^(1/4), the factor from chroma to colorfulness.
    colorfulness: f32,
}

/// X, Y, Z to the cone responses of Hunt, Pointer and Estevez, which the model compresses.
const HPE: [[f64; 3]; 3] = [[0.38971, 0.68898, -0.07868], [-0.22981, 1.18340, 0.04641], [0.0, 0.0, 1.0]];
const CAT02: Matrix = rounded(&Cat02::FROM_XYZ);
const HPE_FROM_CAT02: Matrix = rounded(&product64(&HPE, &inverse64(&Cat02::FROM_XYZ)));

impl Viewing {
    /// Makes the viewing condition for a white with Y = 100.
    pub(super) fn new(white: Xyz) -> Self {
        let five = 5.0 * ADAPTING;
        let k = 1.0 / (five + 1.0);
        let k4 = k * k * k * k;
        let luminance = 0.2 * k4 * five + 0.1 * (1.0 - k4) * (1.0 - k4) * cbrt(five);
        let mut viewing = Viewing {
            gain: apply(&CAT02, white.to_array()).map(|cone| 100.0 / cone),
            luminance,
            contrast: 0.725 * Portable::powf(1.0 / BACKGROUND, 0.2),
            exponent: IMPACT * (1.48 + sqrt(BACKGROUND)),
            achromatic_white: 1.0,
            chroma: Portable::powf(1.64 - Portable::powf(0.29, BACKGROUND), 0.73),
            colorfulness: sqrt(sqrt(luminance)),
        };
        viewing.achromatic_white = viewing.achromatic(viewing.cones(white));
        viewing
    }

    /// Returns the cone responses after adaptation and compression.
    fn cones(&self, xyz: Xyz) -> [f32; 3] {
        let sharp = apply(&CAT02, xyz.to_array());
        let adapted = [sharp[0] * self.gain[0], sharp[1] * self.gain[1], sharp[2] * self.gain[2]];
        apply(&HPE_FROM_CAT02, adapted).map(|cone| {
            let power = Portable::powf(self.luminance * cone.abs() / 100.0, 0.42);
            let response = 400.0 * power / (power + 27.13);
            if cone < 0.0 { 0.1 - response } else { 0.1 + response }
        })
    }

    fn achromatic(&self, [r, g, b]: [f32; 3]) -> f32 {
        (2.0 * r + g + b / 20.0 - 0.305) * self.contrast
    }

    /// Returns the appearance of the color, as CAM02-UCS coordinates.
    pub(super) fn appearance(&self, xyz: Xyz) -> Cam02Ucs {
        let [r, g, b] = self.cones(xyz);
        let (red_green, yellow_blue) = (r - 12.0 * g / 11.0 + b / 11.0, (r + g - 2.0 * b) / 9.0);
        let size = sqrt(red_green * red_green + yellow_blue * yellow_blue);
        let lightness = {
            let share = self.achromatic([r, g, b]) / self.achromatic_white;
            100.0 * Portable::powf(if share > 0.0 { share } else { 0.0 }, self.exponent)
        };
        let j = 1.7 * lightness / (1.0 + 0.007 * lightness);
        if size == 0.0 {
            return Cam02Ucs { j, a: 0.0, b: 0.0 };
        }
        let (cos, sin) = (red_green / size, yellow_blue / size);
        // A quarter of cos(h + 2) + 3.8, with angles in radians.
        let eccentricity = 0.25 * (cos * -0.416_146_84 - sin * 0.909_297_4 + 3.8);
        let t = 50_000.0 / 13.0 * INDUCTION * self.contrast * eccentricity * size / (r + g + 1.05 * b);
        let chroma = Portable::powf(t, 0.9) * sqrt(lightness / 100.0) * self.chroma;
        let m = Portable::ln(1.0 + 0.0228 * chroma * self.colorfulness) / 0.0228;
        Cam02Ucs { j, a: m * cos, b: m * sin }
    }
}
