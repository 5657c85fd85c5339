//! Counts light in photons, which is what drives photosynthesis.

use crate::spectrum::{Fine, Power};

/// The constant h c N_A, in J nm / umol: one umol of photons carries this over their wavelength.
const J_NM_PER_UMOL: f32 = 119.626_566;

/// Returns the photosynthetic photon flux density (PPFD), in umol/(m2 s), of a spectral irradiance in W/(m2
/// nm).
///
/// It counts the photons of 400..=700 nm in 1 nm steps, with both ends included, by their wavelengths in
/// vacuum.
///
/// # Example
/// ```
/// # use nanospectra::{Fine, radiometry::ppfd};
/// let mut red = Fine::flat(0.0);
/// let _ = red.add_line(660.0, 1.0);
/// assert!((ppfd(&red) - 5.517).abs() < 1e-3); // 660 / 119.6266
/// ```
#[must_use]
pub fn ppfd(light: &Fine<Power>) -> f32 {
    let mut photons = light.within(400.0, 700.0);
    for (k, value) in photons.values_mut().iter_mut().enumerate() {
        *value *= Fine::<Power>::center_nm(k);
    }
    photons.power() / J_NM_PER_UMOL
}
