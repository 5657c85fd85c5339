//! Computes how strongly light stimulates the five photoreceptors of the eye (CIE S 026).

use crate::light::D65;
use crate::observer::{ALPHA_OPIC, KM, V_PHOTOPIC};
use crate::radiometry::illuminance;
use crate::spectrum::{Fine, Power};

/// Five numbers that say how strongly light stimulates each kind of photoreceptor of the eye, by CIE S 026.
///
/// They are irradiances from [`new`](Self::new), illuminances from [`edi`](Self::edi), and ratios from
/// [`der`](Self::der).
///
/// Start with [`new`](Self::new) for a spectrum with 1 nm steps, or with [`from_array`](Self::from_array) for
/// a device with few bands, and call [`edi`](Self::edi) for the melanopic equivalent daylight illuminance
/// (melanopic EDI) that lighting recommendations state.
///
/// # Example
/// ```
/// use nanospectra::{light, radiometry::{AlphaOpic, illuminance}};
///
/// // Incandescent light of 500 lx.
/// let relative = light::A.fine();
/// let lamp = relative * (500.0 / illuminance(&relative));
/// let alpha = AlphaOpic::new(&lamp); // in W/m2
///
/// // Its melanopic EDI is 248 lx of daylight, because its melanopic DER is 0.496.
/// assert!((alpha.edi().melanopic - 248.0).abs() < 0.25);
/// assert!(AlphaOpic::der(&lamp).is_some_and(|ratio| (ratio.melanopic - 0.496).abs() < 5e-4));
/// assert_eq!(alpha.to_array()[4], alpha.melanopic);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AlphaOpic {
    /// The S-cone-opic number, for the cones that are sensitive to short wavelengths.
    pub s_cone: f32,
    /// The M-cone-opic number, for the cones that are sensitive to middle wavelengths.
    pub m_cone: f32,
    /// The L-cone-opic number, for the cones that are sensitive to long wavelengths.
    pub l_cone: f32,
    /// The rhodopic number, for the rods, which see in dim light.
    pub rhodopic: f32,
    /// The melanopic number, for the ganglion cells that contain melanopsin and set the body's clock. See the
    /// [example](Self#example).
    pub melanopic: f32,
}

/// The alpha-opic efficacy of luminous radiation of D65 for each response, in W/lm.
///
/// Both sums are taken over 380..=780 nm, with 683.002 lm/W.
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
    /// Returns the alpha-opic irradiances, in W/m2, of a spectral irradiance in W/(m2 nm).
    ///
    /// See the [example](Self#example).
    ///
    /// # Reference
    /// CIE S 026/E:2018, with its tables in 1 nm steps over 380..=780 nm.
    #[must_use]
    pub fn new(light: &Fine<Power>) -> Self {
        Self::from_array(ALPHA_OPIC.sees(light))
    }

    /// Returns the alpha-opic equivalent daylight illuminances (EDI), in lx, of alpha-opic irradiances in
    /// W/m2.
    ///
    /// Each of them is the illuminance of D65 that would stimulate the receptor as strongly. See the
    /// [example](Self#example).
    #[must_use]
    pub fn edi(self) -> Self {
        let mut lux = self.to_array();
        for (value, d65) in lux.iter_mut().zip(&D65_W_PER_LM) {
            *value /= d65;
        }
        Self::from_array(lux)
    }

    /// Returns the alpha-opic daylight efficacy ratios (DER) of a spectrum, which may be on any scale.
    ///
    /// A ratio is the equivalent daylight illuminance over the illuminance, both of 380..=780 nm, and is 1
    /// for D65. Returns `None` if the spectrum has no illuminance. See the [example](Self#example).
    ///
    /// # Cost
    /// On a Cortex-M4F it takes 2,100 bytes of stack at opt-level 3 and at "s".
    #[must_use]
    pub fn der(light: &Fine<Power>) -> Option<Self> {
        let lux = illuminance(&light.within(380.0, 780.0));
        (lux > 0.0).then(|| Self::from_array(Self::new(light).edi().to_array().map(|edi| edi / lux)))
    }

    /// Returns the five numbers in the order S cones, M cones, L cones, rods, melanopsin.
    ///
    /// See the [example](Self#example).
    #[must_use]
    pub const fn to_array(self) -> [f32; 5] {
        [self.s_cone, self.m_cone, self.l_cone, self.rhodopic, self.melanopic]
    }

    /// Makes alpha-opic irradiances of the five numbers that an observer folded from [`ALPHA_OPIC`] returns.
    ///
    /// Use this for a device with few bands: [`fold`](crate::Observer::fold) reduces the 1 nm tables of
    /// [`ALPHA_OPIC`] to those bands.
    ///
    /// # Example
    /// ```
    /// # use nanospectra::{Curve, Fine, Light, Observer, Power, observer::ALPHA_OPIC, radiometry::AlphaOpic};
    /// static EYE: Observer<5, 16, Power> = ALPHA_OPIC.fold(Curve::Step);
    /// let flat = AlphaOpic::from_array(EYE.sees(&Light::flat(0.001))); // W/(m2 nm) in 16 bands
    /// let exact = AlphaOpic::new(&Fine::flat(0.001)); // the same light in 1 nm steps
    /// assert!((flat.edi().melanopic / exact.edi().melanopic - 1.0).abs() < 0.01);
    /// ```
    #[must_use]
    pub const fn from_array([s_cone, m_cone, l_cone, rhodopic, melanopic]: [f32; 5]) -> Self {
        AlphaOpic { s_cone, m_cone, l_cone, rhodopic, melanopic }
    }
}
