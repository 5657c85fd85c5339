//! Colorimetry: chromaticity, correlated color temperature, CIELAB, color differences, RGB, color rendering.

mod adaptation;
#[cfg(feature = "libm")]
mod cam02ucs;
mod cct;
mod ciede2000;
#[cfg(feature = "libm")]
mod cri;
mod difference;
mod dominant;
mod gamut;
mod lab;
mod luv;
pub(crate) mod matrix;
mod oklab;
#[cfg(feature = "libm")]
mod reference;
mod rgb;
mod rgb_bands;
mod rgb_space;
#[cfg(feature = "libm")]
mod test_colors;
#[cfg(feature = "libm")]
mod tm30;
pub mod transfer;

pub use crate::tristimulus::{Uv1960, Uv1976, Xy, Xyz};
pub use adaptation::{Adaptation, Bradford, Cat02, Cat16, ConeResponses, VonKries};
pub use cct::Cct;
#[cfg(feature = "libm")]
pub use ciede2000::ciede2000;
pub use ciede2000::{ParametricFactors, ciede2000_with};
#[cfg(feature = "libm")]
pub use cri::{Cri, cri};
pub use difference::{Cie94Weights, cie76, cie94, cmc, hyab};
pub use dominant::{DominantWavelength, dominant_wavelength};
pub use gamut::GamutMapped;
pub use lab::{Lab, Lch};
pub use luv::Luv;
pub use oklab::Oklab;
#[cfg(feature = "libm")]
pub use reference::RenderingError;
pub use rgb::{EncodedRgb, Rgb};
pub use rgb_bands::RgbBands;
pub(crate) use rgb_space::to_xyz64;
pub use rgb_space::{AcesCg, AdobeRgb, Bt2020, DisplayP3, RgbSpace, Srgb};
#[cfg(feature = "libm")]
pub use tm30::{HueBin, Tm30, tm30};
