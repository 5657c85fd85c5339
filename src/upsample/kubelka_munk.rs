//! The reflectance of mixed paints, after Kubelka and Munk.

use crate::grid::Bands;
use crate::math::sqrt;
use crate::spectrum::{Factor, Spectrum};

/// Returns the reflectance of a mixture of opaque paints, after Kubelka and Munk.
///
/// Each paint is given by its share and its reflectance, which lies within 0..=1. Shares may have any scale;
/// none is below zero, and their sum is below 1e38. If there is no paint or no share, the result is NaN.
///
/// At each wavelength the ratio of absorption to scattering, (1 - R)^2 / 2R, is averaged in proportion to the
/// shares, as if all paints scattered light alike (the single-constant form of the theory). So blue and
/// yellow make green, where the average of their reflectances would be gray. Any share of an ideal black
/// makes black.
///
/// # Accuracy
/// The result is within 5e-7, relative, for reflectances within 1e-20..=1. A single paint, or the same paint
/// twice, has its own reflectance within that.
///
/// # Reference
/// P. Kubelka, F. Munk, "Ein Beitrag zur Optik der Farbanstriche", Z. techn. Physik 12 (1931).
///
/// # Example
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
        // A share of 0 adds nothing, also of a black paint, for which 0 times infinity would be NaN.
        if *share != 0.0 {
            whole += share;
            for (ratio, r) in ratios.iter_mut().zip(paint.values()) {
                *ratio += share * ((1.0 - r) * (1.0 - r) / (2.0 * r));
            }
        }
    }
    // This is R = 1 + k - sqrt(k^2 + 2k), written without the cancellation.
    Spectrum::from_bins(ratios.map(|ratio| {
        let k = ratio / whole;
        1.0 / (1.0 + k + sqrt(k) * sqrt(k + 2.0))
    }))
}
