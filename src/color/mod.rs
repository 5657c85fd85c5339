//! Computes what a color looks like from its tristimulus values, and how well a lamp renders colors from its
//! spectrum.
//!
//! Most calculations start from [`Xyz`], which an [`Observer`](crate::Observer) reports of light; only
//! [`cri()`], [`tm30()`] and [`ssi()`] take the spectrum itself.
//!
//! ```
//! use nanospectra::color::{Rgb, Srgb, Xyz};
//! use nanospectra::{light, observer::CIE_1931};
//!
//! // Daylight D65, on the scale on which it is its own white (Y = 100).
//! let white = Xyz::from(CIE_1931.sees(&light::D65.fine())).with_y(100.0).ok_or("dark")?;
//! let xy = white.xy().ok_or("dark")?;
//! assert!((xy.x - 0.3127).abs() < 1e-4 && (xy.y - 0.3290).abs() < 1e-4);
//! let (cct_k, duv) = white.cct().and_then(|cct| cct.near()).ok_or("not a white")?;
//! assert!((cct_k - 6504.0).abs() < 2.0 && (duv - 0.0032).abs() < 1e-4);
//!
//! // A gray card that reflects 18.42 % of it looks half as light as white, which sRGB encodes as #777777.
//! let card = white.scaled(0.1842);
//! let lab = card.lab(white).ok_or("no white")?;
//! assert!((lab.l - 50.0).abs() < 0.01);
//! # #[cfg(feature = "libm")]
//! assert_eq!(Rgb::<Srgb>::from_xyz(card).clip().rgb.encode().to_u8(), [0x77; 3]);
//! # Ok::<(), &str>(())
//! ```
//!
//! | what is wanted | where to start |
//! |---|---|
//! | chromaticity | [`Xyz::xy`], [`Xyz::uv1960`], [`Xyz::uv1976`] |
//! | correlated color temperature and Duv, and back | [`Xyz::cct`], [`Uv1960::of_cct`] |
//! | dominant wavelength and purity | [`dominant_wavelength()`] |
//! | CIELAB, CIELUV, Oklab | [`Xyz::lab`], [`Xyz::luv`], [`Xyz::oklab`] |
//! | high dynamic range | [`Ictcp`], [`Xyz::jzazbz`] |
//! | color difference | [`Xyz::delta_e`], [`ciede2000()`], [`cie76()`], [`cie94()`], [`cmc()`], [`hyab()`] |
//! | appearance in a scene, by CIECAM02 or CAM16 | [`ViewingConditions`] |
//! | the corresponding color under another white | [`Adaptation`] |
//! | a pixel, and its way into the gamut | [`Rgb`], [`EncodedRgb`], [`GamutMapped`] |
//! | color rendering of a lamp | [`cri()`], [`tm30()`], [`ssi()`] |
//! | a renderer that computes in RGB or in spectra | [`RgbBands`] |

pub(crate) mod matrix;

mod cct;
mod dominant;
mod planckian;
mod ssi;

mod lab;
mod luv;
mod oklab;

mod ictcp;
mod jzazbz;

mod ciede2000;
mod difference;

mod adaptation;
mod appearance;

mod rgb;
mod rgb_bands;
mod rgb_space;
pub mod transfer;

mod gamut;

#[cfg(feature = "libm")]
mod cri;
#[cfg(feature = "libm")]
mod reference;
#[cfg(feature = "libm")]
mod test_colors;
#[cfg(feature = "libm")]
mod tm30;

pub use crate::tristimulus::{Uv1960, Uv1976, Xy, Xyz};
pub use adaptation::{Adaptation, Bradford, Cat02, Cat16, ConeResponses, VonKries};
pub use appearance::{Appearance, AppearanceModel, Cam16, CamUcs, Ciecam02, Surround, ViewingConditions};
pub use cct::Cct;
#[cfg(feature = "libm")]
pub use ciede2000::ciede2000;
pub use ciede2000::{ParametricFactors, ciede2000_with};
#[cfg(feature = "libm")]
pub use cri::{Cri, cri};
pub use difference::{Cie94Weights, cie76, cie94, cmc, hyab};
pub use dominant::{DominantWavelength, dominant_wavelength};
pub use gamut::GamutMapped;
pub use ictcp::{Ictcp, IctcpTransfer};
pub use jzazbz::Jzazbz;
pub use lab::{Lab, Lch};
pub use luv::Luv;
pub use oklab::Oklab;
#[cfg(feature = "libm")]
pub use reference::RenderingError;
pub use rgb::{EncodedRgb, Rgb};
pub use rgb_bands::RgbBands;
pub(crate) use rgb_space::to_xyz64;
pub use rgb_space::{Aces2065, AcesCg, AdobeRgb, Bt2020, DciP3, DisplayP3, ProPhoto, RgbSpace, Srgb};
pub use ssi::ssi;
#[cfg(feature = "libm")]
pub use tm30::{HueBin, Tm30, tm30};
