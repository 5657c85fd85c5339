//! How the bins of usual spectra vary together.

use crate::grid::Grid;
use crate::math::const_for;
use crate::sensor::calibrate::vector::{largest, sqrt};
use crate::spectrum::Light;

/// Computes how the bins of these lights vary together, for
/// [`Reconstruction::wiener`](crate::sensor::Reconstruction::wiener).
///
/// It is the covariance about zero, the mean of the products of two bins, with each light scaled to unit
/// mean. The common shape of the lights is part of it, so that a reconstruction does not need a mean spectrum
/// beside it. A light whose bins sum to zero or less is left out. Without lights all entries are 0.
///
/// ```
/// # use nanospectra::{Light, Nodes, sensor::covariance_of};
/// let flat: Light<2, Nodes<450, 650>> = Light::flat(4.0); // is scaled to [1, 1]
/// let red = Light::from_bins([0.0, 8.0]); // is scaled to [0, 2]
/// assert_eq!(covariance_of(&[flat, red]), [[0.5, 0.5], [0.5, 2.5]]); // means of the products
/// ```
///
/// # Cost
/// On a Cortex-M4F 31 bins take 3,920 bytes of stack at opt-level 3 and 3,900 at "s", most of them for the
/// result.
#[must_use]
pub const fn covariance_of<const N: usize, G: Grid>(lights: &[Light<N, G>]) -> [[f32; N]; N] {
    let mut products = [[0.0; N]; N];
    let mut used = 0;
    const_for!(0..lights.len(), |k| {
        let values = lights[k].values();
        let size = largest(values);
        let mut sum = 0.0;
        const_for!(0..N, |n| sum += values[n] / size);
        if size != 0.0 && (sum > 0.0 || sum.is_nan()) {
            let unit = N as f32 / sum / size;
            const_for!(0..N, |i| {
                let mut j = 0;
                while j <= i {
                    products[i][j] += (values[i] * unit) * (values[j] * unit);
                    j += 1;
                }
            });
            used += 1;
        }
    });
    let mut i = 0;
    while i < N && used > 0 {
        let mut j = 0;
        while j <= i {
            products[i][j] /= used as f32;
            products[j][i] = products[i][j];
            j += 1;
        }
        i += 1;
    }
    products
}

/// Computes L of L L' = `covariance` by Cholesky's steps, with the bin first of whose variance the largest
/// share is left. It ends where only rounding is left, so that what six lamps span has six columns.
///
/// Shares are compared and not variances, because each entry is rounded in proportion to the bins that it
/// belongs to: beside the line of a sodium lamp the digits of all other bins would count as rounding.
pub(super) const fn semidefinite_root<const N: usize>(covariance: &[[f32; N]; N]) -> [[f32; N]; N] {
    let (mut left, mut columns) = ([0.0; N], [[0.0; N]; N]);
    const_for!(0..N, |i| left[i] = covariance[i][i]);
    let mut k = 0;
    while k < N {
        let (mut pivot, mut most) = (0, 0.0);
        let mut i = 0;
        // (A NaN is chosen as the pivot and spreads.)
        while i < N && most >= 0.0 {
            let share = if left[i] > 0.0 || left[i].is_nan() { left[i] / covariance[i][i] } else { 0.0 };
            if share > most || share.is_nan() {
                (pivot, most) = (i, share);
            }
            i += 1;
        }
        // (A pivot is below N; saying so keeps the panic out of an image.)
        if most <= 8.0 * f32::EPSILON || pivot >= N {
            break;
        }
        let root = sqrt(left[pivot]);
        const_for!(0..N, |i| {
            let mut value = covariance[i][pivot];
            const_for!(0..k, |j| value -= columns[j][i] * columns[j][pivot]);
            columns[k][i] = value / root;
            left[i] -= columns[k][i] * columns[k][i];
        });
        left[pivot] = 0.0;
        k += 1;
    }
    columns
}
