//! The reference lights of color rendering: a black body, daylight, or in between.

use crate::color::{Cct, Xyz};
use crate::light::{C2_COLOR_NM, blackbody_shape, daylight_at};
use crate::math::Portable;
use crate::observer::CIE_1931;
use crate::spectrum::{Fine, Power, Spectrum};
use core::fmt;

/// The reason why the color rendering of a light cannot be computed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum RenderingError {
    /// The light has no visible power, or it holds a NaN.
    Dark,
    /// The light or a sample under it has tristimulus values that no real color has, as from a negative
    /// spectrum.
    Unreal,
    /// The light is not a white: it has no color temperature, for the reason given, and so no reference.
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

/// CCT and Duv of a light for which rendering is asked.
pub(super) fn temperature(light: &Fine<Power>) -> Result<(f32, f32), RenderingError> {
    let xyz = Xyz::from(CIE_1931.sees(light));
    let uv = xyz.uv1960().ok_or(RenderingError::Dark)?;
    match uv.cct() {
        Cct::Near { cct_k, duv } if cct_k.is_finite() => Ok((cct_k, duv)),
        Cct::Near { .. } => Err(RenderingError::Dark),
        outcome => Err(RenderingError::NoReference(outcome)),
    }
}

/// A black body of color temperature `cct_k`, 1 at 560 nm (c2 = 1.4388e-2 m K).
pub(super) fn planckian(cct_k: f32) -> Fine<Power> {
    Spectrum::at_centers(|nm| blackbody_shape::<Portable>(nm, cct_k, C2_COLOR_NM))
}

/// CIE daylight, 100 at 560 nm; straight between its 5 nm nodes.
pub(super) fn daylight(cct_k: f32) -> Fine<Power> {
    daylight_at(cct_k).fine()
}
