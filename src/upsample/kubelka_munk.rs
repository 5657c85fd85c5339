//! Paints mixed in a pot, after Kubelka and Munk.

use crate::grid::Bands;
use crate::math::sqrt;
use crate::spectrum::{Factor, Spectrum};

/// The reflectance of opaque paints, each within 0..=1, mixed in these shares (any scale, none below zero,
/// together below 1e38).
///
/// At each wavelength the ratio of absorption to scattering, (1 - R)^2 / 2R, is averaged by share: one
/// constant, all paints scatter alike. Blue and yellow make green, where averaging the reflectances makes
/// gray. Mixing nothing is NaN; a share of an ideal black makes black.
///
/// # Accuracy
/// 3e-7 relative for reflectances within 0.001..=1; one paint, or the same one twice, comes back so.
///
/// # Reference
/// P. Kubelka, F. Munk, "Ein Beitrag zur Optik der Farbanstriche", Z. techn. Physik 12 (1931).
///
/// ```
/// use nanospectra::{Reflectance, upsample::kubelka_munk};
/// let (white, black) = (Reflectance::<16>::flat(1.0), Reflectance::<16>::flat(0.04));
/// let gray = kubelka_munk(&[(0.99, &white), (0.01, &black)]);
/// assert!(gray.values()[7] < 0.72); // a hundredth of black takes a quarter of the light
/// ```
#[must_use]
pub fn kubelka_munk<const N: usize, G: Bands>(
    paints: &[(f32, &Spectrum<Factor, N, G>)],
) -> Spectrum<Factor, N, G> {
    let (mut ratios, mut whole) = ([0.0; N], 0.0);
    for (share, paint) in paints {
        // Nothing of a black paint, 0 times infinity, is nothing.
        if *share != 0.0 {
            whole += share;
            for (ratio, r) in ratios.iter_mut().zip(paint.values()) {
                *ratio += share * ((1.0 - r) * (1.0 - r) / (2.0 * r));
            }
        }
    }
    // R = 1 + k - sqrt(k^2 + 2k) without the cancellation.
    Spectrum::from_bins(ratios.map(|ratio| {
        let k = ratio / whole;
        1.0 / (1.0 + k + sqrt(k) * sqrt(k + 2.0))
    }))
}
