//! Light counted in photons, as plants do.

use crate::spectrum::{Fine, Power};

/// h c N_A in J nm / umol: one umol of photons of wavelength lambda carries this over lambda.
const J_NM_PER_UMOL: f32 = 119.626_566;

/// Photosynthetic photon flux density, umol m-2 s-1, of a spectral irradiance in W m-2 nm-1:
/// photons of 400..=700 nm, both ends counted (301 nodes), vacuum wavelengths.
///
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
