//! Photometry, which weights power by the sensitivity of the eye.

use crate::observer::{KM, KM_SCOTOPIC, V_PHOTOPIC, V_SCOTOPIC};
use crate::spectrum::{Fine, Power};

/// Returns the illuminance, in lx, of a spectral irradiance in W/(m2 nm).
///
/// It is 683.002 lm/W times the sum of the spectrum with V(lambda) in 1 nm steps. The same sum makes lm of
/// W/nm, cd of W/(sr nm), and cd/m2 of W/(m2 sr nm). With
/// [`Irradiance::luminous`](crate::radiometry::Irradiance::luminous) and its siblings the result has a unit.
///
/// # Reference
/// CIE 18:2019.
///
/// # Example
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

/// Returns the scotopic illuminance, in scotopic lx, of a spectral irradiance in W/(m2 nm).
///
/// It is what [`illuminance`] is for the dark-adapted eye: 1700 lm/W times the sum with V'(lambda).
///
/// # Reference
/// CIE 18:2019.
///
/// # Example
/// ```
/// # use nanospectra::{Fine, radiometry::scotopic_illuminance};
/// let mut cyan = Fine::flat(0.0);
/// let _ = cyan.add_line(507.0, 1.0); // 1 W/m2 at the peak of night vision
/// assert!((scotopic_illuminance(&cyan) / 1700.0 - 1.0).abs() < 1e-3);
/// ```
#[must_use]
pub fn scotopic_illuminance(light: &Fine<Power>) -> f32 {
    let [sum] = V_SCOTOPIC.sees(light);
    KM_SCOTOPIC * sum
}

/// Returns the luminous efficacy of radiation, in lm/W, of a spectrum on any scale.
///
/// It counts the lumens for each watt between 360 and 830 nm. Returns `None` if the spectrum has no power.
///
/// # Example
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
