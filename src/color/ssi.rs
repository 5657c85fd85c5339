//! The spectral similarity index of two lights.

use crate::math::sqrt;
use crate::spectrum::{Fine, Power};

/// The number of intervals of 10 nm, whose middles are 380, 390, .., 670 nm.
const INTERVALS: usize = 30;
/// The place of 375 nm, where the first interval begins, in the spectra of 1 nm.
const FIRST: usize = 15;

/// Computes the spectral similarity index of a light to a reference, which tells how far colors can be
/// trusted that a camera, and not an eye, sees under it: 100 is the same spectrum.
///
/// Above 90 hardly any camera shows a difference; an index far below 50 says no more than that the light is
/// another one, and a single line has one below zero. The index is not rounded; the standard gives it as a
/// whole number. Lights are compared from 375 to 675 nm, without their brightness, and an exchange of the two
/// changes the index. The result is `None` if one of them has no power there. NaN stays NaN.
///
/// # Accuracy
/// 5e-5 and 3e-6 of what the index lacks to 100 (searched in `tests/color/worst_conversions.rs`).
///
/// # Cost
/// On a Cortex-M4F it takes 2900 instructions and 930 bytes of stack at opt-level 3, and 1130 bytes at "s".
///
/// # Reference
/// SMPTE ST 2122:2020; Academy of Motion Picture Arts and Sciences, "Academy Spectral Similarity Index (SSI):
/// Overview", 2020.
///
/// # Example
/// ```
/// use nanospectra::color::ssi;
/// use nanospectra::light;
/// // A cool white fluorescent lamp in the place of daylight, as colour-science 0.4.7 has it.
/// let index = ssi(&light::FL2.fine(), &light::D65.fine()).ok_or("dark")?;
/// assert!((index - 58.26).abs() < 5e-3);
/// # Ok::<(), &str>(())
/// ```
#[must_use]
pub fn ssi(light: &Fine<Power>, reference: &Fine<Power>) -> Option<f32> {
    let (light, reference) = (shares(light)?, shares(reference)?);
    let mut differences = [0.0; INTERVALS + 2];
    let places = differences.iter_mut().skip(1).zip(light.iter().zip(&reference)).zip(WEIGHTS);
    for ((difference, (light, reference)), weight) in places {
        *difference = weight * (light - reference) / (reference + 1.0 / INTERVALS as f32);
    }
    // Each is smoothed with its neighbors, beyond the ends with zero.
    let smoothed = differences.windows(3).map(|near| match near {
        [before, here, after] => 0.22 * before + 0.56 * here + 0.22 * after,
        _ => 0.0,
    });
    Some(100.0 - 32.0 * sqrt(smoothed.map(|difference| difference * difference).sum()))
}

/// The weight of each interval: the ends of the range count less.
const WEIGHTS: [f32; INTERVALS] = {
    let mut weights = [1.0; INTERVALS];
    weights[0] = 12.0 / 45.0;
    weights[1] = 22.0 / 45.0;
    weights[2] = 32.0 / 45.0;
    weights[3] = 40.0 / 45.0;
    weights[4] = 44.0 / 45.0;
    weights[28] = 11.0 / 15.0;
    weights[29] = 3.0 / 15.0;
    weights
};

/// Returns the share of each interval in the power of all; the nanometer between two counts half in each.
fn shares(light: &Fine<Power>) -> Option<[f32; INTERVALS]> {
    let mut shares = [0.0; INTERVALS];
    let intervals = light.values().get(FIRST..)?.windows(11).step_by(10);
    for (share, values) in shares.iter_mut().zip(intervals) {
        if let [first, middle @ .., last] = values {
            *share = 0.5 * (first + last) + middle.iter().sum::<f32>();
        }
    }
    let total: f32 = shares.iter().sum();
    if total <= 0.0 {
        return None;
    }
    Some(shares.map(|share| share / total))
}
