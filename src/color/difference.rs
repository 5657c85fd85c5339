//! Color differences in CIELAB that need no more than a square root.

use crate::color::Lab;
use crate::math::{at_most, length, sqrt};

/// The chromas of two colors, and their differences in chroma and hue.
pub(super) struct Polar {
    pub(super) c1: f32,
    pub(super) c2: f32,
    /// C2 - C1
    pub(super) dc: f32,
    /// The hue difference as a length, 2 sqrt(C1 C2) sin(dh / 2), with the sign of `cross`.
    pub(super) dh: f32,
    /// C1 C2 sin(h2 - h1), whose sign says in which sense one turns from the first hue to the second. It is 0
    /// for hues that are equal or exactly opposite.
    pub(super) cross: f32,
    /// Whether the hues are 90 degrees apart or more.
    pub(super) far: bool,
}

/// Returns the unit in which chromas of this size are computed with: 1, or 2^-80 where squares would
/// overflow.
#[inline]
pub(super) fn unit_for(size: f32) -> f32 {
    if size < 1e18 { 1.0 } else { 8.271_806e-25 }
}

/// Returns a color whose a\* and b\* are counted in this unit.
#[inline]
pub(super) fn counted(of: Lab, unit: f32) -> Lab {
    Lab { l: of.l, a: unit * of.a, b: unit * of.b }
}

/// Computes the chroma and hue differences of two colors, with a\* multiplied by `stretch`.
///
/// They are computed from differences of coordinates, not of chromas and angles, so that nothing cancels when
/// the colors are near each other. Swapping the colors changes signs and nothing else.
pub(super) fn polar(x: Lab, y: Lab, stretch: f32) -> Polar {
    let (a1, a2, da) = (stretch * x.a, stretch * y.a, stretch * (y.a - x.a));
    let (b1, b2, db) = (x.b, y.b, y.b - x.b);
    let (c1, c2) = (sqrt(a1 * a1 + b1 * b1), sqrt(a2 * a2 + b2 * b2));
    let sum = c1 + c2;
    let dc = if sum == 0.0 { 0.0 } else { ((a1 + a2) * da + (b1 + b2) * db) / sum };
    let dot = a1 * a2 + b1 * b2;
    // The cross product may be taken with any color on the line through both. The one nearest to gray rounds
    // least.
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
        // Beyond a right angle the cross product decreases again, to zero at 180 degrees.
        let size = sqrt(2.0 * (c1 * c2 - dot));
        if cross < 0.0 { -size } else { size }
    } else {
        let square = 0.5 * (c1 * c2 + dot);
        // With chromas below 1e-22 this may underflow, and then the square of the difference would too.
        if square == 0.0 { 0.0 } else { cross / sqrt(square) }
    };
    Polar { c1, c2, dc, dh, cross, far }
}

/// The application that decides which parametric factor and weights [`cie94`] uses.
///
/// See the [example](cie94#example).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Cie94Weights {
    /// The weights that graphic arts use: kL = 1, K1 = 0.045, K2 = 0.015.
    ///
    /// See the [example](cie94#example).
    GraphicArts,
    /// The weights that the textile industry uses: kL = 2, K1 = 0.048, K2 = 0.014.
    ///
    /// See the [example](cie94#example).
    Textiles,
}

/// Computes the CIE 1976 color difference, which is the distance in CIELAB.
///
/// # Accuracy
/// 2.3e-7 relative, in whatever order the colors come; zero only for equal ones.
///
/// # Example
/// ```
/// use nanospectra::color::{Lab, cie76};
/// assert_eq!(cie76(Lab::new(50.0, 10.0, 0.0), Lab::new(50.0, 13.0, 4.0)), 5.0);
/// ```
#[must_use]
pub fn cie76(x: Lab, y: Lab) -> f32 {
    length([y.l - x.l, y.a - x.a, y.b - x.b])
}

/// Computes the HyAB difference, which is meant for large color differences.
///
/// It adds the size of the lightness difference to the distance in a\* and b\*.
///
/// # Reference
/// S. Abasi, M. Amani Tehran, M. D. Fairchild, "Distance metrics for very large color
/// differences", Color Res. Appl. 45 (2020).
///
/// # Example
/// ```
/// use nanospectra::color::{Lab, hyab};
/// assert_eq!(hyab(Lab::new(50.0, 0.0, 0.0), Lab::new(60.0, 3.0, 4.0)), 10.0 + 5.0);
/// ```
#[must_use]
pub fn hyab(x: Lab, y: Lab) -> f32 {
    (y.l - x.l).abs() + length([y.a - x.a, y.b - x.b])
}

/// Computes the CIE 1994 color difference of a sample from a reference.
///
/// The weights depend on the chroma of the `reference`, so swapping the colors changes the result.
///
/// # Accuracy
/// 6e-7 relative, for differences from 1e-15 on.
///
/// # Reference
/// CIE 116-1995.
///
/// # Example
/// ```
/// use nanospectra::color::{Cie94Weights, Lab, cie94};
/// // From a gray, a chroma difference counts in full: its length is 5.
/// let (gray, sample) = (Lab::new(50.0, 0.0, 0.0), Lab::new(50.0, 3.0, 4.0));
/// assert!((cie94(gray, sample, Cie94Weights::GraphicArts) - 5.0).abs() < 1e-6);
/// // For textiles a lightness difference counts half.
/// assert_eq!(cie94(gray, Lab::new(60.0, 0.0, 0.0), Cie94Weights::Textiles), 5.0);
/// ```
#[must_use]
pub fn cie94(reference: Lab, sample: Lab, weights: Cie94Weights) -> f32 {
    let unit = unit_for(breadth(reference) + breadth(sample));
    let Polar { c1, dc, dh, .. } = polar(counted(reference, unit), counted(sample, unit), 1.0);
    let (k_l, k1, k2) = match weights {
        Cie94Weights::GraphicArts => (1.0, 0.045, 0.015),
        Cie94Weights::Textiles => (2.0, 0.048, 0.014),
    };
    length([(sample.l - reference.l) / k_l, dc / (unit + k1 * c1), dh / (unit + k2 * c1)])
}

/// Computes the CMC(l:c) color difference of a sample from a reference.
///
/// `l` and `c` are 2 and 1 to judge whether a difference is acceptable, 1 and 1 to judge whether it can be
/// seen. The weights depend on the `reference`, so swapping the colors changes the result.
///
/// # Accuracy
/// 7.5e-7 relative, for differences from 1e-15 on, except at the steps that the formula itself has, at
/// L\* = 16 and at hues of 164 and 345 degrees.
///
/// # Reference
/// BS 6923:1988; ISO 105-J03.
///
/// # Example
/// ```
/// use nanospectra::color::{Lab, cmc};
/// // Two grays: the lightness difference of 10 is divided by l and by
/// // S_L = 0.040975 * 50 / (1 + 0.01765 * 50).
/// let (gray, sample) = (Lab::new(50.0, 0.0, 0.0), Lab::new(60.0, 0.0, 0.0));
/// assert!((cmc(gray, sample, 1.0, 1.0) - 9.1885).abs() < 1e-3);
/// assert!((cmc(gray, sample, 2.0, 1.0) - 4.5943).abs() < 1e-3);
/// ```
#[must_use]
pub fn cmc(reference: Lab, sample: Lab, l: f32, c: f32) -> f32 {
    let unit = unit_for(breadth(reference) + breadth(sample));
    let (one, two) = (counted(reference, unit), counted(sample, unit));
    let Polar { c1: counted_c1, dc, dh, .. } = polar(one, two, 1.0);
    let (l1, c1) = (reference.l, at_most(counted_c1 / unit, f32::MAX));
    let s_l = if l1 < 16.0 { 0.511 } else { 0.040_975 * l1 / (1.0 + 0.017_65 * l1) };
    let s_c = 0.0638 * c1 / (1.0 + 0.0131 * c1) + 0.638;
    let c4 = c1 * c1 * c1 * c1;
    let f = 1.0 / sqrt(1.0 + 1900.0 / c4);
    let s_h = s_c * (f * cmc_hue_weight([one.a, one.b], counted_c1) + 1.0 - f);
    length([(sample.l - l1) / (l * s_l), dc / (c * s_c * unit), dh / (s_h * unit)])
}

/// Returns the size of a\* and b\* together.
fn breadth(of: Lab) -> f32 {
    of.a.abs() + of.b.abs()
}

/// Computes the hue weight T of CMC(l:c) without angles.
///
/// The cosine of a hue plus a constant is a combination of a / C and b / C, and the sector of hues is found
/// as two half planes.
fn cmc_hue_weight([a, b]: [f32; 2], c: f32) -> f32 {
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
        return 0.0; // a gray has no hue, and its hue difference is zero
    }
    // The sector from 164 to 345 degrees is 181 degrees wide, so it is the union of two half planes: the one
    // counterclockwise of 164 and the one clockwise of 345.
    let after = COS_164 * b - SIN_164 * a >= 0.0;
    let before = COS_345 * b - SIN_345 * a <= 0.0;
    if after || before {
        0.56 + 0.2 * (a * COS_168 - b * SIN_168).abs() / c
    } else {
        0.36 + 0.4 * (a * COS_35 - b * SIN_35).abs() / c
    }
}
