//! Spectra of 16-bit samples to XYZ, or to any channels, in integers.

use crate::grid::{Bands, Bins};
use crate::math::const_for;
use crate::observer::Observer;
use crate::spectrum::Quantity;
use core::marker::PhantomData;

/// Looks at spectra of 16-bit samples with weights of 16 bits, as an [`Observer`] does in floats.
///
/// [`new`](Self::new) makes it from an observer in a `static`, [`sees`](Self::sees) reads samples, and
/// [`unit`](Self::unit) says what the sums stand for. The weights are stored with an offset, so that none is
/// negative and all use the 16 bits; the offset times the sum of the samples is subtracted again.
///
/// # Example
///
/// ```
/// # use nanospectra::{Curve, Factor, Observer, light::FL11, observer::CIE_1931};
/// # use nanospectra::sensor::fixed::FixedObserver;
/// static EYE: Observer<3, 16> = CIE_1931
///     .under(&FL11.fine())
///     .fold(Curve::Spline)
///     .with_white_y(100.0);
/// static FIXED: FixedObserver<3, 16> = FixedObserver::new(&EYE).unwrap();
/// // White paper, where 50 000 stands for a reflectance of 1.
/// let y = FIXED.sees(&[50_000; 16])[1] as f32 * FIXED.unit() / 50_000.0;
/// assert!((y - 100.0).abs() < 0.005);
/// ```
///
/// # Accuracy
/// Each weight is within 2^-17 of the span of all weights: 3e-5 of full scale at worst for 81 bands to XYZ.
///
/// # Cost
/// 81 bands to XYZ take 1260 instructions on a Cortex-M0, where floats take 54 000; `2 C N` bytes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FixedObserver<const C: usize, const N: usize, G = Bins<380, 730>> {
    /// The weight of each band in each sum, plus `offset`.
    rows: [[u16; N]; C],
    offset: u32,
    /// By how much products are shifted right, so that `N` of the largest stay below 2^31.
    shift: u32,
    unit: f32,
    grid: PhantomData<G>,
}

impl<const C: usize, const N: usize, G: Bands> FixedObserver<C, N, G> {
    /// Turns the weights of `observer` into integers. See the [example](#example).
    ///
    /// `None` if all its weights are zero, if one is NaN or infinite, or if there are more than 4096 bands.
    /// It computes in f64, so call it in a `const` or a `static`.
    #[must_use]
    pub const fn new<Q: Quantity>(observer: &Observer<C, N, Q, G>) -> Option<Self> {
        let rows = observer.weights();
        let (mut least, mut most) = (0.0_f64, 0.0_f64);
        let (mut c, mut n);
        c = 0;
        while c < C {
            n = 0;
            while n < N {
                let weight = rows[c][n] as f64;
                if !weight.is_finite() {
                    return None;
                }
                least = if weight < least { weight } else { least };
                most = if weight > most { weight } else { most };
                n += 1;
            }
            c += 1;
        }
        if most <= least || N > 4096 {
            return None;
        }
        let step = (most - least) / 65_535.0;
        let offset = (-least / step + 0.5) as u32;
        let mut fixed = [[0; N]; C];
        const_for!(0..C, |c| {
            const_for!(0..N, |n| {
                let units = rows[c][n] as f64 / step + offset as f64 + 0.5;
                fixed[c][n] = if units < 65_535.0 { units as u16 } else { 65_535 };
            });
        });
        // There are N products below 2^32, and as much again to subtract.
        let mut shift = 2;
        while N >> (shift - 2) > 0 {
            shift += 1;
        }
        let unit = (step * (1_u64 << shift) as f64) as f32;
        Some(FixedObserver { rows: fixed, offset, shift: shift as u32, unit, grid: PhantomData })
    }

    /// Computes the sums of this observer, in units of [`unit`](Self::unit). See the [example](#example).
    ///
    /// They are below 2^30 in size, whatever the samples.
    #[must_use]
    #[inline]
    pub fn sees(&self, samples: &[u16; N]) -> [i32; C] {
        let total = samples.iter().map(|sample| u32::from(*sample)).sum::<u32>();
        // offset * total is below N * 2^32, so its two halves are taken in turn.
        let lifted = (((total >> 16) * self.offset) << (16 - self.shift))
            + (((total & 0xffff) * self.offset) >> self.shift);
        let mut sums = [0; C];
        for (sum, row) in sums.iter_mut().zip(&self.rows) {
            *sum = self.dot(row, samples) as i32 - lifted as i32;
        }
        sums
    }

    /// Returns what one unit of the sums stands for, if a sample of 1 stands for 1. See the
    /// [example](#example).
    ///
    /// For samples that are scaled by `k`, a unit stands for `unit() / k`.
    #[must_use]
    pub const fn unit(&self) -> f32 {
        self.unit
    }

    /// Sums eight products at a time, written out. A loop over the rows inside one over the samples takes a
    /// third more instructions on a Cortex-M0, and twice as many at opt-level "s".
    #[inline]
    fn dot(&self, row: &[u16; N], samples: &[u16; N]) -> u32 {
        let product = |a: u16, b: u16| (u32::from(a) * u32::from(b)) >> self.shift;
        let (weights, weights_left) = row.as_chunks::<8>();
        let (samples, samples_left) = samples.as_chunks::<8>();
        let mut sum = 0;
        for (w, s) in weights.iter().zip(samples) {
            sum += product(w[0], s[0]) + product(w[1], s[1]) + product(w[2], s[2]) + product(w[3], s[3]);
            sum += product(w[4], s[4]) + product(w[5], s[5]) + product(w[6], s[6]) + product(w[7], s[7]);
        }
        for (weight, sample) in weights_left.iter().zip(samples_left) {
            sum += product(*weight, *sample);
        }
        sum
    }
}
