//! The matrix that turns basic counts into XYZ, lux or any other linear result.

use crate::color::Xyz;
use crate::math::const_for;
use crate::sensor::{BasicCounts, ReadingError};

/// A matrix that turns the basic counts of `C` channels into XYZ, lux or `D` other results.
///
/// The results are XYZ (`D` = 3), illuminance or PPFD alone (`D` = 1), or anything else that is linear in the
/// light. The first call is [`xyz`](Self::xyz), or [`apply`](Self::apply) for other results. Y is in lux if
/// the calibration was made in lux, or if it was [scaled](Self::scaled) to one known illuminance.
///
/// A calibration comes from measured patches ([`Fit`](crate::sensor::Fit)), from a reconstruction that an eye
/// looks at ([`Reconstruction::seen_by`](crate::sensor::Reconstruction::seen_by)), or from the maker's
/// application note ([`from_rows`](Self::from_rows)). Corrections that are linear and constant become part of
/// the matrix while compiling: [`behind_glass`](Self::behind_glass), [`corrected`](Self::corrected),
/// [`without_crosstalk`](Self::without_crosstalk).
///
/// # Example
///
/// ```
/// use nanospectra::sensor::{BasicCounts, Calibration, ReadingError};
///
/// static TO_XYZ: Calibration<2> = Calibration::from_rows([[0.9, 0.1], [0.4, 0.6], [-0.2, 1.1]]);
/// let basic = BasicCounts::new([10.0, 20.0]);
/// let xyz = TO_XYZ.xyz(&basic)?;
/// assert!((xyz.y - 16.0).abs() < 1e-5); // 0.4 * 10 + 0.6 * 20
/// assert_eq!(TO_XYZ.apply(&basic)[1], xyz.y);
/// assert_eq!(TO_XYZ.rows()[1], [0.4, 0.6]);
/// // A light that only the first channel sees would have a negative Z.
/// let red = TO_XYZ.xyz(&BasicCounts::new([10.0, 0.0]));
/// assert!(matches!(red, Err(ReadingError::Negative { xyz }) if xyz.z == -2.0));
///
/// // A reference meter reads 480 lx of the same light: Y in lux from here on.
/// let to_lux = TO_XYZ.scaled(480.0 / xyz.y);
/// assert!((to_lux.xyz(&basic)?.y - 480.0).abs() < 1e-3);
/// // Behind a diffuser that passes 80 %, the same counts stand for more light.
/// assert!((to_lux.behind_glass(0.8).xyz(&basic)?.y - 600.0).abs() < 1e-3);
/// // Another chip counts half as much in the second channel.
/// let other = to_lux.corrected(&[1.0, 2.0]).xyz(&BasicCounts::new([10.0, 10.0]))?;
/// assert!((other.y - 480.0).abs() < 1e-3);
/// # Ok::<(), ReadingError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub struct Calibration<const C: usize, const D: usize = 3>([[f32; C]; D]);

impl<const C: usize> Calibration<C> {
    /// Computes the tristimulus values of one reading. See the [example](#example).
    ///
    /// # Errors
    /// `Negative`, with the sums, if one of them is below zero. NaN stays NaN.
    #[inline]
    pub fn xyz(&self, basic: &BasicCounts<C>) -> Result<Xyz, ReadingError> {
        positive(self.apply(basic).into())
    }
}

impl<const C: usize, const D: usize> Calibration<C, D> {
    /// Takes the rows of a matrix, where row `d` holds the weight of each channel in result `d`. See the
    /// [example](#example).
    #[must_use]
    pub const fn from_rows(rows: [[f32; C]; D]) -> Self {
        Calibration(rows)
    }

    /// Multiplies basic counts by the matrix, whatever the sign of the results. See the [example](#example).
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

    /// Multiplies every result by `k`.
    ///
    /// To have Y in lux, show a light to the sensor and to a reference lux meter, and pass what the lux meter
    /// reads divided by the Y that this calibration gives. See the [example](#example).
    #[must_use]
    pub const fn scaled(mut self, k: f32) -> Self {
        const_for!(0..D, |d| const_for!(0..C, |c| self.0[d][c] *= k));
        self
    }

    /// Adapts the calibration of one chip to another of its kind. See the [example](#example).
    ///
    /// `factors` times the counts of the other chip are the counts of the one that was calibrated (the golden
    /// device).
    #[must_use]
    pub const fn corrected(mut self, factors: &[f32; C]) -> Self {
        const_for!(0..D, |d| const_for!(0..C, |c| self.0[d][c] *= factors[c]));
        self
    }

    /// Corrects for a window or a diffuser in front of the chip, which passes `transmittance` (above 0) of
    /// every wavelength alike. See the [example](#example).
    ///
    /// Colored glass belongs in the responsivities: [`Observer::through`](crate::Observer::through).
    #[must_use]
    pub const fn behind_glass(self, transmittance: f32) -> Self {
        self.scaled(1.0 / transmittance)
    }

    /// Corrects for channels that leak into each other.
    ///
    /// Count `i` is the sum over `j` of `crosstalk[i][j]` times the count that channel `j` would have had
    /// without leakage. Weights and leakages beyond 1e15 in size, and leakages below 1e-15 that are not zero,
    /// may give infinity or NaN.
    ///
    /// ```
    /// # use nanospectra::sensor::{BasicCounts, Calibration};
    /// // A tenth of the second channel leaks into the first one.
    /// static LEAK: [[f32; 2]; 2] = [[1.0, 0.1], [0.0, 1.0]];
    /// static TO_XYZ: Calibration<2> = nanospectra::const_unwrap!(
    ///     Calibration::from_rows([[0.9, 0.1], [0.4, 0.6], [0.0, 1.1]]).without_crosstalk(&LEAK)
    /// );
    /// let y = TO_XYZ.apply(&BasicCounts::new([12.0, 20.0]))[1]; // without leakage: 10 and 20
    /// assert!((y - 16.0).abs() < 1e-5);
    /// ```
    ///
    /// # Cost
    /// On a Cortex-M4F 8 channels take 600 bytes of stack at opt-level 3 and 550 at "s", 18 channels 1,920
    /// and 1,820.
    ///
    /// # Errors
    /// [`CrosstalkError`] when the leakage cannot be undone, which is when a pivot of the elimination is
    /// below 1e-4 of its row.
    pub const fn without_crosstalk(mut self, crosstalk: &[[f32; C]; C]) -> Result<Self, CrosstalkError> {
        // With M the matrix of the leakage and W the rows here, the new rows V solve V M = W. This is Gauss's
        // elimination on M's transpose, with the largest pivot of each column.
        let mut m = [[0.0; C]; C];
        const_for!(0..C, |i| {
            let mut largest = 0.0;
            const_for!(0..C, |j| {
                let size = crosstalk[j][i].abs();
                largest = if size > largest { size } else { largest };
            });
            // Rows of equal size, so that a pivot can be judged by its size.
            let unit = if largest > 0.0 { 1.0 / largest } else { 0.0 };
            const_for!(0..C, |j| m[i][j] = crosstalk[j][i] * unit);
            const_for!(0..D, |d| self.0[d][i] *= unit);
        });
        let mut k = 0;
        while k < C {
            let (mut pivot, mut size) = (k, m[k][k].abs());
            const_for!(k + 1..C, |i| {
                if m[i][k].abs() > size {
                    (pivot, size) = (i, m[i][k].abs());
                }
            });
            // (The pivot is always below C; saying so keeps the code for a panic out of firmware.)
            if pivot != k && pivot < C {
                m.swap(k, pivot);
                const_for!(0..D, |d| {
                    self.0[d].swap(k, pivot);
                });
            }
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

    /// Returns the rows, which hold the weight of each channel in each result. See the [example](#example).
    #[must_use]
    pub const fn rows(&self) -> &[[f32; C]; D] {
        &self.0
    }
}

/// Returns the color, if no sum is negative.
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

/// Why cross-talk cannot be undone, which is that it mixes channels so that they cannot be told apart again.
///
/// [`Calibration::without_crosstalk`] returns it.
///
/// ```
/// # use nanospectra::sensor::{Calibration, CrosstalkError};
/// // Both channels count the same sum.
/// let leak = [[0.5, 0.5], [0.5, 0.5]];
/// let to_lux = Calibration::from_rows([[0.4, 0.6]]);
/// assert_eq!(to_lux.without_crosstalk(&leak), Err(CrosstalkError));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CrosstalkError;

impl CrosstalkError {
    /// Returns the reason as a text, which [`const_unwrap!`](crate::const_unwrap) shows when it stops a
    /// build.
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
