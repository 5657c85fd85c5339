//! Counts light in photons, which is what drives photosynthesis.

use crate::spectrum::{Fine, Power};

/// The constant h c N_A, in J nm / umol: one umol of photons carries this over their wavelength.
const J_NM_PER_UMOL: f32 = 119.626_566;

/// Returns the photosynthetic photon flux density (PPFD), in umol/(m2 s), of a spectral irradiance in W/(m2
/// nm).
///
/// It is the [`photon_flux`] of 400 to 700 nm, by wavelengths in vacuum.
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
    photon_flux(light, 400.0, 700.0)
}

/// Returns the photons from one wavelength to another, in umol/(m2 s) for a spectral irradiance in W/(m2 nm), and
/// in umol/s for a flux in W/nm.
///
/// `from_nm` and `to_nm` are whole nanometers within 360..=830. The result is the integral of straight lines between
/// the nanometers, where both ends have half weight, so that bands beside each other share out what a wider band
/// has. It is 0 if `to_nm` is not above `from_nm`.
///
/// Bands in use are PPFD (400 to 700), ePAR (400 to 750) and blue, green, red and far red (100 nm each from 400 to
/// 800) by ANSI/ASABE S640. The R:FR ratio of Smith (1982) is that of 655..665 over 725..735 nm.
///
/// # Example
/// ```
/// # use nanospectra::{Fine, radiometry::photon_flux};
/// let flat = Fine::flat(1.0);
/// // The integral of the wavelength over h c N_A: (700^2 - 400^2) / 2 / 119.626566.
/// assert!((photon_flux(&flat, 400.0, 700.0) / 1379.2923 - 1.0).abs() < 1e-6);
/// ```
#[must_use]
pub fn photon_flux(light: &Fine<Power>, from_nm: f32, to_nm: f32) -> f32 {
    let mut photons = light.within(from_nm, to_nm);
    for (k, value) in photons.values_mut().iter_mut().enumerate() {
        let nm = Fine::<Power>::center_nm(k);
        let weight = if nm == from_nm || nm == to_nm { 0.5 } else { 1.0 };
        *value *= nm * weight;
    }
    if to_nm > from_nm { photons.power() / J_NM_PER_UMOL } else { 0.0 }
}
