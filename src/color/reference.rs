//! The reference lights of color rendering: a black body, daylight, or in between.

use crate::color::{Cct, Xyz};
use crate::light::{C2_COLOR_NM, blackbody_shape, daylight_at};
use crate::math::Portable;
use crate::observer::CIE_1931;
use crate::spectrum::{Fine, Power, Spectrum};
use core::fmt;

/// Why a light has no color rendering.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum RenderingError {
    /// It has no visible power, or is not a number.
    Dark,
    /// Under it a sample, or the light itself, has no place among real colors: it has negative values.
    Unreal,
    /// It is no kind of white, so there is no reference of the same color temperature.
    NoReference(Cct),
}

impl fmt::Display for RenderingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Dark => "the light has no visible power",
            Self::Unreal => "under this light a sample has no real color (negative values?)",
            Self::NoReference(Cct::TooCold) => "the light is redder than 1000 K: there is no reference",
            Self::NoReference(Cct::TooHot) => "the light is bluer than 1000000 K: there is no reference",
            Self::NoReference(_) => "the light is more than 0.05 (Duv) from the Planckian locus: not a white",
        })
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
