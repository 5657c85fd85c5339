//! Planck's law, in forms that hold in f32 from 1 K to 1e12 K.

use crate::math::Math;
#[cfg(feature = "libm")]
use crate::math::Portable;

/// First radiation constant for radiance, 2 h c^2, in W m-2 sr-1 nm-1 (1024 nm)^5 (CODATA 2018).
const C1_1024: f32 = 105_785.87;
/// Second radiation constant, h c / k, in nm K (CODATA 2018; the exact number is 0.22 less).
const C2_NM: f32 = 14_387_769.0;
/// The value that color temperatures are defined with (ITS-90), in nm K: 1.6e-5 higher.
#[cfg(feature = "libm")]
pub(crate) const C2_COLOR_NM: f32 = 14_388_000.0;
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

/// [`blackbody`] on another math backend.
#[must_use]
pub fn blackbody_with<M: Math>(nm: f32, kelvin: f32) -> f32 {
    // Units of 1024 nm: near the micrometer the fifth power stays in range from gamma rays to radio, and
    // a power of two costs no rounding, which would count five times.
    let length = nm * (1.0 / 1024.0);
    let x = C2_NM / (nm * kelvin);
    let scale = C1_1024 / (length * length * length * length * length);
    if x > 80.0 {
        // e^x overflows at 88.7: two halves reach down to 1e-38.
        let half = M::exp(-0.5 * x);
        if half == 0.0 {
            // Beyond gamma rays `scale` is infinite.
            return 0.0;
        }
        let value = scale * half * half;
        return if value < 1e-38 { 0.0 } else { value };
    }
    scale / M::expm1(x)
}

/// The radiance at `nm` over that at 560 nm: the shape of a black body, also where both are too
/// small for f32.
///
/// # Accuracy
/// (4 |dx| + 12) units of 2^-24 with dx the difference of hc / (lambda k T) to 560 nm; 0 or infinite
/// where the ratio itself is beyond f32 (some K).
#[cfg(feature = "libm")]
#[must_use]
pub fn blackbody_relative(nm: f32, kelvin: f32) -> f32 {
    relative::<Portable>(nm, kelvin, C2_NM)
}

/// [`blackbody_relative`] on another math backend.
#[must_use]
pub fn blackbody_relative_with<M: Math>(nm: f32, kelvin: f32) -> f32 {
    relative::<M>(nm, kelvin, C2_NM)
}

/// As [`blackbody_relative`], with the second radiation constant in nm K.
pub(crate) fn relative<M: Math>(nm: f32, kelvin: f32, c2_nm: f32) -> f32 {
    let ratio = 560.0 / nm;
    let (x, x560) = (c2_nm / (nm * kelvin), c2_nm / (560.0 * kelvin));
    let dx = c2_nm / 560.0 * (nm - 560.0) / (nm * kelvin);
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
