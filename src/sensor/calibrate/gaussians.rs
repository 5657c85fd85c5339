//! Responsivities from peaks and widths.

use crate::grid::{Grid, Layout};
use crate::math::const_for;
use crate::observer::Observer;
use crate::spectrum::Power;

/// Makes Gaussian channels on any grid from (peak, full width at half maximum), both in nm, each 1 at its
/// peak.
///
/// On bins wider than a few nanometers these are values at the centers and not averages: make them on 1 nm
/// and [`fold`](Observer::fold). It computes in f64 and is meant for constants.
///
/// ```
/// # use nanospectra::{Nodes, Observer, Power, sensor::gaussian_responsivities};
/// static MINE: Observer<2, 701, Power, Nodes<300, 1000>> =
///     gaussian_responsivities([(450.0, 40.0), (850.0, 60.0)]);
/// assert!((MINE.weights()[0][170] - 0.5).abs() < 1e-6); // 470 nm: half of the peak
/// ```
#[must_use]
pub const fn gaussian_responsivities<const C: usize, const N: usize, G: Grid>(
    channels: [(f64, f64); C],
) -> Observer<C, N, Power, G> {
    let mut rows = [[0.0; N]; C];
    const_for!(0..C, |c| {
        let (peak, fwhm) = channels[c];
        const_for!(0..N, |k| {
            let widths = (Layout::<G, N>::center(k) as f64 - peak) / fwhm;
            // 16^(-(d/fwhm)^2) is a half at d = fwhm / 2.
            rows[c][k] = exp2_below_zero(-4.0 * widths * widths) as f32;
        });
    });
    Observer::from_rows(rows)
}

/// Computes 2^x for x <= 0 in `const fn`, where results below 2^-40 become 0.
const fn exp2_below_zero(x: f64) -> f64 {
    if x < -40.0 {
        return 0.0;
    }
    // 2^x = (2^(x/64))^64; the series of e^t for |t| <= 0.44 ends below 1e-16 after 13 terms.
    let t = x / 64.0 * core::f64::consts::LN_2;
    let (mut sum, mut n) = (1.0, 13);
    while n > 0 {
        sum = 1.0 + sum * t / n as f64;
        n -= 1;
    }
    const_for!(0..6, |squarings| sum *= sum);
    sum
}
