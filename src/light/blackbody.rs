//! Planck's law, in forms that hold in f32 from 1 K to 1e12 K.

use crate::math::Math;
#[cfg(feature = "libm")]
use crate::math::Portable;

/// First radiation constant for radiance, 2 h c^2, in W um^4 m-2 sr-1 per nm (CODATA 2018, exact).
const C1_UM: f32 = 1.191_042_97e5;
/// Second radiation constant, h c / k, in um K (CODATA 2018, exact).
const C2_UM: f32 = 14_387.768_8;
/// The value that colour temperatures are defined with (ITS-90), in um K: 1.6e-5 higher.
#[cfg(feature = "libm")]
pub(crate) const C2_COLOR_UM: f32 = 14_388.0;
/// Stefan's constant, W m-2 K-4.
const SIGMA: f32 = 5.670_374_4e-8;
/// Wien's displacement constant, nm K.
const WIEN_NM_K: f32 = 2_897_771.955;

/// Spectral radiance of a black body of temperature `kelvin` at `nm` (vacuum), in W m-2 sr-1 nm-1.
///
/// By today's constants; [`cct`](crate::color::Uv1960::cct) of it therefore reads 1.6e-5 above `kelvin`.
///
/// # Accuracy
/// (3 x + 8) units of 2^-24, where x = hc / (lambda k T): what the rounding of `nm` and `kelvin` costs
/// anyway. Below 1e-38 it is 0.
///
/// # Reference
/// CODATA 2018.
///
/// ```
/// # use nanospectra::light::blackbody;
/// // The sun's surface at the peak of vision: 25.6 kW m-2 sr-1 nm-1.
/// assert!((blackbody(555.0, 5772.0) / 1e3 - 25.63).abs() < 0.01);
/// ```
#[cfg(feature = "libm")]
#[must_use]
pub fn blackbody(nm: f32, kelvin: f32) -> f32 {
    blackbody_with::<Portable>(nm, kelvin)
}

/// [`blackbody`] on another maths backend.
#[must_use]
pub fn blackbody_with<M: Math>(nm: f32, kelvin: f32) -> f32 {
    // Micrometres keep the fifth power in range from gamma rays to radio.
    let um = nm * 1e-3;
    let x = C2_UM / (um * kelvin);
    let scale = C1_UM / (um * um * um * um * um);
    if x > 80.0 {
        // e^x overflows at 88.7: two halves reach down to 1e-38.
        let half = M::exp(-0.5 * x);
        let value = scale * half * half;
        return if value < 1e-38 { 0.0 } else { value };
    }
    scale / M::expm1(x)
}

/// The radiance at `nm` over that at 560 nm: the shape of a black body, also where both are too
/// small for f32.
///
/// # Accuracy
/// (|dx| + 8) units of 2^-24 with dx the difference of hc / (lambda k T) to 560 nm; 0 or infinite
/// where the ratio itself is beyond f32 (some K).
#[cfg(feature = "libm")]
#[must_use]
pub fn blackbody_relative(nm: f32, kelvin: f32) -> f32 {
    relative::<Portable>(nm, kelvin, C2_UM)
}

/// [`blackbody_relative`] on another maths backend.
#[must_use]
pub fn blackbody_relative_with<M: Math>(nm: f32, kelvin: f32) -> f32 {
    relative::<M>(nm, kelvin, C2_UM)
}

/// As [`blackbody_relative`], with the second radiation constant in um K.
pub(crate) fn relative<M: Math>(nm: f32, kelvin: f32, c2_um: f32) -> f32 {
    let (um, ratio) = (nm * 1e-3, 560.0 / nm);
    let (x, x560) = (c2_um / (um * kelvin), c2_um / (0.56 * kelvin));
    let dx = c2_um * ((nm - 560.0) * 1e-3) / (0.56 * um * kelvin);
    // B(x) = l^-5 e^-x / (1 - e^-x), and the quotient of the exponentials is e^dx.
    ratio * ratio * ratio * ratio * ratio * (M::expm1(-x560) / M::expm1(-x)) * M::exp(dx)
}

/// Radiant exitance of a black body, sigma T^4, in W/m2.
#[must_use]
pub fn blackbody_exitance(kelvin: f32) -> f32 {
    let square = kelvin * kelvin;
    SIGMA * square * square
}

/// The wavelength at which a black body radiates most per nm, in nm (Wien): 501.9 nm for the sun.
#[must_use]
pub fn blackbody_peak_nm(kelvin: f32) -> f32 {
    WIEN_NM_K / kelvin
}
