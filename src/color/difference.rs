//! Color differences in CIELAB that need no more than a square root.

use crate::color::Lab;
use crate::math::sqrt;

/// What two colors differ by in chroma and hue.
pub(super) struct Polar {
    pub(super) c1: f32,
    pub(super) c2: f32,
    /// C2 - C1
    pub(super) dc: f32,
    /// The hue difference as a length, 2 sqrt(C1 C2) sin(dh / 2), with the sign of `cross`.
    pub(super) dh: f32,
    /// C1 C2 sin(h2 - h1): which way round from the first hue to the second; 0 for hues that
    /// are equal or exactly opposite.
    pub(super) cross: f32,
    /// Are the hues 90 degrees apart or more?
    pub(super) far: bool,
}

/// The chroma and hue difference of two colors whose a counts `stretch` times, from differences
/// of coordinates rather than of chromas and angles: what two near colors share then cannot
/// drown what they differ by. Swapping the colors changes signs, and nothing else.
pub(super) fn polar(x: Lab, y: Lab, stretch: f32) -> Polar {
    let (a1, a2, da) = (stretch * x.a, stretch * y.a, stretch * (y.a - x.a));
    let (b1, b2, db) = (x.b, y.b, y.b - x.b);
    let (c1, c2) = (sqrt(a1 * a1 + b1 * b1), sqrt(a2 * a2 + b2 * b2));
    let sum = c1 + c2;
    let dc = if sum == 0.0 { 0.0 } else { ((a1 + a2) * da + (b1 + b2) * db) / sum };
    let dot = a1 * a2 + b1 * b2;
    // Any color on the line through both will do here; the one nearest to gray rounds least.
    let (a, b) = if c1 < c2 {
        (a1, b1)
    } else if c2 < c1 {
        (a2, b2)
    } else {
        (0.5 * (a1 + a2), 0.5 * (b1 + b2))
    };
    let cross = a * db - b * da;
    let far = dot <= 0.0;
    let dh = if far {
        // Beyond a right angle the cross product falls again (to nothing at 180 degrees).
        let size = sqrt(2.0 * (c1 * c2 - dot));
        if cross < 0.0 { -size } else { size }
    } else {
        let square = 0.5 * (c1 * c2 + dot);
        // Of chromas below 1e-22 it may underflow, and so will the square of what they differ by.
        if square == 0.0 { 0.0 } else { cross / sqrt(square) }
    };
    Polar { c1, c2, dc, dh, cross, far }
}

/// The application that [`cie94`] takes its parametric factor and weights from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Cie94Weights {
    /// kL = 1, K1 = 0.045, K2 = 0.015
    GraphicArts,
    /// kL = 2, K1 = 0.048, K2 = 0.014
    Textiles,
}

/// CIE 1976 color difference, the distance in CIELAB.
///
/// # Accuracy
/// 1.5e-7 relative, in whatever order the colors come; zero only for equal ones.
///
/// ```
/// use nanospectra::color::{Lab, cie76};
/// assert_eq!(cie76(Lab::new(50.0, 10.0, 0.0), Lab::new(50.0, 13.0, 4.0)), 5.0);
/// ```
#[must_use]
pub fn cie76(x: Lab, y: Lab) -> f32 {
    length(y.l - x.l, y.a - x.a, y.b - x.b)
}

/// HyAB: city-block in lightness, distance in a and b; for large differences.
///
/// # Reference
/// S. Abasi, M. Amani Tehran, M. D. Fairchild, "Distance metrics for very large color
/// differences", Color Res. Appl. 45 (2020).
#[must_use]
pub fn hyab(x: Lab, y: Lab) -> f32 {
    (y.l - x.l).abs() + length(0.0, y.a - x.a, y.b - x.b)
}

/// CIE 1994 color difference; the weights come from the chroma of the `reference`, so it is
/// not symmetric.
///
/// # Accuracy
/// 4e-7 relative.
///
/// # Reference
/// CIE 116-1995.
#[must_use]
pub fn cie94(reference: Lab, sample: Lab, weights: Cie94Weights) -> f32 {
    let Polar { c1, dc, dh, .. } = polar(reference, sample, 1.0);
    let (k_l, k1, k2) = match weights {
        Cie94Weights::GraphicArts => (1.0, 0.045, 0.015),
        Cie94Weights::Textiles => (2.0, 0.048, 0.014),
    };
    length((sample.l - reference.l) / k_l, dc / (1.0 + k1 * c1), dh / (1.0 + k2 * c1))
}

/// CMC(l:c) color difference; `l` and `c` are 2 and 1 for acceptability, 1 and 1 for
/// perceptibility. The weights come from the `reference`, so it is not symmetric.
///
/// # Accuracy
/// 5e-7 relative, but for the formula's own steps at L\* = 16 and at hues of 164 and 345
/// degrees.
///
/// # Reference
/// BS 6923:1988; ISO 105-J03.
#[must_use]
pub fn cmc(reference: Lab, sample: Lab, l: f32, c: f32) -> f32 {
    let Lab { l: l1, a, b } = reference;
    let Polar { c1, dc, dh, .. } = polar(reference, sample, 1.0);
    let s_l = if l1 < 16.0 { 0.511 } else { 0.040_975 * l1 / (1.0 + 0.017_65 * l1) };
    let s_c = 0.0638 * c1 / (1.0 + 0.0131 * c1) + 0.638;
    let c4 = c1 * c1 * c1 * c1;
    let f = 1.0 / sqrt(1.0 + 1900.0 / c4);
    let s_h = s_c * (f * cmc_hue_weight(a, b, c1) + 1.0 - f);
    length((sample.l - l1) / (l * s_l), dc / (c * s_c), dh / s_h)
}

/// T of CMC(l:c): cosines of hue plus a constant, which are a / C and b / C turned, so that
/// no angle is needed; nor for the sector, which is a matter of two half planes.
fn cmc_hue_weight(a: f32, b: f32, c: f32) -> f32 {
    // cos and sin of 168, 35, 164 and 345 degrees
    const COS_168: f32 = -0.978_147_6;
    const SIN_168: f32 = 0.207_911_69;
    const COS_35: f32 = 0.819_152_04;
    const SIN_35: f32 = 0.573_576_44;
    const COS_164: f32 = -0.961_261_7;
    const SIN_164: f32 = 0.275_637_36;
    const COS_345: f32 = 0.965_925_8;
    const SIN_345: f32 = -0.258_819_05;
    if c == 0.0 {
        return 0.0; // a gray has no hue, and no weight for it
    }
    // The sector is 181 degrees wide, so it is the union of two half planes: counterclockwise
    // of 164, or clockwise of 345.
    let after = COS_164 * b - SIN_164 * a >= 0.0;
    let before = COS_345 * b - SIN_345 * a <= 0.0;
    if after || before {
        0.56 + 0.2 * (a * COS_168 - b * SIN_168).abs() / c
    } else {
        0.36 + 0.4 * (a * COS_35 - b * SIN_35).abs() / c
    }
}

/// The length of a difference.
fn length(x: f32, y: f32, z: f32) -> f32 {
    sqrt(x * x + y * y + z * z)
}
