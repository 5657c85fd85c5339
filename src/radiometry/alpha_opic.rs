//! What light does to the five photoreceptors, beyond vision (CIE S 026).

use crate::light::D65;
use crate::observer::{ALPHA_OPIC, KM, V_PHOTOPIC};
use crate::radiometry::illuminance;
use crate::spectrum::{Fine, Power};

/// One number for each of the five alpha-opic responses of CIE S 026.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AlphaOpic {
    /// Short wavelength cones.
    pub s_cone: f32,
    /// Middle wavelength cones.
    pub m_cone: f32,
    /// Long wavelength cones.
    pub l_cone: f32,
    /// Rods.
    pub rhodopic: f32,
    /// Melanopsin in the ganglion cells that set the body's clock.
    pub melanopic: f32,
}

/// Efficacy of luminous radiation of D65 for each response, W/lm, from the tables: sums over
/// 380..=780 nm, 683.002 lm/W.
static D65_W_PER_LM: [f32; 5] = {
    let d65: Fine<Power> = D65.fine();
    let alpha = ALPHA_OPIC.under(&d65).row_sums();
    let luminous = KM as f64 * V_PHOTOPIC.under(&d65.within(380.0, 780.0)).row_sums()[0];
    let mut ratios = [0.0; 5];
    let mut k = 0;
    while k < 5 {
        ratios[k] = (alpha[k] / luminous) as f32;
        k += 1;
    }
    ratios
};

impl AlphaOpic {
    /// Alpha-opic irradiances, W m-2, of a spectral irradiance in W m-2 nm-1.
    ///
    /// # Reference
    /// CIE S 026/E:2018; the 1 nm tables, 380..=780 nm.
    #[must_use]
    pub fn new(light: &Fine<Power>) -> Self {
        Self::from_array(ALPHA_OPIC.sees(light))
    }

    /// Equivalent daylight illuminances, lx: how much D65 would do the same. For irradiances.
    #[must_use]
    pub fn edi(self) -> Self {
        let mut lux = self.to_array();
        for (value, d65) in lux.iter_mut().zip(&D65_W_PER_LM) {
            *value /= d65;
        }
        Self::from_array(lux)
    }

    /// Daylight efficacy ratios of a spectrum, on any scale: equivalent daylight illuminance over
    /// illuminance, both of 380..=780 nm; 1 for D65. `None` if nothing is visible.
    #[must_use]
    pub fn der(light: &Fine<Power>) -> Option<Self> {
        let lux = illuminance(&light.within(380.0, 780.0));
        (lux > 0.0).then(|| Self::from_array(Self::new(light).edi().to_array().map(|edi| edi / lux)))
    }

    /// S cones, M cones, L cones, rods, melanopsin.
    #[must_use]
    pub const fn to_array(self) -> [f32; 5] {
        [self.s_cone, self.m_cone, self.l_cone, self.rhodopic, self.melanopic]
    }

    /// From what an observer folded from [`ALPHA_OPIC`] reports: the way for a device with few bands.
    ///
    /// ```
    /// # use nanospectra::{Curve, Light, Observer, Power, observer::ALPHA_OPIC, radiometry::AlphaOpic};
    /// static EYE: Observer<5, 16, Power> = ALPHA_OPIC.fold(Curve::Step);
    /// let flat = AlphaOpic::from_array(EYE.sees(&Light::flat(0.001)));
    /// assert!(flat.edi().melanopic > 50.0);
    /// ```
    #[must_use]
    pub const fn from_array([s_cone, m_cone, l_cone, rhodopic, melanopic]: [f32; 5]) -> Self {
        AlphaOpic { s_cone, m_cone, l_cone, rhodopic, melanopic }
    }
}
