//! Converts between linear light and the code values that image files and video signals hold.
//!
//! Each transfer function is a type that implements [`Transfer`], so a program contains only those that it
//! names. `encode` goes from linear light to a code value, `decode` from a code value to linear light.
//! [`Rgb::encode`](crate::color::Rgb::encode) applies the function of an RGB space to a whole color.
//!
//! ```
//! # #[cfg(feature = "libm")] {
//! use nanospectra::color::transfer::{Hlg, Pq, SrgbTransfer, Transfer};
//!
//! assert!((SrgbTransfer::decode(0.5) - 0.2140).abs() < 1e-4);
//! // BT.2408 places the white of graphics, 203 cd/m2, at 58 % of PQ, and 75 % of HLG is 26.5 % of the peak.
//! assert!((Pq::encode(203.0 / 10_000.0) - 0.58).abs() < 5e-3);
//! assert!((Hlg::decode(0.75) - 0.265).abs() < 5e-4);
//! # }
//! ```
//!
//! Linear 1 and code value 1 are white, unless a type says something else. All functions but [`Pq`] are odd,
//! `encode(-x) == -encode(x)`, which keeps colors outside the gamut. NaN stays NaN, and no finite number
//! becomes NaN.

#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::math::{Math, at_least, sqrt};

/// A transfer function, which converts between linear light and code values in both directions.
///
/// Call [`encode`](Transfer::encode) and [`decode`](Transfer::decode), or without the feature `libm` the
/// forms that take a math backend.
///
/// # Example
/// ```
/// use nanospectra::color::transfer::{SrgbTransfer, Transfer};
/// use nanospectra::math::Fast;
/// assert!((SrgbTransfer::encode_with::<Fast>(0.5) - 0.735_357).abs() < 1e-6);
/// assert!((SrgbTransfer::decode_with::<Fast>(0.5) - 0.214_041).abs() < 1e-6);
/// ```
pub trait Transfer: Copy + 'static {
    /// Computes the code value of a linear value.
    ///
    /// # Example
    /// ```
    /// use nanospectra::color::transfer::{SrgbTransfer, Transfer};
    /// assert!((SrgbTransfer::encode(0.5) - 0.735_357).abs() < 1e-6);
    /// assert!((SrgbTransfer::decode(0.5) - 0.214_041).abs() < 1e-6);
    /// ```
    #[cfg(feature = "libm")]
    #[must_use]
    fn encode(linear: f32) -> f32 {
        Self::encode_with::<Portable>(linear)
    }
    /// Computes the linear value of a code value.
    ///
    /// See the [example](Transfer::encode).
    #[cfg(feature = "libm")]
    #[must_use]
    fn decode(code: f32) -> f32 {
        Self::decode_with::<Portable>(code)
    }

    /// Computes the code value of a linear value by the elementary functions of the math backend `M`.
    ///
    /// See the [example](Transfer#example).
    fn encode_with<M: Math>(linear: f32) -> f32;
    /// Computes the linear value of a code value by the elementary functions of the math backend `M`.
    ///
    /// See the [example](Transfer#example).
    fn decode_with<M: Math>(code: f32) -> f32;
}

/// The transfer function of sRGB, which Display P3 uses too.
///
/// It follows IEC 61966-2-1 with the constants that the standard prints (12.92, 0.0031308, 0.04045). See the
/// [example](Transfer#example).
///
/// # Accuracy
/// Encoding is within 9e-8, decoding and the way there and back within 1.2e-7, on 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SrgbTransfer;

impl Transfer for SrgbTransfer {
    fn encode_with<M: Math>(linear: f32) -> f32 {
        let size = linear.abs();
        if size <= 0.003_130_8 {
            return 12.92 * linear;
        }
        // This is 1.055 p - 0.055, in a form that is exact for white.
        let p = M::powf(size, 1.0 / 2.4);
        (p + 0.055 * (p - 1.0)).copysign(linear)
    }
    fn decode_with<M: Math>(code: f32) -> f32 {
        let size = code.abs();
        if size <= 0.040_45 {
            return code / 12.92;
        }
        // The base is (c + 0.055) / 1.055, in a form with less rounding near white.
        M::powf(size + (1.0 - size) * (0.055 / 1.055), 2.4).copysign(code)
    }
}

/// The transfer function of BT.1886, the reference display of television, which for a black of zero is a pure
/// power of 2.4.
///
/// # Accuracy
/// 6e-8 either way on 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bt1886;

impl Transfer for Bt1886 {
    fn encode_with<M: Math>(linear: f32) -> f32 {
        power::<M>(linear, 1.0 / 2.4)
    }
    fn decode_with<M: Math>(code: f32) -> f32 {
        power::<M>(code, 2.4)
    }
}

/// The transfer function of Adobe RGB (1998), which is a power of 2 + 51/256.
///
/// # Accuracy
/// 7e-8 either way on 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AdobeRgbTransfer;

impl Transfer for AdobeRgbTransfer {
    fn encode_with<M: Math>(linear: f32) -> f32 {
        power::<M>(linear, 256.0 / 563.0)
    }
    fn decode_with<M: Math>(code: f32) -> f32 {
        power::<M>(code, 563.0 / 256.0)
    }
}

/// The transfer function of a BT.709 camera, by which video is coded; [`Bt1886`] is the display for it.
///
/// It follows BT.709 with the constants that the standard prints (4.5, 0.018, 1.099), which are those of
/// BT.2020 for 10 bits, too. `decode` gives the light that the camera saw, while a display, which is darker
/// on purpose, shows that of [`Bt1886`].
///
/// With the printed constants the curve jumps by 2.5e-4 at its knee, linear 0.018. No light has a code inside
/// the jump; such a code decodes to 0.018. The constants of BT.2020 for 12 bits, 1.0993 and 0.0181, give
/// codes that are at most 2.6e-4 away.
///
/// # Accuracy
/// Encoding is within 9.5e-8, decoding within 1.2e-7, on 0 to 1.
///
/// # Cost
/// On a Cortex-M4F three components take 687 instructions to encode and 795 to decode.
///
/// # Example
/// ```
/// # #[cfg(feature = "libm")] {
/// use nanospectra::color::transfer::{Bt709, Transfer};
/// // An 18 % gray card is coded near 41 % of the signal.
/// assert!((Bt709::encode(0.18) - 0.4090).abs() < 1e-4);
/// assert!((Bt709::decode(0.4090) - 0.18).abs() < 1e-4);
/// # }
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bt709;

impl Transfer for Bt709 {
    fn encode_with<M: Math>(linear: f32) -> f32 {
        let size = linear.abs();
        if size < 0.018 {
            return 4.5 * linear;
        }
        // This is 1.099 p - 0.099, in a form that is exact for white.
        let p = M::powf(size, 0.45);
        (p + 0.099 * (p - 1.0)).copysign(linear)
    }
    fn decode_with<M: Math>(code: f32) -> f32 {
        let size = code.abs();
        if size < 0.081 {
            return code / 4.5;
        }
        // The base is (c + 0.099) / 1.099, in a form with less rounding near white.
        let base = size + (1.0 - size) * (0.099 / 1.099);
        at_least(M::powf(base, 1.0 / 0.45), 0.018).copysign(code)
    }
}

/// The transfer function of digital cinema, which is a power of 2.6.
///
/// Code value 1 is linear 1. On the reference projector of SMPTE RP 431-2 that is 52.37 cd/m2, a little more
/// than the white of 48 cd/m2, which leaves room for X, Y, Z codes of whites that are not gray.
///
/// # Accuracy
/// 7e-8 either way on 0 to 1.
///
/// # Cost
/// On a Cortex-M4F three components take 664 instructions to encode and 757 to decode.
///
/// # Example
/// ```
/// # #[cfg(feature = "libm")] {
/// use nanospectra::color::transfer::{DciTransfer, Transfer};
/// // The 12-bit luminance code of the white of 48 cd/m2 is 3960.
/// assert!((4095.0 * DciTransfer::encode(48.0 / 52.37) - 3960.0).abs() < 0.1);
/// # }
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DciTransfer;

impl Transfer for DciTransfer {
    fn encode_with<M: Math>(linear: f32) -> f32 {
        power::<M>(linear, 1.0 / 2.6)
    }
    fn decode_with<M: Math>(code: f32) -> f32 {
        power::<M>(code, 2.6)
    }
}

/// The transfer function of ProPhoto RGB (ROMM RGB of ISO 22028-2), which is a power of 1.8 with a straight
/// line below 1/512.
///
/// # Accuracy
/// 7e-8 either way on 0 to 1.
///
/// # Cost
/// On a Cortex-M4F three components take 751 instructions to encode and 766 to decode.
///
/// # Example
/// ```
/// # #[cfg(feature = "libm")] {
/// use nanospectra::color::transfer::{ProPhotoTransfer, Transfer, to_u8};
/// // The line and the power meet where the code is 1/32.
/// assert!((ProPhotoTransfer::encode(1.0 / 512.0) - 0.031_25).abs() < 1e-8);
/// assert_eq!(to_u8(ProPhotoTransfer::encode(0.18)), 98);
/// # }
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ProPhotoTransfer;

impl Transfer for ProPhotoTransfer {
    fn encode_with<M: Math>(linear: f32) -> f32 {
        if linear.abs() <= 1.0 / 512.0 { 16.0 * linear } else { power::<M>(linear, 1.0 / 1.8) }
    }
    fn decode_with<M: Math>(code: f32) -> f32 {
        if code.abs() <= 1.0 / 32.0 { code / 16.0 } else { power::<M>(code, 1.8) }
    }
}

/// The identity, which serves ACEScg and other scene-linear files, whose code values are linear.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LinearTransfer;

impl Transfer for LinearTransfer {
    fn encode_with<M: Math>(linear: f32) -> f32 {
        linear
    }
    fn decode_with<M: Math>(code: f32) -> f32 {
        code
    }
}

/// The PQ function of SMPTE ST 2084 and BT.2100, which encodes absolute luminance: linear 1 is 10 000 cd/m2.
///
/// There is no light below zero: a linear value below zero is encoded as zero is, to 7.3e-7, and code values
/// below that decode to zero. A code of 1.992 or more is beyond the function's pole and decodes to infinity.
/// See the [example](crate::color::transfer).
///
/// # Accuracy
/// The textbook form loses three digits to `p - c1` and `c2 - c3 p`, because p is close to 1; here p - 1 is
/// computed instead. Encoding is within 1.5e-7 absolute and 1.8e-6 relative, decoding within 8e-7 (8
/// millicandela) and 2.4e-6 relative from 1e-4 cd/m2 up (searched in `tests/color/worst_conversions.rs`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Pq;

impl Pq {
    const M1: f32 = 2610.0 / 16384.0;
    /// The exponent by which the encoded signal is bent.
    pub(in crate::color) const M2: f32 = 2523.0 / 4096.0 * 128.0;
    const C1: f32 = 3424.0 / 4096.0;
    const C2: f32 = 2413.0 / 4096.0 * 32.0;
    const C3: f32 = 2392.0 / 4096.0 * 32.0;
    /// The constant 1 - c1, which is also c2 - c3.
    const D: f32 = 1.0 - Self::C1;
}

impl Transfer for Pq {
    fn encode_with<M: Math>(linear: f32) -> f32 {
        Self::encode_by::<M>(linear, Self::M2)
    }
    fn decode_with<M: Math>(code: f32) -> f32 {
        Self::decode_by::<M>(code, Self::M2)
    }
}

impl Pq {
    /// Encodes with another exponent in place of [`M2`](Self::M2), as Jzazbz does.
    pub(in crate::color) fn encode_by<M: Math>(linear: f32, exponent: f32) -> f32 {
        let y = if linear <= 0.0 { 0.0 } else { M::powf(linear, Self::M1) };
        // ln((c1 + c2 y) / (1 + c3 y)) = 2 atanh(s), and |s| <= 0.09
        let s = Self::D * (y - 1.0) / (1.0 + Self::C1 + (Self::C2 + Self::C3) * y);
        let s2 = s * s;
        let atanh = s + s * s2 * (1.0 / 3.0 + s2 * (1.0 / 5.0 + s2 * (1.0 / 7.0)));
        M::exp(2.0 * exponent * atanh)
    }

    /// Decodes what [`encode_by`](Self::encode_by) has encoded.
    pub(in crate::color) fn decode_by<M: Math>(code: f32, exponent: f32) -> f32 {
        if code <= 0.0 {
            return 0.0;
        }
        let p1 = M::expm1(M::ln(code) / exponent);
        let (over, under) = (Self::D + p1, Self::D - Self::C3 * p1);
        if over <= 0.0 {
            return 0.0;
        }
        if under <= 0.0 {
            return f32::INFINITY;
        }
        M::powf(over / under, 1.0 / Self::M1)
    }
}

/// The HLG function of ARIB STD-B67 and BT.2100 as cameras use it: linear 1 is the peak of the scene.
///
/// The rendering of the scene by a display (the OOTF) is not included. See the
/// [example](crate::color::transfer).
///
/// # Accuracy
/// Encoding is within 1e-7, decoding within 3e-7, on 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Hlg;

impl Hlg {
    const A: f32 = 0.178_832_77;
    const B: f32 = 0.284_668_92;
    const C: f32 = 0.559_910_7;
}

impl Transfer for Hlg {
    fn encode_with<M: Math>(linear: f32) -> f32 {
        let size = linear.abs();
        let code = if size <= 1.0 / 12.0 {
            sqrt(3.0 * size)
        } else {
            Self::A * M::ln(12.0 * size - Self::B) + Self::C
        };
        code.copysign(linear)
    }
    fn decode_with<M: Math>(code: f32) -> f32 {
        let size = code.abs();
        let linear = if size <= 0.5 {
            size * size / 3.0
        } else {
            (M::exp((size - Self::C) / Self::A) + Self::B) / 12.0
        };
        linear.copysign(code)
    }
}

/// Computes |x|^y with the sign of x.
fn power<M: Math>(x: f32, y: f32) -> f32 {
    M::powf(x.abs(), y).copysign(x)
}

/// Rounds a value in 0..=1 to its 8-bit code.
///
/// Halves are rounded up. A value below 0 becomes 0, one above 1 becomes 255, and NaN, which has no code,
/// becomes 0.
///
/// # Example
/// ```
/// use nanospectra::color::transfer::{from_u8, to_u8};
/// assert_eq!([0.5, -0.1, 1.1].map(to_u8), [128, 0, 255]);
/// assert_eq!(from_u8(51), 0.2);
/// ```
#[must_use]
pub fn to_u8(value: f32) -> u8 {
    let code = value * 255.0;
    let whole = code as u8; // saturates, and is 0 for NaN
    // The fraction is exact, while adding one half before truncating would round.
    if code - f32::from(whole) >= 0.5 { whole.saturating_add(1) } else { whole }
}

/// Returns the value of an 8-bit code, where 255 is 1.
///
/// See the [example](to_u8#example).
#[must_use]
pub fn from_u8(code: u8) -> f32 {
    f32::from(code) / 255.0
}
