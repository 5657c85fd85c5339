//! sigma(q0 x^2 + q1 x + q2): three numbers that are a curve over the wavelength.

use crate::grid::{Grid, Layout};
use crate::math::const_for;
use crate::upsample::rsqrt::rsqrt;

/// A smooth curve within 0..=1: the sigmoid of a quadratic in the wavelength.
///
/// The three numbers are q0, q1, q2 of `sigma(q0 x^2 + q1 x + q2)` with x = (wavelength - 580 nm) / 200 nm,
/// whatever the grid: a shape that was solved on one grid can be read on any other. Those of sRGB colors
/// are at most 50 in size and so fit f16, at its three digits.
///
/// Do not interpolate the numbers: the spectrum half way between two shapes is not that of the color half
/// way. Interpolate RGB before, or spectra after.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Shape {
    /// q0, q1, q2.
    pub q: [f32; 3],
}

/// x = 0, in nm.
const CENTER_NM: f64 = 580.0;
/// x = 1 is this much above it, in nm.
const REACH_NM: f64 = 200.0;

impl Shape {
    /// The curve at a wavelength in nm, 0..=1.
    ///
    /// ```
    /// use nanospectra::upsample::Shape;
    /// let edge = Shape { q: [0.0, 20.0, 0.0] }; // a step up at 580 nm
    /// assert_eq!(edge.at(580.0), 0.5);
    /// assert!(edge.at(480.0) < 0.01 && edge.at(680.0) > 0.99);
    /// ```
    ///
    /// # Accuracy
    /// Of the sigmoid itself 3.4e-7 relative, however near to 0 (`tests/upsample/digits.rs`).
    #[must_use]
    #[inline]
    pub fn at(self, nm: f32) -> f32 {
        self.at_x((nm - CENTER_NM as f32) * (1.0 / REACH_NM) as f32)
    }

    /// `offset + scale * curve` at the centers of the bins of a grid; eight at a time, the rest filled up to
    /// eight.
    #[inline]
    pub(super) fn on_grid<const N: usize, G: Grid>(self, offset: f32, scale: f32) -> [f32; N] {
        let eight = |x: &[f32; 8]| {
            let mut values = [0.0; 8];
            for (value, x) in values.iter_mut().zip(x) {
                *value = offset + scale * self.at_x(*x);
            }
            values
        };
        let mut values = [0.0; N];
        let (x8, x_rest) = const { &X::<G, N>::ALL }.as_chunks::<8>();
        let (values8, values_rest) = values.as_chunks_mut::<8>();
        for (values, x) in values8.iter_mut().zip(x8) {
            *values = eight(x);
        }
        let mut filled_up = [0.0; 8];
        for (slot, x) in filled_up.iter_mut().zip(x_rest) {
            *slot = *x;
        }
        if !N.is_multiple_of(8) {
            for (value, share) in values_rest.iter_mut().zip(eight(&filled_up)) {
                *value = share;
            }
        }
        values
    }

    #[inline(always)]
    fn at_x(self, x: f32) -> f32 {
        let [q0, q1, q2] = self.q;
        sigmoid((q0 * x + q1) * x + q2)
    }
}

/// 1/2 + p / (2 sqrt(1 + p^2)) without the cancellation, which takes all digits at p = -1e4.
#[inline(always)]
pub(super) fn sigmoid(p: f32) -> f32 {
    let size = p.abs();
    let r = rsqrt(1.0 + size * size);
    // Beyond 1e18 the square is near its overflow, and the share below 1e-36.
    let small = 0.5 * r * r / (1.0 + size * r);
    let small = if size > 1e18 { 0.0 } else { small };
    let large = 1.0 - small;
    if p < 0.0 { small } else { large }
}

/// The centers of a grid as x.
pub(super) struct X<G, const N: usize>(core::marker::PhantomData<G>);

impl<G: Grid, const N: usize> X<G, N> {
    pub(super) const ALL: [f32; N] = {
        let mut all = [0.0; N];
        const_for!(0..N, |k| {
            let center = Layout::<G, N>::START + (k as f64 + 0.5) * Layout::<G, N>::WIDTH;
            all[k] = ((center - CENTER_NM) / REACH_NM) as f32;
        });
        all
    };
}
