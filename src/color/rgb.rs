//! Linear RGB colors and their code values, with the RGB space in the type.

use core::marker::PhantomData;

use crate::color::matrix::apply;
use crate::color::transfer::{self, Transfer};
use crate::color::{RgbSpace, Xyz};
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::math::{Math, linear_operators};

/// A linear RGB color of space `S`, which holds the amounts of the primaries and is white at (1, 1, 1).
///
/// Make it by [`Rgb::from_xyz`], or from code values by [`EncodedRgb::decode`]. [`Rgb::encode`] gives the
/// code values for a file or a display.
///
/// A color outside the gamut has a component below 0 or above 1; [`Rgb::clip`], [`Rgb::dim`] and
/// [`Rgb::desaturate`] map it into the gamut.
///
/// # Example
/// ```
/// use nanospectra::color::{DisplayP3, Rgb, Srgb};
/// let red = Rgb::<Srgb>::new(1.0, 0.0, 0.0);
/// let xyz = red.xyz();
/// assert!((xyz.x - 41.24).abs() < 0.01 && (xyz.y - 21.26).abs() < 0.01 && (xyz.z - 1.93).abs() < 0.01);
/// assert!((red.luminance() - 0.2126).abs() < 1e-4);
///
/// // The same color on a Display P3 screen is color(display-p3 0.9175 0.2003 0.1386) in CSS.
/// let wide = Rgb::<DisplayP3>::from_xyz(xyz);
/// # #[cfg(feature = "libm")] {
/// let [r, g, b] = wide.encode().to_array();
/// assert!((r - 0.9175).abs() < 1e-3 && (g - 0.2003).abs() < 1e-3 && (b - 0.1386).abs() < 1e-3);
/// # }
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rgb<S> {
    /// The amount of the red primary, which is 1 in white.
    pub r: f32,
    /// The amount of the green primary, which is 1 in white.
    pub g: f32,
    /// The amount of the blue primary, which is 1 in white.
    pub b: f32,
    space: PhantomData<S>,
}

/// An RGB color of space `S` as code values, encoded by transfer function `T`; 1 is full scale.
///
/// [`Rgb::encode`] makes it from a linear color, and [`EncodedRgb::from_u8`] from the bytes of an image.
///
/// # Example
/// ```
/// use nanospectra::color::{EncodedRgb, Srgb};
/// let azure = EncodedRgb::<Srgb>::from_u8([0x00, 0x80, 0xff]);
/// assert_eq!(azure.to_array(), [0.0, 128.0 / 255.0, 1.0]);
/// assert_eq!(EncodedRgb::<Srgb>::new(0.0, 0.501, 1.1).to_u8(), [0x00, 0x80, 0xff]);
/// # #[cfg(feature = "libm")] {
/// // The code 128 is 22 % of the light of white, not half of it.
/// let linear = azure.decode();
/// assert!((linear.g - 0.2159).abs() < 1e-4);
/// assert_eq!(linear.encode().to_u8(), [0x00, 0x80, 0xff]);
/// # }
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EncodedRgb<S: RgbSpace, T = <S as RgbSpace>::Transfer> {
    /// The code value of red, where 1 is full scale.
    pub r: f32,
    /// The code value of green, where 1 is full scale.
    pub g: f32,
    /// The code value of blue, where 1 is full scale.
    pub b: f32,
    space: PhantomData<(S, T)>,
}

impl<S: RgbSpace> Rgb<S> {
    /// Converts tristimulus values, with Y = 100 for white, to the amounts of the primaries.
    ///
    /// The color must be one that is seen under the white of the space; it is not adapted. Adapt a color that
    /// is seen under another white first (see [`Adaptation`](crate::color::Adaptation)). NaN stays NaN.
    /// Components beyond 1e37 in size overflow. See the [example](Rgb#example).
    ///
    /// # Accuracy
    /// 6e-7 of white (searched in `tests/color/worst_conversions.rs`).
    #[must_use]
    pub const fn from_xyz(color: Xyz) -> Self {
        let [r, g, b] = apply(&S::FROM_XYZ, color.scaled(0.01).to_array());
        Rgb::new(r, g, b)
    }

    /// Makes a color from the linear amounts of red, green and blue.
    ///
    /// See the [example](Rgb#example).
    #[must_use]
    pub const fn new(r: f32, g: f32, b: f32) -> Self {
        Rgb { r, g, b, space: PhantomData }
    }

    /// Returns the linear amounts as the array `[r, g, b]`.
    ///
    /// See the [example](crate::color::GamutMapped#example).
    #[must_use]
    pub const fn to_array(self) -> [f32; 3] {
        [self.r, self.g, self.b]
    }

    /// Converts the color to tristimulus values, with Y = 100 for white.
    ///
    /// See the [example](Rgb#example).
    #[must_use]
    pub const fn xyz(self) -> Xyz {
        let [x, y, z] = apply(&S::TO_XYZ, self.to_array());
        Xyz { x, y, z }.scaled(100.0)
    }

    /// Computes the relative luminance, which is 1 for white.
    ///
    /// It is on the scale of the components: where it is 1, Y of [`xyz`](Self::xyz) is 100. See the
    /// [example](Rgb#example).
    #[must_use]
    pub const fn luminance(self) -> f32 {
        let [r, g, b] = S::TO_XYZ[1];
        r * self.r + g * self.g + b * self.b
    }

    /// Computes the code values by the transfer function of the space.
    ///
    /// Components outside 0..=1 are encoded too. Call [`clip`](Self::clip) first for a file that cannot hold
    /// them.
    ///
    /// # Example
    /// ```
    /// use nanospectra::color::{Rgb, Srgb, Xyz};
    /// // The gray that looks half way between black and white (L* = 50, Y = 18.42) is #777777.
    /// let gray = Rgb::<Srgb>::from_xyz(Xyz::new(17.51, 18.42, 20.06));
    /// assert_eq!(gray.clip().rgb.encode().to_u8(), [0x77; 3]);
    /// ```
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn encode(self) -> EncodedRgb<S> {
        self.encode_with::<S::Transfer, Portable>()
    }

    /// Computes the code values by transfer function `T` and the elementary functions of math backend `M`.
    ///
    /// `Rgb::<Bt2020>::encode_with::<Pq, Portable>` gives the code values of BT.2100.
    ///
    /// # Example
    /// ```
    /// use nanospectra::color::{Bt2020, EncodedRgb, Rgb, transfer::Pq};
    /// use nanospectra::math::Fast;
    /// // A white of 100 cd/m2 is 0.01 of the 10 000 cd/m2 of PQ, and has the code 0.508.
    /// let white: EncodedRgb<Bt2020, Pq> = Rgb::new(0.01, 0.01, 0.01).encode_with::<Pq, Fast>();
    /// assert!((white.g - 0.508).abs() < 5e-4);
    /// assert!((white.decode_with::<Fast>().g - 0.01).abs() < 1e-6);
    /// ```
    #[must_use]
    pub fn encode_with<T: Transfer, M: Math>(self) -> EncodedRgb<S, T> {
        let [r, g, b] = self.to_array().map(T::encode_with::<M>);
        EncodedRgb::new(r, g, b)
    }
}

// Linear colors add up as lights do.
linear_operators! {
    [S: RgbSpace] Rgb<S>, Rgb::new(0.0, 0.0, 0.0);
    |a, c| { Rgb::new(a.r + c.r, a.g + c.g, a.b + c.b) } { Rgb::new(a.r - c.r, a.g - c.g, a.b - c.b) }
    { Rgb::new(a.r * c, a.g * c, a.b * c) } { Rgb::new(a.r / c, a.g / c, a.b / c) } { Rgb::new(-a.r, -a.g, -a.b) }
}

impl<S: RgbSpace, T: Transfer> EncodedRgb<S, T> {
    /// Makes a color from 8-bit codes, such as the three bytes of `#4695a4`.
    ///
    /// See the [example](EncodedRgb#example).
    #[must_use]
    pub fn from_u8(code: [u8; 3]) -> Self {
        let [r, g, b] = code.map(transfer::from_u8);
        EncodedRgb::new(r, g, b)
    }

    /// Rounds the code values to 8-bit codes.
    ///
    /// Halves are rounded up, what lies outside 0..=255 is clipped, and NaN becomes 0. See the
    /// [example](EncodedRgb#example).
    #[must_use]
    pub fn to_u8(self) -> [u8; 3] {
        self.to_array().map(transfer::to_u8)
    }

    /// Makes a color from the code values of red, green and blue.
    ///
    /// See the [example](EncodedRgb#example).
    #[must_use]
    pub const fn new(r: f32, g: f32, b: f32) -> Self {
        EncodedRgb { r, g, b, space: PhantomData }
    }

    /// Returns the code values as the array `[r, g, b]`.
    ///
    /// See the [example](EncodedRgb#example).
    #[must_use]
    pub const fn to_array(self) -> [f32; 3] {
        [self.r, self.g, self.b]
    }

    /// Decodes the code values to a linear RGB color.
    ///
    /// See the [example](EncodedRgb#example).
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn decode(self) -> Rgb<S> {
        self.decode_with::<Portable>()
    }

    /// Decodes the code values by the elementary functions of the math backend `M`.
    ///
    /// See the [example](Rgb::encode_with).
    #[must_use]
    pub fn decode_with<M: Math>(self) -> Rgb<S> {
        let [r, g, b] = self.to_array().map(T::decode_with::<M>);
        Rgb::new(r, g, b)
    }
}
