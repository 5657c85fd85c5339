//! The reference lights of color rendering: a black body, daylight, or a mixture of both.

use crate::color::{Cct, Xyz};
use crate::light::{C2_COLOR_NM, blackbody_shape, daylight_at};
use crate::math::Portable;
use crate::observer::CIE_1931;
use crate::spectrum::{Fine, Power, Spectrum};
use core::fmt;

/// The reason why the color rendering of a light cannot be computed.
///
/// [`cri`](crate::color::cri()) and [`tm30`](crate::color::tm30()) return it.
///
/// # Example
/// ```
/// use nanospectra::color::{Cct, RenderingError, cri};
/// use nanospectra::{Fine, Spectrum};
/// assert_eq!(cri(&Fine::flat(0.0)), Err(RenderingError::Dark));
///
/// // Green light has no color temperature, and so no reference light.
/// let green = Spectrum::at_centers(|nm| if (520.0..540.0).contains(&nm) { 1.0 } else { 0.0 });
/// assert_eq!(cri(&green), Err(RenderingError::NoReference(Cct::OffLocus)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum RenderingError {
    /// The light has no visible power, or it holds a NaN.
    ///
    /// See the [example](RenderingError#example).
    Dark,
    /// The light or a sample under it has tristimulus values that no real color has, as from a negative
    /// spectrum.
    Unreal,
    /// The light is not a white: it has no color temperature, for the reason given, and so no reference.
    ///
    /// See the [example](RenderingError#example).
    NoReference(Cct),
}

impl fmt::Display for RenderingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Dark => f.write_str("the light has no visible power"),
            Self::Unreal => f.write_str("under this light a sample has no real color (negative values?)"),
            Self::NoReference(cct) => write!(f, "there is no reference: the light is {cct}"),
        }
    }
}

impl core::error::Error for RenderingError {}

/// Returns the CCT and Duv of a light whose color rendering is wanted.
pub(super) fn temperature(light: &Fine<Power>) -> Result<(f32, f32), RenderingError> {
    let xyz = Xyz::from(CIE_1931.sees(light));
    let uv = xyz.uv1960().ok_or(RenderingError::Dark)?;
    match uv.fine_cct() {
        Cct::Near { cct_k, duv } if cct_k.is_finite() => Ok((cct_k, duv)),
        Cct::Near { .. } => Err(RenderingError::Dark),
        outcome => Err(RenderingError::NoReference(outcome)),
    }
}

/// Returns the light of a black body of color temperature `cct_k`, 1 at 560 nm (c2 = 1.4388e-2 m K).
pub(super) fn planckian(cct_k: f32) -> Fine<Power> {
    Spectrum::at_centers(|nm| blackbody_shape::<Portable>(nm, cct_k, C2_COLOR_NM))
}

/// Returns CIE daylight, 100 at 560 nm, interpolated linearly between its 5 nm nodes.
pub(super) fn daylight(cct_k: f32) -> Fine<Power> {
    daylight_at(cct_k).fine()
}
