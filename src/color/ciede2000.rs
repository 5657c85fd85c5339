//! CIEDE2000.

use super::Lab;
use super::difference::{Polar, polar};
use super::lab::hue_turns;
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::math::{Math, cos_turns, sin_turns, sqrt};

/// The parametric factors of CIEDE2000: 1, 1, 1 under reference conditions (the default),
/// kL = 2 for textiles. All above zero.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Parametric {
    /// kL, for lightness.
    pub k_l: f32,
    /// kC, for chroma.
    pub k_c: f32,
    /// kH, for hue.
    pub k_h: f32,
}

impl Default for Parametric {
    fn default() -> Self {
        Parametric { k_l: 1.0, k_c: 1.0, k_h: 1.0 }
    }
}

/// CIEDE2000 colour difference under reference conditions (kL = kC = kH = 1).
///
/// About 1 is a difference just noticed. Swapping the colours gives the same bits.
///
/// # Accuracy
/// 1e-6 relative, and so also for the smallest differences; within the rounding of all 34
/// published pairs (`tests/differences.rs`). Lab components up to 1e9 in size; beyond 1e18
/// they overflow.
///
/// # Reference
/// ISO/CIE 11664-6:2022; G. Sharma, W. Wu, E. N. Dalal, "The CIEDE2000 color-difference
/// formula", Color Res. Appl. 30 (2005), with its conventions for opposite hues and greys.
///
/// ```
/// use nanospectra::color::{Lab, ciede2000};
/// let pair = [Lab::new(50.0, 2.6772, -79.7751), Lab::new(50.0, 0.0, -82.7485)]; // Sharma's first
/// assert!((ciede2000(pair[0], pair[1]) - 2.0425).abs() < 5e-5);
/// ```
#[cfg(feature = "libm")]
#[must_use]
pub fn ciede2000(x: Lab, y: Lab) -> f32 {
    ciede2000_with::<Portable>(x, y, Parametric::default())
}

/// [`ciede2000`] by the functions of `M`, with parametric factors.
#[must_use]
pub fn ciede2000_with<M: Math>(x: Lab, y: Lab, k: Parametric) -> f32 {
    // Greys are made to differ more in a: a' = (1 + G) a.
    let mean = 0.5 * (x.chroma() + y.chroma());
    let stretch = 1.5 - 0.5 * saturation(mean);
    let (a1, a2) = (stretch * x.a, stretch * y.a);
    let difference = polar([a1, x.b], [a2, y.b]);
    let Polar { c1, c2, dc, dh, .. } = difference;

    let (h1, h2) = (hue_turns::<M>(a1, x.b), hue_turns::<M>(a2, y.b));
    let (h, dh) = if c1 == 0.0 || c2 == 0.0 {
        (h1 + h2, dh) // the hue of the one that has one
    } else {
        mean_hue(h1, h2, &difference)
    };

    let t = 1.0 - 0.17 * cos_turns(h - 30.0 / 360.0)
        + 0.24 * cos_turns(2.0 * h)
        + 0.32 * cos_turns(3.0 * h + 6.0 / 360.0)
        - 0.20 * cos_turns(4.0 * h - 63.0 / 360.0);
    let c = 0.5 * (c1 + c2);
    let from_grey = (0.5 * (x.l + y.l) - 50.0).abs();
    let s_l = 1.0 + 0.015 * from_grey / sqrt(1.0 + 20.0 / (from_grey * from_grey));
    let s_c = 1.0 + 0.045 * c;
    let s_h = 1.0 + 0.015 * c * t;
    // The rotation of the ellipses in the blue, 2 * 30 degrees at the most.
    let from_blue = (h - 275.0 / 360.0) * (360.0 / 25.0);
    let r_t = -2.0 * saturation(c) * sin_turns(M::exp(-from_blue * from_blue) / 6.0);

    let l = (y.l - x.l) / (k.k_l * s_l);
    let c = dc / (k.k_c * s_c);
    let h = dh / (k.k_h * s_h);
    M::sqrt(l * l + c * c + h * h + r_t * (c * h))
}

/// sqrt(C^7 / (C^7 + 25^7)), which neither overflows nor divides zero by zero this way.
fn saturation(chroma: f32) -> f32 {
    let q = 25.0 / chroma;
    let q2 = q * q;
    1.0 / sqrt(1.0 + q2 * q2 * q2 * q)
}

/// The mean hue in turns, and the hue difference with its sign settled.
///
/// Whether the short way leads through hue 0 is asked of the angles where they are near, and of
/// the cross product where they are not: opposite hues are then opposite in f32 too, as the
/// published pairs 9 to 14 demand. An exactly opposite pair does not go through hue 0.
fn mean_hue(h1: f32, h2: f32, difference: &Polar) -> (f32, f32) {
    let &Polar { dh, cross, far, .. } = difference;
    let through_zero =
        if far { if h1 < h2 { cross < 0.0 } else { cross > 0.0 } } else { (h1 - h2).abs() > 0.5 };
    let dh = if far && cross == 0.0 && h2 < h1 { -dh } else { dh };
    let sum = h1 + h2;
    let mean = match through_zero {
        false => 0.5 * sum,
        true if sum < 1.0 => 0.5 * (sum + 1.0),
        true => 0.5 * (sum - 1.0),
    };
    (mean, dh)
}
