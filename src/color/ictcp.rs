//! ICtCp, the constant intensity signal of high dynamic range television.

use core::marker::PhantomData;

use crate::color::matrix::{Matrix, Matrix64, apply, inverse64, rounded};
use crate::color::transfer::{Hlg, Pq, Transfer};
use crate::color::{Bt2020, Rgb};
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::math::{Math, sqrt};

/// A transfer function that ICtCp takes: [`Pq`] or [`Hlg`], each with a matrix of its own.
///
/// See the [example](Ictcp#example).
pub trait IctcpTransfer: Transfer {
    /// The rows of I, Ct and Cp as multiples of 1/4096 of the encoded cone signals, as BT.2100 prints them.
    const ROWS: [[f64; 3]; 3];
}

impl IctcpTransfer for Pq {
    const ROWS: [[f64; 3]; 3] =
        [[2048.0, 2048.0, 0.0], [6610.0, -13613.0, 7003.0], [17933.0, -17390.0, -543.0]];
}
impl IctcpTransfer for Hlg {
    const ROWS: [[f64; 3]; 3] = [[2048.0, 2048.0, 0.0], [3625.0, -7465.0, 3840.0], [9500.0, -9212.0, -288.0]];
}

/// From linear BT.2020 to the cone signals, in 1/4096.
const TO_CONES: Matrix64 = [[1688.0, 2146.0, 262.0], [683.0, 2951.0, 462.0], [99.0, 309.0, 3688.0]];

const fn per_4096(m: &Matrix64) -> Matrix64 {
    let [a, b, c] = *m;
    [
        [a[0] / 4096.0, a[1] / 4096.0, a[2] / 4096.0],
        [b[0] / 4096.0, b[1] / 4096.0, b[2] / 4096.0],
        [c[0] / 4096.0, c[1] / 4096.0, c[2] / 4096.0],
    ]
}

const CONES: Matrix = rounded(&per_4096(&TO_CONES));
const FROM_CONES: Matrix = rounded(&inverse64(&per_4096(&TO_CONES)));

/// A color that is given as the signal ICtCp of BT.2100, by transfer function `T`, [`Pq`] or [`Hlg`].
///
/// [`Ictcp::from_rgb`] makes it of linear BT.2020, and [`Ictcp::rgb`] leads back. With [`Pq`], equal steps
/// are about equally visible at every brightness, and [`Ictcp::delta_e_itp`] counts them.
///
/// # Example
/// ```
/// # #[cfg(feature = "libm")] {
/// use nanospectra::color::{Bt2020, Ictcp, Rgb, transfer::Pq};
/// // The reference white of BT.2408, 203 cd/m2: gray, and 58 % of the signal.
/// let white = Ictcp::<Pq>::from_rgb(Rgb::new(0.0203, 0.0203, 0.0203));
/// assert!((white.i - 0.5807).abs() < 1e-4 && white.ct.abs() < 1e-6 && white.cp.abs() < 1e-6);
/// let back: Rgb<Bt2020> = white.rgb().unwrap();
/// assert!((back.g - 0.0203).abs() < 1e-6);
/// # }
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ictcp<T = Pq> {
    /// The intensity I, which is 0 for black and 1 for full scale.
    ///
    /// See the [example](Ictcp#example).
    pub i: f32,
    /// The coordinate Ct, which goes from yellow (negative) to blue, "tritan".
    ///
    /// See the [example](Ictcp#example).
    pub ct: f32,
    /// The coordinate Cp, which goes from green (negative) to red, "protan".
    ///
    /// See the [example](Ictcp#example).
    pub cp: f32,
    transfer: PhantomData<T>,
}

impl<T: IctcpTransfer> Ictcp<T> {
    const OPPONENTS: Matrix = rounded(&per_4096(&T::ROWS));
    const SIGNALS: Matrix = rounded(&inverse64(&per_4096(&T::ROWS)));

    /// Makes a color from I, Ct and Cp.
    ///
    /// See the [example](Ictcp::delta_e_itp).
    #[must_use]
    pub const fn new(i: f32, ct: f32, cp: f32) -> Self {
        Ictcp { i, ct, cp, transfer: PhantomData }
    }

    /// Converts linear BT.2020, on the scale of the transfer function, to ICtCp.
    ///
    /// With [`Pq`], 1 is 10 000 cd/m2; with [`Hlg`], 1 is the peak of the scene. A cone signal below zero, of
    /// an imaginary color, is encoded as the transfer function says. See the [example](Ictcp#example).
    ///
    /// # Accuracy
    /// With [`Pq`] 1.2e-6, with [`Hlg`] 6e-7; with [`Pq`] there and back 1.2e-5 of 10 000 cd/m2 (searched in
    /// `tests/color/worst_conversions.rs`).
    ///
    /// # Cost
    /// On a Cortex-M4F it takes 1030 instructions with [`Pq`] and 240 with [`Hlg`].
    ///
    /// # Reference
    /// ITU-R BT.2100-2, table 7.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn from_rgb(rgb: Rgb<Bt2020>) -> Self {
        Self::from_rgb_with::<Portable>(rgb)
    }

    /// Converts as [`from_rgb`](Self::from_rgb) does, by the elementary functions of the math backend `M`.
    #[must_use]
    pub fn from_rgb_with<M: Math>(rgb: Rgb<Bt2020>) -> Self {
        let signals = apply(&CONES, rgb.to_array()).map(T::encode_with::<M>);
        let [i, ct, cp] = apply(&Self::OPPONENTS, signals);
        Ictcp::new(i, ct, cp)
    }

    /// Converts the color back to linear BT.2020.
    ///
    /// The result is `None` where a cone signal is beyond what the transfer function can decode. NaN stays
    /// NaN. See the [example](Ictcp#example).
    ///
    /// # Cost
    /// On a Cortex-M4F it takes 1100 instructions with [`Pq`] and 289 with [`Hlg`].
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn rgb(self) -> Option<Rgb<Bt2020>> {
        self.rgb_with::<Portable>()
    }

    /// Converts as [`rgb`](Self::rgb) does, by the elementary functions of the math backend `M`.
    #[must_use]
    pub fn rgb_with<M: Math>(self) -> Option<Rgb<Bt2020>> {
        let cones = apply(&Self::SIGNALS, [self.i, self.ct, self.cp]).map(T::decode_with::<M>);
        if cones.iter().any(|cone| cone.is_infinite()) {
            return None;
        }
        let [r, g, b] = apply(&FROM_CONES, cones);
        Some(Rgb::new(r, g, b))
    }
}

impl Ictcp<Pq> {
    /// Computes the color difference of BT.2124 to another color, where 1 is just visible.
    ///
    /// # Reference
    /// ITU-R BT.2124-0.
    ///
    /// # Example
    /// ```
    /// use nanospectra::color::{Ictcp, transfer::Pq};
    /// // The example of colour-science 0.4.7: 1.426572.
    /// let one = Ictcp::<Pq>::new(0.488_546_8, -0.047_393_51, 0.074_754_01);
    /// let other = Ictcp::<Pq>::new(0.489_920_3, -0.045_675_08, 0.073_613_42);
    /// assert!((one.delta_e_itp(other) - 1.426_572).abs() < 1e-4);
    /// ```
    #[must_use]
    pub fn delta_e_itp(self, other: Self) -> f32 {
        let [i, t, p] = [self.i - other.i, 0.5 * (self.ct - other.ct), self.cp - other.cp];
        720.0 * sqrt(i * i + t * t + p * p)
    }
}
