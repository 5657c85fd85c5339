//! Planck's law, in forms that hold in f32 from 1 K to 1e12 K.

#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::math::{Math, at_most};

/// The first radiation constant for radiance, 2 h c^2, in W m-2 sr-1 nm-1 (1024 nm)^5 (CODATA 2018).
const C1_1024: f32 = 105_785.87;
/// The second radiation constant, h c / k, in nm K (CODATA 2018; the exact number is 0.22 less).
const C2_NM: f32 = 14_387_769.0;
/// The second radiation constant by which color temperatures are defined (ITS-90), in nm K; it is 1.6e-5
/// higher, relative.
#[cfg(feature = "libm")]
pub(crate) const C2_COLOR_NM: f32 = 14_388_000.0;
/// Stefan's constant, W m-2 K-4.
const SIGMA: f32 = 5.670_374_4e-8;
/// Wien's displacement constant, nm K.
const WIEN_NM_K: f32 = 2_897_771.955;

/// Returns the spectral radiance of a black body at a vacuum wavelength `nm`, in W m-2 sr-1 nm-1.
///
/// Its temperature is `kelvin`, in K. The constants are those of CODATA 2018, with which
/// [`cct`](crate::color::Uv1960::cct) reads 1.6e-5 above `kelvin`, because color temperatures are defined by
/// an older constant.
///
/// # Accuracy
/// (3 x + 9) units of 2^-24, where x = hc / (lambda k T), which is what the rounding of `nm` and `kelvin`
/// costs anyway. This holds for every `nm` and `kelvin` above 0. A radiance below 1e-38 is returned as 0, as
/// is that of 0 K or at 0 nm. A negative `nm` or `kelvin` gives NaN.
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

/// Returns the spectral radiance of a black body as [`blackbody`] does, computed by the math backend
/// `M`.
///
/// ```
/// # use nanospectra::{light::blackbody_with, math::Fast};
/// // The sun's surface at the peak of vision: 25.6 kW m-2 sr-1 nm-1.
/// assert!((blackbody_with::<Fast>(555.0, 5772.0) / 1e3 - 25.63).abs() < 0.01);
/// ```
#[must_use]
pub fn blackbody_with<M: Math>(nm: f32, kelvin: f32) -> f32 {
    // In units of 1024 nm, near the micrometer, the fifth power stays in range from x-rays to radio. A unit
    // that is a power of two causes no rounding, which would count five times.
    let length = nm * (1.0 / 1024.0);
    let x = C2_NM / (nm * kelvin);
    if !(1e-6..1e6).contains(&length) || !(1e-30..1e30).contains(&x) {
        return far_radiance::<M>(length, kelvin);
    }
    let scale = C1_1024 / (length * length * length * length * length);
    if x > 80.0 {
        // e^x overflows at 88.7. Two factors, each with half the exponent, reach down to 1e-38.
        let half = M::exp(-0.5 * x);
        return flushed(scale * half * half);
    }
    scale / M::expm1(x)
}

/// Computes the radiance at wavelengths whose fifth power is out of range, or where x is.
#[cold]
fn far_radiance<M: Math>(length: f32, kelvin: f32) -> f32 {
    if length < 0.0 || kelvin < 0.0 {
        return f32::NAN;
    }
    if length == 0.0 || kelvin == 0.0 {
        return length * kelvin; // 0, or NaN
    }
    let x = C2_NM / 1024.0 / length / kelvin;
    if x > 80.0 {
        // The radiance is C1 (e^(-x/5) / length)^5, where e^(-x/5) may itself be out of range.
        let tenth = M::exp(-0.1 * x);
        let fifth = if tenth == 0.0 { 0.0 } else { tenth / length * tenth };
        return flushed(C1_1024 * (fifth * fifth) * (fifth * fifth) * fifth);
    }
    // The quotients rise or fall towards the result, so that none is out of range if the result is not. For
    // the smallest x, e^x - 1 is x, and its product with the length depends on the temperature alone.
    let first = if x < 1e-20 { C1_1024 / (C2_NM / 1024.0) * kelvin } else { C1_1024 / M::expm1(x) / length };
    flushed(first / length / length / length / length)
}

/// Returns a radiance, or 0 where too few digits of it are left.
fn flushed(value: f32) -> f32 {
    if value < 1e-38 { 0.0 } else { value }
}

/// Returns the radiance of a black body at `nm` relative to that at 560 nm.
///
/// This is the shape of the spectrum of a black body of the temperature `kelvin`, also where both radiances
/// are too small for f32.
///
/// ```
/// use nanospectra::light::{A, blackbody_relative};
///
/// // Illuminant A is the black body of 2856 K, in the constants of its time.
/// let at_700_nm = A.values()[700 - 300] / A.values()[560 - 300];
/// assert!((blackbody_relative(700.0, 2856.0) / at_700_nm - 1.0).abs() < 1e-3);
/// ```
///
/// # Accuracy
/// (4 |dx| + 14) units of 2^-24, where dx is the difference of hc / (lambda k T) to its value at 560 nm. This
/// holds for every `nm` and `kelvin` above 0. The result is 0 or infinite only where the ratio itself is
/// beyond f32, which happens at temperatures below 300 K. A negative `nm` or `kelvin` gives NaN.
#[cfg(feature = "libm")]
#[must_use]
pub fn blackbody_relative(nm: f32, kelvin: f32) -> f32 {
    relative::<Portable>(nm, kelvin, C2_NM)
}

/// Returns the relative radiance of a black body as [`blackbody_relative`] does, computed by the math backend
/// `M`. See the [example](blackbody_with) of `blackbody_with`.
#[must_use]
pub fn blackbody_relative_with<M: Math>(nm: f32, kelvin: f32) -> f32 {
    relative::<M>(nm, kelvin, C2_NM)
}

/// Computes as [`blackbody_relative`] does, with another second radiation constant, in nm K.
pub(crate) fn relative<M: Math>(nm: f32, kelvin: f32, c2_nm: f32) -> f32 {
    let ratio = 560.0 / nm;
    let (x, x560) = (c2_nm / (nm * kelvin), c2_nm / (560.0 * kelvin));
    let dx = c2_nm / 560.0 * (nm - 560.0) / (nm * kelvin);
    let is_usual = |x| (1e-30..1e30).contains(&x);
    if !(1e-6..1e6).contains(&ratio) || !is_usual(x) || !is_usual(x560) || !(-80.0..80.0).contains(&dx) {
        return far_relative::<M>(nm, c2_nm / kelvin);
    }
    // B = l^-5 e^-x / (1 - e^-x), and the quotient of the two exponentials e^-x is e^dx.
    ratio * ratio * ratio * ratio * ratio * (M::expm1(-x560) / M::expm1(-x)) * M::exp(dx)
}

/// Computes the relative radiance where one of its factors may be out of range and their product is not.
/// `length` is c2 / T, in nm.
#[cold]
fn far_relative<M: Math>(nm: f32, length: f32) -> f32 {
    if nm < 0.0 || length < 0.0 {
        return f32::NAN;
    }
    if nm == 0.0 {
        return nm * at_most(length, f32::MAX); // 0, or NaN
    }
    let (ratio, length) = (560.0 / nm, at_most(length, f32::MAX));
    let (x, x560) = (length / nm, length / 560.0);
    // The quotient of both 1 - e^-x, times the ratio: 1 where both x are small, the ratio where they are
    // large.
    let planck = if x < 1e-20 { -M::expm1(-x560) / x560 } else { M::expm1(-x560) / M::expm1(-x) * ratio };
    let dx = x560 * ((nm - 560.0) / nm);
    // What remains is ratio^4 e^dx. Its square root is in range where the result is.
    if dx.abs() < 80.0 {
        let square = ratio * ratio;
        return square * M::exp(dx) * planck * square;
    }
    let eighth = M::exp(0.125 * dx);
    let fourth = if eighth == 0.0 { 0.0 } else { ratio * eighth * eighth };
    let square = fourth * fourth;
    if square == 0.0 { 0.0 } else { square * planck * square }
}

/// Returns the radiant exitance of a black body of the temperature `kelvin`, sigma T^4, in W/m2.
///
/// ```
/// # use nanospectra::light::blackbody_exitance;
/// // The sun's surface: 62.9 MW/m2.
/// assert!((blackbody_exitance(5772.0) / 1e6 - 62.94).abs() < 0.01);
/// ```
#[must_use]
pub fn blackbody_exitance(kelvin: f32) -> f32 {
    let square = kelvin * kelvin;
    SIGMA * square * square
}

/// Returns the wavelength at which a black body of the temperature `kelvin` radiates most per nm, in nm.
///
/// This is Wien's displacement law, by which the peak of the sun lies at 502 nm.
///
/// ```
/// # use nanospectra::light::blackbody_peak_nm;
/// assert!((blackbody_peak_nm(5772.0) - 502.0).abs() < 0.1);
/// ```
#[must_use]
pub fn blackbody_peak_nm(kelvin: f32) -> f32 {
    WIEN_NM_K / kelvin
}
