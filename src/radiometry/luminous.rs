//! Photometry: power weighted by what the eye makes of it.

use crate::observer::{KM, KM_SCOTOPIC, V_PHOTOPIC, V_SCOTOPIC};
use crate::spectrum::{Fine, Power};

/// Luminous quantity of a spectral power: lx for W m-2 nm-1, lm for W nm-1, cd m-2 for radiance.
///
/// 683.002 lm/W times the 1 nm sum with V(lambda).
///
/// # Reference
/// CIE 18:2019.
///
/// ```
/// # use nanospectra::{Fine, radiometry::illuminance};
/// let mut green = Fine::flat(0.0);
/// let _ = green.add_line(555.0, 1.0); // 1 W/m2 at the peak of vision
/// assert!((illuminance(&green) - 683.002).abs() < 1e-3);
/// ```
#[must_use]
pub fn illuminance(light: &Fine<Power>) -> f32 {
    let [sum] = V_PHOTOPIC.sees(light);
    KM * sum
}

/// As [`illuminance`] for the dark-adapted eye: 1700 lm/W times the sum with V'(lambda).
#[must_use]
pub fn scotopic_illuminance(light: &Fine<Power>) -> f32 {
    let [sum] = V_SCOTOPIC.sees(light);
    KM_SCOTOPIC * sum
}

/// Luminous efficacy of the radiation, lm/W: light for each watt between 360 and 830 nm; `None`
/// if there is no power.
///
/// ```
/// # use nanospectra::{light::D65, radiometry::luminous_efficacy};
/// let d65 = D65.fine();
/// assert!(luminous_efficacy(&d65).is_some_and(|ler| (ler - 184.17).abs() < 0.01));
/// ```
#[must_use]
pub fn luminous_efficacy(light: &Fine<Power>) -> Option<f32> {
    let power = light.power();
    if power <= 0.0 { None } else { Some(illuminance(light) / power) }
}
