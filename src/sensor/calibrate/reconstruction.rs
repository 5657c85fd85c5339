//! Reconstruction: the matrix from the counts of a few channels to the likeliest spectrum.

use crate::grid::{Grid, by_fields};
use crate::math::const_for;
use crate::observer::Observer;
use crate::sensor::calibrate::fit::usable;
use crate::sensor::calibrate::prior::semidefinite_root;
use crate::sensor::calibrate::qr::{condition, damped_inverse};
use crate::sensor::calibrate::vector::{dot, largest, norm, sqrt, subtract};
use crate::sensor::{BasicCounts, Calibration, FitError};
use crate::spectrum::{Light, Power, Spectrum};
use crate::sum::rows;
use core::marker::PhantomData;

/// The damping `alpha` to begin with, which weighs the noise of the counts against the signal of a
/// reconstruction.
///
/// It is the variance of the noise over the variance that the channels' signals would have if every bin
/// varied for itself. For a sensor like the AS7341 every smaller value gives the same RMS error of
/// reflectances, 0.013, within 1.4 %, and only amplifies the noise of the counts. In f32, normal equations
/// (which this crate does not use) fail below 1e-6. A larger value darkens the light: 1e-1 costs 27 % in RMS.
/// See the [example](Reconstruction#example) of [`Reconstruction`].
pub const DEFAULT_ALPHA: f32 = 1e-2;

/// A matrix that turns the counts of `C` channels into the likeliest spectrum of `N` bins, power per nm.
///
/// Start with [`smooth`](Self::smooth). If only color is wanted, let an eye look at the spectrum while
/// compiling ([`seen_by`](Self::seen_by)), which makes a [`Calibration`]; otherwise call
/// [`spectrum`](Self::spectrum) with each reading.
///
/// Eight channels cannot tell 31 bins. What is missing comes from what spectra are usually like: smooth, or
/// like a set of lamps ([`wiener`](Self::wiener) with [`covariance_of`](crate::sensor::covariance_of)). The
/// responsivities must be those of the very chip; if they are not known, measure patches and use
/// [`Fit`](crate::sensor::Fit).
///
/// # Example
///
/// ```
/// use nanospectra::observer::CIE_1931;
/// use nanospectra::sensor::{BasicCounts, Calibration, DEFAULT_ALPHA, Reconstruction, chip::as7341};
/// use nanospectra::{Curve, Light, Nodes, Observer, Power};
///
/// type Grid = Nodes<400, 700>;
/// static CHIP: Observer<8, 31, Power, Grid> = as7341::NOMINAL.fold(Curve::Step);
/// static EYE: Observer<3, 31, Power, Grid> = CIE_1931.fold(Curve::Step);
/// let reconstruction = Reconstruction::smooth(&CHIP, 0.95, DEFAULT_ALPHA)?;
/// // A flat light of 2 W/nm comes back within 5 % in the middle.
/// let counts = BasicCounts::new(CHIP.sees(&Light::flat(2.0)));
/// assert!((reconstruction.spectrum(&counts).values()[15] - 2.0).abs() < 0.1);
/// // For its color alone, 24 numbers are enough: x and y of equal energy are 1/3.
/// let to_xyz: Calibration<8> = reconstruction.seen_by(&EYE);
/// let [x, y, z] = to_xyz.apply(&counts);
/// assert!((x / (x + y + z) - 1.0 / 3.0).abs() < 0.01 && (y / (x + y + z) - 1.0 / 3.0).abs() < 0.01);
/// # Ok::<(), nanospectra::sensor::FitError>(())
/// ```
///
/// # Accuracy
/// The matrix of [`smooth`](Self::smooth) is within 2e-6 of its largest entry for channels like the AS7341's,
/// of any heights and a little moved, at every alpha from 1e-6 to 0.1; within 8e-5 for channels 80 nm wide,
/// and within 2e-3 for 120 nm (searched in `tests/sensor/worst_chips.rs`). It comes from a QR factor of the
/// damped sensor, and not from its normal equations, which fail there in f32. Seen by an eye, an AS7341 with
/// *known* responsivities measures the lamps of CIE 15 within 0.9 % in illuminance and 1.8 % in CCT in the
/// mean, 3.4 and 6.4 % at worst, with the noise of a chip in its counts (`tests/sensor/as7341.rs`).
///
/// # Cost
/// It is made for `const`, though it may run on a device (4.8 KB of code). 8 channels on 31 bins take 17
/// thousand steps of evaluation and 30 ms of compile time, on 471 bins 160 thousand and 240 ms. (Rustc's
/// limit is two million steps.)
pub struct Reconstruction<const C: usize, const N: usize, G>([[f32; C]; N], PhantomData<G>);

by_fields!([const C: usize, const N: usize, G] Reconstruction<C, N, G>, "Reconstruction": 0);

impl<const C: usize, const N: usize, G: Grid> Reconstruction<C, N, G> {
    /// Reconstructs smooth spectra: bins `i` and `j` are expected to be correlated by `correlation`^|i - j|.
    /// See the [example](#example).
    ///
    /// `correlation` is 0 to 1: 0.95 for bins of 10 nm, 0.975 for 5 nm; 0 says nothing about neighbors
    /// ([`tikhonov`](Self::tikhonov)). `alpha` is the variance of the noise over that of the signals of bins
    /// that vary apart, [`DEFAULT_ALPHA`] or so.
    ///
    /// # Cost
    /// On a Cortex-M4F 8 channels on 31 bins take 4,080 bytes of stack at opt-level 3 and 4,110 at "s", on 81
    /// bins 8,610 and 8,340; the result is part of it.
    ///
    /// # Errors
    /// `IllConditioned` if `alpha` is so small that channels which see alike cannot be told apart, or if no
    /// channel sees anything; `NotFinite` if `alpha` is negative, `correlation` is beyond 1, or a weight is
    /// not finite.
    pub const fn smooth(
        sensor: &Observer<C, N, Power, G>,
        correlation: f32,
        alpha: f32,
    ) -> Result<Self, FitError> {
        let fresh = sqrt((1.0 - correlation) * (1.0 + correlation));
        // The covariance is L L' with L[i][j] = correlation^(i - j) * fresh, without `fresh` in column 0:
        // each bin is the one before times `correlation`, and something new.
        let mut a = *sensor.weights();
        const_for!(0..C, |c| {
            let (mut n, mut carried) = (N, 0.0);
            while n > 0 {
                n -= 1;
                carried = carried * correlation + a[c][n];
                a[c][n] = if n > 0 { fresh * carried } else { carried };
            }
        });
        let alpha = alpha * share(sensor.weights(), &a, 1.0);
        let scale = match solve(&mut a, alpha) {
            Ok(scale) => scale,
            Err(error) => return Err(error),
        };
        const_for!(0..C, |c| {
            const_for!(1..N, |n| a[c][n] = a[c][n - 1] * correlation + fresh * a[c][n]);
        });
        Self::scaled(&a, scale)
    }

    /// Computes the calibration that gives what an eye sees of the reconstructed spectrum. See the
    /// [example](#example).
    ///
    /// It has `D` x `C` numbers, 96 bytes for XYZ from eight channels. In a `static` the reconstruction
    /// itself is not in the program.
    #[must_use]
    pub const fn seen_by<const D: usize>(&self, eye: &Observer<D, N, Power, G>) -> Calibration<C, D> {
        let mut matrix = [[0.0; C]; D];
        const_for!(0..D, |d| {
            const_for!(0..N, |n| {
                const_for!(0..C, |c| matrix[d][c] += eye.weights()[d][n] * self.0[n][c]);
            });
        });
        Calibration::from_rows(matrix)
    }

    /// Computes the likeliest spectrum for these counts, power per nm in the unit of the sensor's
    /// responsivities. See the [example](#example).
    ///
    /// It may be negative in places, which [`nonnegative_spectrum`](crate::sensor::nonnegative_spectrum) is
    /// not.
    ///
    /// # Accuracy
    /// `C` units of 2^-24 of the sum of the terms' sizes at worst, and the same bits on every target.
    #[must_use]
    #[inline]
    pub fn spectrum(&self, basic: &BasicCounts<C>) -> Light<N, G> {
        Spectrum::from_bins(rows(&self.0, basic.values()))
    }

    /// Reconstructs the smallest spectrum that explains the counts, and supposes nothing about neighbors.
    ///
    /// Bins that no channel sees become 0. Use it for narrow lines; for lamps and surfaces
    /// [`smooth`](Self::smooth) is better.
    ///
    /// ```
    /// # use nanospectra::sensor::{BasicCounts, DEFAULT_ALPHA, Reconstruction};
    /// # use nanospectra::{Nodes, Observer, Power};
    /// // Two bins of 100 nm, and a channel that sees each of them.
    /// let rows = [[100.0, 0.0], [0.0, 100.0]];
    /// let chip: Observer<2, 2, Power, Nodes<450, 550>> = Observer::from_weights(rows);
    /// let reconstruction = Reconstruction::tikhonov(&chip, DEFAULT_ALPHA)?;
    /// let light = reconstruction.spectrum(&BasicCounts::new([101.0, 202.0]));
    /// assert!((light.values()[1] - 2.0).abs() < 1e-3); // 202 / 100, less the damping of 1 %
    /// # Ok::<(), nanospectra::sensor::FitError>(())
    /// ```
    ///
    /// # Errors
    /// As [`smooth`](Self::smooth).
    pub const fn tikhonov(sensor: &Observer<C, N, Power, G>, alpha: f32) -> Result<Self, FitError> {
        Self::smooth(sensor, 0.0, alpha)
    }

    /// Reconstructs spectra whose bins vary together as `covariance` says.
    ///
    /// `covariance` is symmetric: that of lamps by [`covariance_of`](crate::sensor::covariance_of), or
    /// anything computed. A variance that it says to be negative counts as none.
    ///
    /// # Accuracy
    /// For lamps of the CIE and channels like the AS7341's, the matrix is within (4e-5 + 6e-7 / `alpha`) of
    /// its largest entry, at every alpha from 1e-3 to 0.1. The second part is mostly the rounding of the
    /// covariance to f32: lamps that are nearly mixtures of others are told apart by its last digits
    /// (`tests/sensor/worst_priors.rs`).
    ///
    /// # Errors
    /// As [`smooth`](Self::smooth).
    ///
    /// # Cost
    /// A Cholesky factor of `N` bins (up to N^3 / 2 multiplications, N r^2 / 2 if `r` lamps span it) and its
    /// memory, 4 N^2 bytes. On a Cortex-M4F 8 channels on 31 bins take 8,120 bytes of stack at opt-level 3,
    /// and 7,100 at "s".
    pub const fn wiener(
        sensor: &Observer<C, N, Power, G>,
        covariance: &[[f32; N]; N],
        alpha: f32,
    ) -> Result<Self, FitError> {
        let columns = semidefinite_root(covariance);
        // The channels times the root of the covariance: L' G'.
        let mut a = [[0.0; N]; C];
        const_for!(0..C, |c| {
            const_for!(0..N, |j| a[c][j] = dot(&columns[j], &sensor.weights()[c]));
        });
        let mut variance = 0.0;
        const_for!(0..N, |n| variance += covariance[n][n]);
        let alpha = alpha * share(sensor.weights(), &a, variance / N as f32);
        let scale = match solve(&mut a, alpha) {
            Ok(scale) => scale,
            Err(error) => return Err(error),
        };
        const_for!(0..C, |c| {
            let mut spectrum = [0.0; N];
            const_for!(0..N, |j| subtract(&mut spectrum, -a[c][j], &columns[j]));
            a[c] = spectrum;
        });
        Self::scaled(&a, scale)
    }

    /// Returns the rows of the matrix, where row `n` says how much of each channel goes into bin `n`.
    #[must_use]
    pub const fn rows(&self) -> &[[f32; C]; N] {
        &self.0
    }

    const fn scaled(columns: &[[f32; N]; C], scale: f32) -> Result<Self, FitError> {
        let mut matrix = [[0.0; C]; N];
        let mut n = 0;
        while n < N {
            const_for!(0..C, |c| matrix[n][c] = columns[c][n] / scale);
            if !largest(&matrix[n]).is_finite() {
                return Err(FitError::NotFinite);
            }
            n += 1;
        }
        Ok(Reconstruction(matrix, PhantomData))
    }
}

/// The variance that signals would have if all bins varied apart, over the variance that they have. Both are
/// mean squares of rows.
const fn share<const C: usize, const N: usize>(
    apart: &[[f32; N]; C],
    together: &[[f32; N]; C],
    variance: f32,
) -> f32 {
    let (mut above, mut below) = ([0.0; C], [0.0; C]);
    const_for!(0..C, |c| {
        above[c] = norm(&apart[c]);
        below[c] = norm(&together[c]);
    });
    let (above, below) = (norm(&above), norm(&below));
    // A blind sensor has neither; what it is asked for is refused elsewhere.
    if below > 0.0 { (above / below) * (above / below) * variance } else { 1.0 }
}

/// Computes A (A' A + alpha s^2)^-1 in the place of A, where s^2 is the mean square of A's columns, times the
/// scale that is returned.
const fn solve<const C: usize, const N: usize>(a: &mut [[f32; N]; C], alpha: f32) -> Result<f32, FitError> {
    let mut norms = [0.0; C];
    const_for!(0..C, |c| norms[c] = norm(&a[c]));
    let scale = norm(&norms) / sqrt(C as f32);
    if !scale.is_finite() {
        return Err(FitError::NotFinite);
    }
    const_for!(0..C, |c| {
        const_for!(0..N, |n| a[c][n] /= scale);
    });
    if scale == 0.0 {
        return Err(FitError::IllConditioned { condition: f32::INFINITY });
    }
    let r = damped_inverse(a, sqrt(alpha));
    match usable(condition(&r)) {
        Ok(_) => Ok(scale),
        Err(error) => Err(error),
    }
}
