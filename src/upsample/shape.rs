//! A curve over the wavelength that three numbers describe: sigma(q0 x^2 + q1 x + q2).

use crate::grid::{Grid, Layout};
use crate::math::const_for;
use crate::upsample::rsqrt::rsqrt;

/// A smooth curve over the wavelength that three numbers describe and whose values lie within 0..=1.
///
/// It is the sigmoid of a quadratic, `sigma(q0 x^2 + q1 x + q2)`, with `sigma(p) = 1/2 + p / (2 sqrt(1 +
/// p^2))` and x = (wavelength - 580 nm) / 200 nm. Since x does not depend on the grid, a shape that was
/// solved on one grid can be read on any other. The numbers of sRGB colors are at most 50 in size and so fit
/// f16, with its three digits.
///
/// Do not interpolate the three numbers: the curve half way between two shapes does not have the color half
/// way between their colors. Interpolate the RGB before, or the spectra after.
///
/// # Example
/// ```
/// use nanospectra::upsample::Shape;
/// let edge = Shape { q: [0.0, 20.0, 0.0] }; // a step up at 580 nm
/// assert_eq!(edge.at(580.0), 0.5);
/// assert!(edge.at(480.0) < 0.01 && edge.at(680.0) > 0.99);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Shape {
    /// The numbers q0, q1 and q2 that describe the curve.
    pub q: [f32; 3],
}

/// The wavelength in nm at which x is 0.
const CENTER_NM: f64 = 580.0;
/// The distance in nm over which x grows by 1.
const REACH_NM: f64 = 200.0;

impl Shape {
    /// Returns the value of the curve at a wavelength in nm, within 0..=1. See the [example](#example).
    ///
    /// # Accuracy
    /// The sigmoid itself is within 3.4e-7, relative, however near to 0 it is (`tests/upsample/digits.rs`).
    #[must_use]
    #[inline]
    pub fn at(self, nm: f32) -> f32 {
        self.at_x((nm - CENTER_NM as f32) * (1.0 / REACH_NM) as f32)
    }

    /// Returns `offset + scale * curve` at the centers of the bins of a grid. Eight are computed at a time,
    /// and the rest are filled up to eight.
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

/// Returns 1/2 + p / (2 sqrt(1 + p^2)), computed without the cancellation, which at p = -1e4 would leave no
/// digit.
#[inline(always)]
pub(super) fn sigmoid(p: f32) -> f32 {
    let size = p.abs();
    let r = rsqrt(1.0 + size * size);
    // Beyond 1e18 the square is near overflow, and the result is below 1e-36.
    let small = 0.5 * r * r / (1.0 + size * r);
    let small = if size > 1e18 { 0.0 } else { small };
    let large = 1.0 - small;
    if p < 0.0 { small } else { large }
}

/// The values of x at the centers of the bins of a grid.
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
