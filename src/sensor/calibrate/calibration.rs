//! The matrix that turns basic counts into XYZ, lux or any other linear result.

use crate::color::Xyz;
use crate::math::const_for;
use crate::sensor::{BasicCounts, ReadingError};

/// A matrix from the basic counts of `C` channels to `D` results: XYZ (`D` = 3), illuminance or PPFD alone
/// (`D` = 1), or anything else that is linear.
///
/// It comes from measured patches ([`Fit`](crate::sensor::Fit)), from a reconstruction seen by an eye
/// ([`Reconstruction::seen_by`](crate::sensor::Reconstruction::seen_by)), or from the maker's application
/// note ([`from_rows`](Self::from_rows)). What is linear and constant in front of it folds in, while
/// compiling: [`behind_glass`](Self::behind_glass), [`corrected`](Self::corrected),
/// [`without_crosstalk`](Self::without_crosstalk).
///
/// Y is in lux if the calibration was made in lux, or scaled to one known illuminance.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub struct Calibration<const C: usize, const D: usize = 3>([[f32; C]; D]);

impl<const C: usize, const D: usize> Calibration<C, D> {
    /// A calibration with these rows: row `d` holds the weight of each channel in result `d`.
    #[must_use]
    pub const fn from_rows(rows: [[f32; C]; D]) -> Self {
        Calibration(rows)
    }

    /// The rows: the weight of each channel in each result.
    #[must_use]
    pub const fn rows(&self) -> &[[f32; C]; D] {
        &self.0
    }

    /// Multiplies basic counts by the matrix, without looking at the sign of the results.
    ///
    /// # Accuracy
    /// `C` units of 2^-24 of the sum of the terms' sizes at worst, and the same bits on every target.
    #[must_use]
    #[inline]
    pub fn apply(&self, basic: &BasicCounts<C>) -> [f32; D] {
        let mut sums = [0.0; D];
        for (sum, row) in sums.iter_mut().zip(&self.0) {
            for (weight, count) in row.iter().zip(basic.values()) {
                *sum += weight * count;
            }
        }
        sums
    }

    /// The same calibration with every result multiplied by `k`, as by a lux meter's reading over this one's.
    #[must_use]
    pub const fn scaled(mut self, k: f32) -> Self {
        const_for!(0..D, |d| const_for!(0..C, |c| self.0[d][c] *= k));
        self
    }

    /// The same calibration for another chip, whose channels multiplied by `factors` are those of the one
    /// that was calibrated (the golden device).
    #[must_use]
    pub const fn corrected(mut self, factors: &[f32; C]) -> Self {
        const_for!(0..D, |d| const_for!(0..C, |c| self.0[d][c] *= factors[c]));
        self
    }

    /// The same calibration for a chip behind a window or a diffuser that passes `transmittance` (above 0) of
    /// every wavelength alike. Glass with a color belongs into the responsivities:
    /// [`Observer::through`](crate::Observer::through).
    #[must_use]
    pub const fn behind_glass(self, transmittance: f32) -> Self {
        self.scaled(1.0 / transmittance)
    }

    /// The same calibration for counts in which channels leak into each other: count `i` is the sum over `j`
    /// of `crosstalk[i][j]` times the true one.
    ///
    /// # Errors
    /// [`CrosstalkError`] when the leakage cannot be undone: a pivot of the elimination is below 1e-4 of its
    /// row.
    pub const fn without_crosstalk(mut self, crosstalk: &[[f32; C]; C]) -> Result<Self, CrosstalkError> {
        // With M the matrix of the leakage and W the rows here, the new rows solve V M = W: Gauss on M's
        // transpose, with the largest pivot of each column.
        let mut m = [[0.0; C]; C];
        const_for!(0..C, |i| {
            let mut largest = 0.0;
            const_for!(0..C, |j| {
                let size = crosstalk[j][i].abs();
                largest = if size > largest { size } else { largest };
            });
            // Rows of equal size, so that a pivot can be judged.
            let unit = if largest > 0.0 { 1.0 / largest } else { 0.0 };
            const_for!(0..C, |j| m[i][j] = crosstalk[j][i] * unit);
            const_for!(0..D, |d| self.0[d][i] *= unit);
        });
        let mut k = 0;
        while k < C {
            let mut pivot = k;
            const_for!(k + 1..C, |i| {
                if m[i][k].abs() > m[pivot][k].abs() {
                    pivot = i;
                }
            });
            m.swap(k, pivot);
            const_for!(0..D, |d| {
                self.0[d].swap(k, pivot);
            });
            if m[k][k].is_nan() || m[k][k].abs() <= 1e-4 {
                return Err(CrosstalkError);
            }
            const_for!(0..C, |i| {
                if i != k {
                    let factor = m[i][k] / m[k][k];
                    const_for!(k..C, |j| m[i][j] -= factor * m[k][j]);
                    const_for!(0..D, |d| self.0[d][i] -= factor * self.0[d][k]);
                }
            });
            k += 1;
        }
        const_for!(0..C, |k| const_for!(0..D, |d| self.0[d][k] /= m[k][k]));
        Ok(self)
    }
}

impl<const C: usize> Calibration<C> {
    /// The tristimulus values of one reading.
    ///
    /// # Errors
    /// `Negative`, with the sums, if one of them is below zero. NaN stays NaN.
    #[inline]
    pub fn xyz(&self, basic: &BasicCounts<C>) -> Result<Xyz, ReadingError> {
        positive(self.apply(basic).into())
    }
}

/// The color, if no sum is negative.
#[inline]
pub(in crate::sensor) fn positive(xyz: Xyz) -> Result<Xyz, ReadingError> {
    if xyz.x < 0.0 || xyz.y < 0.0 || xyz.z < 0.0 {
        return Err(ReadingError::Negative { xyz });
    }
    Ok(xyz)
}

#[cfg(feature = "defmt")]
impl<const C: usize, const D: usize> defmt::Format for Calibration<C, D> {
    fn format(&self, fmt: defmt::Formatter<'_>) {
        for row in &self.0 {
            defmt::write!(fmt, "{} ", row.as_slice());
        }
    }
}

/// Why cross-talk cannot be undone: it mixes channels so that they cannot be told apart again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CrosstalkError;

impl CrosstalkError {
    /// The reason, for [`const_unwrap!`](crate::const_unwrap) too.
    #[must_use]
    pub const fn message(&self) -> &'static str {
        "the cross-talk mixes channels so that they cannot be told apart again"
    }
}

impl core::fmt::Display for CrosstalkError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(self.message())
    }
}

impl core::error::Error for CrosstalkError {}
