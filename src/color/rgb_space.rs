//! RGB spaces: each is a type, with matrices that the compiler derives from the chromaticities in its
//! standard.

use core::fmt::Debug;

use crate::color::Xyz;
use crate::color::matrix::{apply64, inverse64, rounded, scale_columns64};
use crate::color::transfer::{self, Transfer};

/// What defines an RGB space: three primaries, a white, and the usual transfer function.
///
/// The compiler derives the matrices from the chromaticities, in f64. A space of your own is a type of your
/// own:
///
/// ```
/// use nanospectra::color::{Rgb, RgbSpace, Xyz, transfer};
/// #[derive(Clone, Copy, Debug, PartialEq)]
/// struct Ntsc1953;
/// impl RgbSpace for Ntsc1953 {
///     const PRIMARIES: [[f64; 2]; 3] = [[0.67, 0.33], [0.21, 0.71], [0.14, 0.08]];
///     const WHITE: [f64; 2] = [0.31006, 0.31616]; // illuminant C
///     type Transfer = transfer::Bt1886;
/// }
/// let luma = Ntsc1953::TO_XYZ[1]; // the 0.30, 0.59, 0.11 of analog television
/// assert!((luma[0] - 0.299).abs() < 5e-4 && (luma[1] - 0.587).abs() < 5e-4);
/// ```
pub trait RgbSpace: Copy + Debug + 'static {
    /// x, y of red, green and blue.
    const PRIMARIES: [[f64; 2]; 3];
    /// x, y of the white, as the standard gives it.
    const WHITE: [f64; 2];
    /// The transfer function the space is used with.
    type Transfer: Transfer;

    /// Linear RGB to X, Y, Z as standards print the matrix, row-major: its white has Y = 1, a hundredth of
    /// what an [`Xyz`] has. [`Rgb::xyz`](crate::color::Rgb::xyz) applies it and multiplies by 100.
    const TO_XYZ: [[f32; 3]; 3] = rounded(&to_xyz64(&Self::PRIMARIES, Self::WHITE));
    /// The inverse of [`TO_XYZ`](Self::TO_XYZ), from X, Y, Z with Y = 1 for white to linear RGB.
    const FROM_XYZ: [[f32; 3]; 3] = rounded(&inverse64(&to_xyz64(&Self::PRIMARIES, Self::WHITE)));
    /// The white as a color, Y = 100: what to adapt to before [`Rgb::from_xyz`](crate::color::Rgb::from_xyz).
    const WHITE_XYZ: Xyz = {
        let [x, y, z] = column(Self::WHITE);
        Xyz { x: (100.0 * x) as f32, y: (100.0 * y) as f32, z: (100.0 * z) as f32 }
    };
}

/// sRGB, IEC 61966-2-1: primaries of BT.709, D65.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Srgb;
/// Display P3: the primaries of DCI-P3, with D65 and the transfer function of sRGB.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DisplayP3;
/// BT.2020 with the transfer function of a BT.1886 display; encoded by [`transfer::Pq`] or [`transfer::Hlg`]
/// it is BT.2100.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bt2020;
/// Adobe RGB (1998).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AdobeRgb;
/// ACEScg: AP1 primaries, the ACES white (near D60), linear.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AcesCg;

/// x, y of D65 as the RGB standards round it.
const D65: [f64; 2] = [0.3127, 0.3290];

impl RgbSpace for Srgb {
    const PRIMARIES: [[f64; 2]; 3] = [[0.64, 0.33], [0.30, 0.60], [0.15, 0.06]];
    const WHITE: [f64; 2] = D65;
    type Transfer = transfer::SrgbTransfer;
}
impl RgbSpace for DisplayP3 {
    const PRIMARIES: [[f64; 2]; 3] = [[0.680, 0.320], [0.265, 0.690], [0.150, 0.060]];
    const WHITE: [f64; 2] = D65;
    type Transfer = transfer::SrgbTransfer;
}
impl RgbSpace for Bt2020 {
    const PRIMARIES: [[f64; 2]; 3] = [[0.708, 0.292], [0.170, 0.797], [0.131, 0.046]];
    const WHITE: [f64; 2] = D65;
    type Transfer = transfer::Bt1886;
}
impl RgbSpace for AdobeRgb {
    const PRIMARIES: [[f64; 2]; 3] = [[0.64, 0.33], [0.21, 0.71], [0.15, 0.06]];
    const WHITE: [f64; 2] = D65;
    type Transfer = transfer::AdobeRgbTransfer;
}
impl RgbSpace for AcesCg {
    const PRIMARIES: [[f64; 2]; 3] = [[0.713, 0.293], [0.165, 0.830], [0.128, 0.044]];
    const WHITE: [f64; 2] = [0.32168, 0.33767];
    type Transfer = transfer::LinearTransfer;
}

/// The color of chromaticity `xy` with Y = 1.
const fn column(xy: [f64; 2]) -> [f64; 3] {
    [xy[0] / xy[1], 1.0, (1.0 - xy[0] - xy[1]) / xy[1]]
}

/// The matrix to X, Y, Z with Y = 1 for white: the primaries as columns, in the proportion whose sum is the
/// white.
pub(crate) const fn to_xyz64(primaries: &[[f64; 2]; 3], white: [f64; 2]) -> [[f64; 3]; 3] {
    let [r, g, b] = [column(primaries[0]), column(primaries[1]), column(primaries[2])];
    let m = [[r[0], g[0], b[0]], [r[1], g[1], b[1]], [r[2], g[2], b[2]]];
    scale_columns64(&m, apply64(&inverse64(&m), column(white)))
}
