//! Linear RGB, with the RGB space in the type, and its code values.

use core::marker::PhantomData;

use crate::color::matrix::apply;
use crate::color::transfer::{self, Transfer};
use crate::color::{RgbSpace, Xyz};
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::math::{Math, linear_operators};

/// A linear RGB color of space `S`: the amounts of the primaries, where (1, 1, 1) is white.
///
/// A color outside the gamut has a component below 0 or above 1: [`Rgb::clip`], [`Rgb::dim`] and
/// [`Rgb::desaturate`] map it into the gamut.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rgb<S> {
    /// Red.
    pub r: f32,
    /// Green.
    pub g: f32,
    /// Blue.
    pub b: f32,
    space: PhantomData<S>,
}

/// An RGB color of space `S` as code values, encoded by transfer function `T`; 1 is full scale.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EncodedRgb<S: RgbSpace, T = <S as RgbSpace>::Transfer> {
    /// Red.
    pub r: f32,
    /// Green.
    pub g: f32,
    /// Blue.
    pub b: f32,
    space: PhantomData<(S, T)>,
}

impl<S: RgbSpace> Rgb<S> {
    /// Red, green, blue; linear.
    #[must_use]
    pub const fn new(r: f32, g: f32, b: f32) -> Self {
        Rgb { r, g, b, space: PhantomData }
    }

    /// Red, green, blue.
    #[must_use]
    pub const fn to_array(self) -> [f32; 3] {
        [self.r, self.g, self.b]
    }

    /// The amounts of the primaries that give a color with Y = 100 for white.
    ///
    /// The color is not adapted: it is one seen under the white of the space. Adapt a color that is seen
    /// under another white first (see [`Adaptation`](crate::color::Adaptation)). NaN stays NaN; components
    /// beyond 1e37 in size overflow.
    ///
    /// # Accuracy
    /// 4e-7 (`tests/color/rgb_and_adaptation.rs`).
    #[must_use]
    pub const fn from_xyz(color: Xyz) -> Self {
        let [r, g, b] = apply(&S::FROM_XYZ, color.scaled(0.01).to_array());
        Rgb::new(r, g, b)
    }

    /// The tristimulus values, Y = 100 for white.
    #[must_use]
    pub const fn xyz(self) -> Xyz {
        let [x, y, z] = apply(&S::TO_XYZ, self.to_array());
        Xyz { x, y, z }.scaled(100.0)
    }

    /// The relative luminance, which is on the scale of the components: 1 for white, where Y of
    /// [`xyz`](Self::xyz) is 100.
    #[must_use]
    pub const fn luminance(self) -> f32 {
        let [r, g, b] = S::TO_XYZ[1];
        r * self.r + g * self.g + b * self.b
    }

    /// The code values by the transfer function of the space.
    ///
    /// ```
    /// use nanospectra::color::{Rgb, Srgb, Xyz};
    /// // The gray half way to white for the eye (L* = 50, Y = 18.42) is #777777.
    /// let gray = Rgb::<Srgb>::from_xyz(Xyz::new(17.51, 18.42, 20.06));
    /// assert_eq!(gray.clip().rgb.encode().to_u8(), [0x77; 3]);
    /// ```
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn encode(self) -> EncodedRgb<S> {
        self.encode_with::<S::Transfer, Portable>()
    }

    /// The code values by transfer function `T` and the functions of `M`: BT.2100 is
    /// `Rgb::<Bt2020>::encode_with::<Pq, Portable>`.
    #[must_use]
    pub fn encode_with<T: Transfer, M: Math>(self) -> EncodedRgb<S, T> {
        let [r, g, b] = self.to_array().map(T::encode_with::<M>);
        EncodedRgb::new(r, g, b)
    }
}

// Linear colors add as lights do.
linear_operators! {
    [S: RgbSpace] Rgb<S>, Rgb::new(0.0, 0.0, 0.0);
    |a, c| { Rgb::new(a.r + c.r, a.g + c.g, a.b + c.b) } { Rgb::new(a.r - c.r, a.g - c.g, a.b - c.b) }
    { Rgb::new(a.r * c, a.g * c, a.b * c) } { Rgb::new(a.r / c, a.g / c, a.b / c) } { Rgb::new(-a.r, -a.g, -a.b) }
}

impl<S: RgbSpace, T: Transfer> EncodedRgb<S, T> {
    /// Red, green, blue; code values.
    #[must_use]
    pub const fn new(r: f32, g: f32, b: f32) -> Self {
        EncodedRgb { r, g, b, space: PhantomData }
    }

    /// Red, green, blue.
    #[must_use]
    pub const fn to_array(self) -> [f32; 3] {
        [self.r, self.g, self.b]
    }

    /// From 8-bit codes, as of `#4695a4`.
    #[must_use]
    pub fn from_u8(code: [u8; 3]) -> Self {
        let [r, g, b] = code.map(transfer::from_u8);
        EncodedRgb::new(r, g, b)
    }

    /// To 8-bit codes, rounded half up, clipped to 0..=255 and 0 for NaN.
    #[must_use]
    pub fn to_u8(self) -> [u8; 3] {
        self.to_array().map(transfer::to_u8)
    }

    /// The linear RGB color of these code values.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn decode(self) -> Rgb<S> {
        self.decode_with::<Portable>()
    }

    /// [`EncodedRgb::decode`] by the functions of `M`.
    #[must_use]
    pub fn decode_with<M: Math>(self) -> Rgb<S> {
        let [r, g, b] = self.to_array().map(T::decode_with::<M>);
        Rgb::new(r, g, b)
    }
}
