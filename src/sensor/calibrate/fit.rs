//! Calibration by measured patches: the matrix from counts to XYZ with the least error on them.

use crate::color::Xyz;
use crate::math::const_for;
use crate::sensor::calibrate::qr::{Triangle, condition, forward};
use crate::sensor::calibrate::vector::{dot, largest, norm, sqrt};
use crate::sensor::{BasicCounts, Calibration};
use core::fmt;

/// Calibrates a sensor by least squares from measured patches of known XYZ.
///
/// Start with [`new`](Self::new), add patches ([`add_relative`](Self::add_relative), or [`add`](Self::add)
/// with a weight of your own), then [`solve`](Self::solve). Patches are not stored: 4 (C (C + D) + D + 1)
/// bytes are enough, 368 for the eight channels of an AS7341, whether 12 patches come or 300. Any `D` numbers
/// can take the place of XYZ.
///
/// A patch is any light whose XYZ is known: a chart under a lamp beside a reference meter, or the lamp alone.
/// Include lights of the kind that the sensor will meet, since a matrix made under one lamp is right for that
/// lamp.
///
/// # Example
///
/// ```
/// use nanospectra::sensor::{BasicCounts, Fit}; // Two channels and lux, which are 3 a + 2 b here.
/// let mut fit = Fit::<2, 1>::new();
/// for (a, b) in [(1.0, 0.0), (1.0, 1.0), (2.0, 5.0)] {
///     let lux = 3.0 * a + 2.0 * b;
///     fit.add(&BasicCounts::new([a, b]), [lux], 1.0 / lux);
/// }
/// let to_lux = fit.solve()?;
/// let [lux] = to_lux.apply(&BasicCounts::new([10.0, 10.0]));
/// assert!((lux - 50.0).abs() < 1e-4);
/// // How far off it is: on the patches themselves, and on one of them if it had not been used.
/// assert_eq!(fit.patches(), 3);
/// assert!(fit.residual_rms()[0] < 1e-5);
/// let [error] = fit.leave_one_out(&BasicCounts::new([1.0, 1.0]), [5.0], 1.0 / 5.0)?;
/// assert!(error.abs() < 1e-4);
/// // The channels can be told apart well: this is 1 at best.
/// assert!(fit.condition()? < 10.0);
/// # Ok::<(), nanospectra::sensor::FitError>(())
/// ```
///
/// # Accuracy
/// Coefficients are within 1e-4 of the largest in their row, for the 99 samples of CIE 224 under any lamps
/// that [`light::named`](crate::light::named) knows, where narrow lines leave the channels least apart
/// (searched in `tests/sensor/worst_readings.rs`). Under FL2 and FL11 they are within 1.5e-5, for counts and
/// targets from 1e-30 to 1e28. The fit works on the counts and not on their squares, which would lose
/// twice the digits.
///
/// What a calibration is worth is another matter. An AS7341 fitted to the 99 samples of CIE 224 under FL2,
/// FL11 and LED-B3 measures the lamps of CIE 15 within 0.8 % in illuminance and 1.4 % in CCT in the mean, 4.7
/// and 10.2 % at worst, under red-green-blue LEDs and discharge lamps (`tests/sensor/as7341.rs`, with noise).
/// The residual on the patches, 0.7 % of Y, does not show this, so include lamps of the kind to be measured
/// among the patches.
///
/// # Cost
/// 2.1 KB of code at opt-level "s" on a Cortex-M4F. It runs in `const fn` too, where 24 patches take 14
/// thousand steps of evaluation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit<const C: usize, const D: usize = 3> {
    triangle: Triangle<C, D>,
    patches: u32,
}

impl<const C: usize, const D: usize> Default for Fit<C, D> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const C: usize, const D: usize> Fit<C, D> {
    /// Starts a fit that does not have any patches yet. See the [example](#example).
    #[must_use]
    pub const fn new() -> Self {
        Fit { triangle: Triangle::new(), patches: 0 }
    }

    /// Adds a patch: its counts, what they should come to, and the weight of its error. See the
    /// [example](#example).
    ///
    /// With XYZ as the target, Y in lux makes a calibration in lux. The fit makes the sum of (weight *
    /// error)^2 least. With weight 1 the brightest patches decide. With 1 / Y
    /// ([`add_relative`](Self::add_relative)) the error counts relative to each patch's brightness, as it
    /// does for eyes and for noise. A patch of weight 0 is ignored. Do not add lights that saturate the
    /// sensor.
    ///
    /// # Cost
    /// `C` + `D` square roots, some 4 `C` + 2 `D` divisions, 2 `C` (`C` + 2 `D`) multiplications.
    pub const fn add(&mut self, basic: &BasicCounts<C>, target: [f32; D], weight: f32) {
        if weight == 0.0 {
            return;
        }
        self.triangle.absorb(weighted(*basic.values(), weight), weighted(target, weight));
        self.patches = self.patches.saturating_add(1);
    }

    /// Computes the calibration whose weighted squared errors on the patches are least. See the
    /// [example](#example).
    ///
    /// # Cost
    /// On a Cortex-M4F 8 channels take 930 bytes of stack at opt-level 3 and 690 at "s", 18 channels 2,180
    /// and 2,170.
    ///
    /// # Errors
    /// `TooFew` patches for `C` channels; `IllConditioned` if the patches do not tell the channels apart, so
    /// that rounding alone would move the matrix by more than 1 % (one channel never counts, or two always
    /// count alike); `NotFinite` if NaN, infinity or an overflow (beyond 1e30) came in.
    pub const fn solve(&self) -> Result<Calibration<C, D>, FitError> {
        match self.condition() {
            Ok(_) => finite(self.triangle.solve()),
            Err(error) => Err(error),
        }
    }

    /// Computes the error that a fit made without this patch has on it (result minus `target`), which is the
    /// honest error on a light that the calibration has not seen. See the [example](#example).
    ///
    /// The patch must be one that was added, with the same weight. No second fit is needed: the error of the
    /// full fit is divided by 1 - h, where the leverage h says how much of the patch's own result comes from
    /// itself.
    ///
    /// # Errors
    /// Those that [`solve`](Self::solve) without the patch would have. `IllConditioned` also if the patch
    /// decides nearly all of its own result, so that rounding alone would move the error by more than 1 %.
    ///
    /// # Cost
    /// A `solve` each time.
    pub const fn leave_one_out(
        &self,
        basic: &BasicCounts<C>,
        target: [f32; D],
        weight: f32,
    ) -> Result<[f32; D], FitError> {
        let condition = match self.condition() {
            Ok(condition) => condition,
            Err(error) => return Err(error),
        };
        let h_root = norm(&forward(self.triangle.factor(), weighted(*basic.values(), weight)));
        let others = (1.0 - h_root) * (1.0 + h_root);
        if self.patches as usize <= C && weight != 0.0 {
            return Err(FitError::TooFew { patches: self.patches.saturating_sub(1), needed: C });
        }
        if others.is_nan() {
            return Err(FitError::NotFinite);
        }
        // The error of h grows by this much in what is left without the patch.
        if let Err(error) = usable(if others > 0.0 { condition / others } else { f32::INFINITY }) {
            return Err(error);
        }
        let matrix = self.triangle.solve();
        let mut errors = target;
        let mut d = 0;
        while d < D {
            errors[d] = (dot(&matrix[d], basic.values()) - target[d]) / others;
            if !errors[d].is_finite() {
                return Err(FitError::NotFinite);
            }
            d += 1;
        }
        Ok(errors)
    }

    /// Computes the root mean square of weight * error over the patches, for each result. See the
    /// [example](#example).
    ///
    /// With weights 1 / Y it is the relative error. It says how wrong the matrix is on the patches it was
    /// made from; on others it is more, as [`leave_one_out`](Self::leave_one_out) tells. It is 0 without
    /// patches.
    #[must_use]
    pub const fn residual_rms(&self) -> [f32; D] {
        let mut rms = *self.triangle.rest();
        let mut d = 0;
        while d < D && self.patches > 0 {
            rms[d] /= sqrt(self.patches as f32);
            d += 1;
        }
        rms
    }

    /// Computes how much an error of the counts is magnified in the matrix: 1 at best, 10 to 100 for lamps
    /// and eight channels. See the [example](#example).
    ///
    /// It is the largest singular value of the patches' counts over the smallest, weighted, each channel
    /// relative to its size.
    ///
    /// # Errors
    /// As [`solve`](Self::solve).
    pub const fn condition(&self) -> Result<f32, FitError> {
        if (self.patches as usize) < C {
            return Err(FitError::TooFew { patches: self.patches, needed: C });
        }
        usable(condition(self.triangle.factor()))
    }

    /// Returns the number of patches that were added. See the [example](#example).
    #[must_use]
    pub const fn patches(&self) -> u32 {
        self.patches
    }
}

impl<const C: usize> Fit<C, 3> {
    /// Adds a patch of known XYZ with the weight 1 / Y, so that its error counts relative to its brightness.
    ///
    /// A patch whose Y is zero or less cannot be weighed like this and is ignored.
    ///
    /// ```
    /// # use nanospectra::{color::Xyz, sensor::{BasicCounts, Fit}};
    /// let mut fit = Fit::<2>::new();
    /// fit.add_relative(&BasicCounts::new([1.0, 0.0]), Xyz::new(0.9, 0.4, 0.0));
    /// fit.add_relative(&BasicCounts::new([1.0, 1.0]), Xyz::new(1.0, 1.0, 1.1));
    /// let xyz = fit.solve()?.apply(&BasicCounts::new([10.0, 20.0]));
    /// assert!((xyz[1] - 16.0).abs() < 1e-4); // 0.4 * 10 + 0.6 * 20
    /// # Ok::<(), nanospectra::sensor::FitError>(())
    /// ```
    pub const fn add_relative(&mut self, basic: &BasicCounts<C>, xyz: Xyz) {
        if xyz.y > 0.0 || xyz.y.is_nan() {
            self.add(basic, [xyz.x, xyz.y, xyz.z], 1.0 / xyz.y);
        }
    }
}

const fn weighted<const N: usize>(mut row: [f32; N], weight: f32) -> [f32; N] {
    const_for!(0..N, |n| row[n] *= weight);
    row
}

/// Returns the condition, if rounding moves the result by less than 1 % under it.
pub(super) const fn usable(condition: f32) -> Result<f32, FitError> {
    if condition.is_nan() {
        Err(FitError::NotFinite)
    } else if condition * f32::EPSILON > 1e-2 {
        Err(FitError::IllConditioned { condition })
    } else {
        Ok(condition)
    }
}

const fn finite<const C: usize, const D: usize>(rows: [[f32; C]; D]) -> Result<Calibration<C, D>, FitError> {
    let mut d = 0;
    while d < D {
        if !largest(&rows[d]).is_finite() {
            return Err(FitError::NotFinite);
        }
        d += 1;
    }
    Ok(Calibration::from_rows(rows))
}

/// Says why no calibration or spectrum could be computed from the given patches or counts.
///
/// # Example
///
/// ```
/// use nanospectra::sensor::{BasicCounts, Fit, FitError};
///
/// let mut fit = Fit::<2, 1>::new();
/// fit.add(&BasicCounts::new([1.0, 1.0]), [5.0], 1.0);
/// assert_eq!(fit.solve(), Err(FitError::TooFew { patches: 1, needed: 2 }));
/// // A second patch of the same color does not tell the channels apart.
/// fit.add(&BasicCounts::new([2.0, 2.0]), [10.0], 1.0);
/// assert!(matches!(fit.solve(), Err(FitError::IllConditioned { .. })));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum FitError {
    /// There are fewer patches than channels. See the [example](#example).
    TooFew {
        /// How many patches there are, where those of weight 0 do not count.
        patches: u32,
        /// The smallest number of patches that can determine the matrix. Three times as many are a good
        /// choice.
        needed: usize,
    },
    /// The channels cannot be told apart. See the [example](#example).
    IllConditioned {
        /// The largest singular value over the smallest, with channels scaled to equal size. It is infinite
        /// if one channel is always 0.
        condition: f32,
    },
    /// A number is NaN or infinite, or a computation overflowed.
    NotFinite,
    /// The search for a positive spectrum has not ended within the steps that it was given.
    NotConverged {
        /// How many steps the search has taken.
        iterations: u32,
    },
}

impl FitError {
    /// Returns the reason without its numbers, for [`const_unwrap!`](crate::const_unwrap).
    #[must_use]
    pub const fn message(&self) -> &'static str {
        match self {
            Self::TooFew { .. } => "there are fewer patches than channels: measure more patches that differ",
            Self::IllConditioned { .. } => {
                "the channels cannot be told apart: measure more different colors, \
                 leave out a channel that never counts, or use a larger alpha"
            }
            Self::NotFinite => {
                "a count, a target or a weight is not finite, alpha is negative, or numbers are beyond 1e30: \
                 check the numbers, or scale them"
            }
            Self::NotConverged { .. } => {
                "no positive spectrum was found: allow more steps or use a larger alpha"
            }
        }
    }
}

impl fmt::Display for FitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.message())?;
        match self {
            Self::TooFew { patches, needed } => write!(f, " ({patches} patches for {needed} channels)"),
            Self::IllConditioned { condition } if condition.is_finite() => {
                write!(f, " (condition {condition:e})")
            }
            // An infinite condition is no number that a person can compare.
            Self::IllConditioned { .. } | Self::NotFinite => Ok(()),
            Self::NotConverged { iterations } => write!(f, " (after {iterations} steps)"),
        }
    }
}

impl core::error::Error for FitError {}
