//! RGB spaces. Each is a type, with matrices that the compiler derives from the chromaticities of the
//! standard.

use core::fmt::Debug;

use crate::color::Xyz;
use crate::color::matrix::{apply64, inverse64, rounded, scale_columns64};
use crate::color::transfer::{self, Transfer};

/// An RGB space, which is defined by three primaries, a white, and its usual transfer function.
///
/// [`Srgb`], [`DisplayP3`], [`DciP3`], [`Bt2020`], [`AdobeRgb`], [`ProPhoto`], [`AcesCg`] and [`Aces2065`]
/// implement it; [`Rgb`](crate::color::Rgb) takes one of them as its type parameter. The compiler derives the
/// matrices from the chromaticities, in f64. Implement this trait for another space, with a type that stands
/// for it.
///
/// No conversion adapts a color to another white. A color that is seen under D65 and goes into a space whose
/// white is another one, such as [`DciP3`] or [`ProPhoto`], goes through an
/// [`Adaptation`](crate::color::Adaptation) first.
///
/// # Example
/// ```
/// use nanospectra::color::{Rgb, RgbSpace, Xyz, transfer};
/// #[derive(Clone, Copy, Debug, PartialEq)]
/// struct Ntsc1953;
/// impl RgbSpace for Ntsc1953 {
///     const PRIMARIES: [[f64; 2]; 3] = [[0.67, 0.33], [0.21, 0.71], [0.14, 0.08]];
///     const WHITE: [f64; 2] = [0.31006, 0.31616]; // illuminant C
///     type Transfer = transfer::Bt1886;
/// }
/// // The weights 0.30, 0.59 and 0.11 of analog television.
/// let luma = Ntsc1953::TO_XYZ[1];
/// assert!((luma[0] - 0.299).abs() < 5e-4 && (luma[1] - 0.587).abs() < 5e-4);
/// let white = Rgb::<Ntsc1953>::from_xyz(Ntsc1953::WHITE_XYZ);
/// assert!((white.g - 1.0).abs() < 1e-6);
/// ```
pub trait RgbSpace: Copy + Debug + 'static {
    /// The chromaticities x, y of the red, green and blue primaries, as the standard gives them.
    ///
    /// See the [example](RgbSpace#example).
    const PRIMARIES: [[f64; 2]; 3];
    /// The chromaticity x, y of the white, as the standard gives it.
    ///
    /// See the [example](RgbSpace#example).
    const WHITE: [f64; 2];
    /// The transfer function with which the space is usually used.
    ///
    /// See the [example](RgbSpace#example).
    type Transfer: Transfer;

    /// The matrix that takes linear RGB to X, Y, Z, row by row, as standards print it.
    ///
    /// Its white has Y = 1, a hundredth of what an [`Xyz`] has. [`Rgb::xyz`](crate::color::Rgb::xyz) applies
    /// the matrix and multiplies by 100. See the [example](RgbSpace#example).
    const TO_XYZ: [[f32; 3]; 3] = rounded(&to_xyz64(&Self::PRIMARIES, Self::WHITE));
    /// The inverse of [`TO_XYZ`](Self::TO_XYZ), which takes X, Y, Z with Y = 1 for white to linear RGB.
    const FROM_XYZ: [[f32; 3]; 3] = rounded(&inverse64(&to_xyz64(&Self::PRIMARIES, Self::WHITE)));
    /// The tristimulus values of the white, which has Y = 100.
    ///
    /// This is the white to which a color is adapted before [`Rgb::from_xyz`](crate::color::Rgb::from_xyz).
    /// See the [example](RgbSpace#example).
    const WHITE_XYZ: Xyz = {
        let [x, y, z] = column(Self::WHITE);
        Xyz { x: (100.0 * x) as f32, y: (100.0 * y) as f32, z: (100.0 * z) as f32 }
    };
}

/// The sRGB space of IEC 61966-2-1, which has the primaries of BT.709, D65 as its white and
/// [`SrgbTransfer`](transfer::SrgbTransfer).
///
/// See the [example](crate::color::Rgb#example).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Srgb;
/// The Display P3 space, which has the primaries of DCI-P3, D65 as its white and the transfer function of
/// sRGB.
///
/// See the [example](crate::color::Rgb#example).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DisplayP3;
/// The DCI-P3 space of digital cinema (SMPTE RP 431-2), which has a greenish white of its own at x = 0.314,
/// y = 0.351, and a power of 2.6, [`DciTransfer`](transfer::DciTransfer), as its transfer function.
///
/// Its primaries are those of [`DisplayP3`]. A picture whose white is D65 is adapted to the white of this
/// space, or keeps its chromaticity if the projector shall show D65.
///
/// # Example
/// ```
/// use nanospectra::color::{Adaptation, Bradford, DciP3, Rgb, RgbSpace, Srgb};
/// // The matrix that SMPTE EG 432-1 prints: 0.2095, 0.7216 and 0.0689 are the luminances of the primaries.
/// let [r, g, b] = DciP3::TO_XYZ[1];
/// assert!((r - 0.2095).abs() < 5e-5 && (g - 0.7216).abs() < 5e-5 && (b - 0.0689).abs() < 5e-5);
///
/// // The white of sRGB, adapted, is the white of the cinema; as it is, it is bluer than that.
/// let white = Rgb::<Srgb>::new(1.0, 1.0, 1.0).xyz();
/// let to_cinema = Adaptation::between::<Bradford>(white, DciP3::WHITE_XYZ).ok_or("no white")?;
/// let adapted = Rgb::<DciP3>::from_xyz(to_cinema.apply(white));
/// assert!(adapted.to_array().iter().all(|c| (c - 1.0).abs() < 1e-6));
/// assert!(Rgb::<DciP3>::from_xyz(white).b > 1.15);
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DciP3;
/// The BT.2020 space of ultra-high-definition television, which has D65 as its white and the transfer
/// function of a [`Bt1886`](transfer::Bt1886) display.
///
/// Encoded by [`transfer::Pq`] or [`transfer::Hlg`] it is BT.2100, as in this
/// [example](crate::color::Rgb::encode_with).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bt2020;
/// The Adobe RGB (1998) space, which has D65 as its white and a transfer function of its own,
/// [`AdobeRgbTransfer`](transfer::AdobeRgbTransfer).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AdobeRgb;
/// The ProPhoto RGB space of photography, which is ROMM RGB of ISO 22028-2 and has D50 as its white and
/// [`ProPhotoTransfer`](transfer::ProPhotoTransfer).
///
/// Its green and blue primaries are imaginary, so that every surface color is inside. Adapt colors that are
/// seen under D65 to its white first.
///
/// # Example
/// ```
/// use nanospectra::color::{ProPhoto, RgbSpace};
/// // The matrix to X, Y, Z as the standard prints it.
/// let printed = [[0.7977, 0.1352, 0.0313], [0.2880, 0.7119, 0.0001], [0.0, 0.0, 0.8249]];
/// for (found, printed) in ProPhoto::TO_XYZ.iter().flatten().zip(printed.iter().flatten()) {
///     assert!((found - printed).abs() < 3e-4);
/// }
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ProPhoto;
/// The ACEScg space of film rendering, which has the AP1 primaries, the ACES white (near D60) and linear code
/// values.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AcesCg;
/// The ACES2065-1 space in which film is archived (SMPTE ST 2065-1), which has the AP0 primaries, the ACES
/// white and linear code values.
///
/// The triangle of its primaries holds every real color; its green and blue are imaginary, and the luminance
/// of its blue is negative.
///
/// # Example
/// ```
/// use nanospectra::color::{Aces2065, RgbSpace};
/// // The second row of the matrix in SMPTE ST 2065-1.
/// let [r, g, b] = Aces2065::TO_XYZ[1];
/// assert!((r - 0.343_966_45).abs() < 1e-7 && (g - 0.728_166_1).abs() < 1e-7 && (b + 0.072_132_55).abs() < 1e-7);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Aces2065;

/// The chromaticity x, y of D65, as the RGB standards round it.
const D65: [f64; 2] = [0.3127, 0.3290];
/// The chromaticity x, y of D50, as the RGB standards round it.
const D50: [f64; 2] = [0.3457, 0.3585];
/// The chromaticity x, y of the white of ACES, near that of D60.
const ACES_WHITE: [f64; 2] = [0.32168, 0.33767];
/// The primaries of DCI-P3, which Display P3 took over.
const P3: [[f64; 2]; 3] = [[0.680, 0.320], [0.265, 0.690], [0.150, 0.060]];

impl RgbSpace for Srgb {
    const PRIMARIES: [[f64; 2]; 3] = [[0.64, 0.33], [0.30, 0.60], [0.15, 0.06]];
    const WHITE: [f64; 2] = D65;
    type Transfer = transfer::SrgbTransfer;
}
impl RgbSpace for DisplayP3 {
    const PRIMARIES: [[f64; 2]; 3] = P3;
    const WHITE: [f64; 2] = D65;
    type Transfer = transfer::SrgbTransfer;
}
impl RgbSpace for DciP3 {
    const PRIMARIES: [[f64; 2]; 3] = P3;
    const WHITE: [f64; 2] = [0.314, 0.351];
    type Transfer = transfer::DciTransfer;
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
impl RgbSpace for ProPhoto {
    const PRIMARIES: [[f64; 2]; 3] = [[0.7347, 0.2653], [0.1596, 0.8404], [0.0366, 0.0001]];
    const WHITE: [f64; 2] = D50;
    type Transfer = transfer::ProPhotoTransfer;
}
impl RgbSpace for AcesCg {
    const PRIMARIES: [[f64; 2]; 3] = [[0.713, 0.293], [0.165, 0.830], [0.128, 0.044]];
    const WHITE: [f64; 2] = ACES_WHITE;
    type Transfer = transfer::LinearTransfer;
}
impl RgbSpace for Aces2065 {
    const PRIMARIES: [[f64; 2]; 3] = [[0.7347, 0.2653], [0.0, 1.0], [0.0001, -0.0770]];
    const WHITE: [f64; 2] = ACES_WHITE;
    type Transfer = transfer::LinearTransfer;
}

/// Returns X, Y, Z of the chromaticity `xy` with Y = 1.
const fn column(xy: [f64; 2]) -> [f64; 3] {
    [xy[0] / xy[1], 1.0, (1.0 - xy[0] - xy[1]) / xy[1]]
}

/// Derives the matrix to X, Y, Z with Y = 1 for white. Its columns are the primaries, in the proportion in
/// which they add up to the white.
pub(crate) const fn to_xyz64(primaries: &[[f64; 2]; 3], white: [f64; 2]) -> [[f64; 3]; 3] {
    let [r, g, b] = [column(primaries[0]), column(primaries[1]), column(primaries[2])];
    let m = [[r[0], g[0], b[0]], [r[1], g[1], b[1]], [r[2], g[2], b[2]]];
    scale_columns64(&m, apply64(&inverse64(&m), column(white)))
}
