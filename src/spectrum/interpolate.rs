//! Interpolation from the nodes of one grid to those of another, by straight lines or by Sprague's quintic.

use crate::grid::{Grid, Layout};
use crate::spectrum::{Fine, Outside, Quantity, Spectrum};

/// Says how values between samples are read.
///
/// The choice moves the chromaticity xy of a lamp by up to 3.4e-4, so it is stated by name.
///
/// # Example
/// ```
/// use nanospectra::{Fine, Interpolation, Power, light::FL11};
///
/// let lines: Fine<Power> = FL11.interpolate(Interpolation::Linear);
/// let smooth: Fine<Power> = FL11.interpolate(Interpolation::Sprague);
/// // Both go through the samples, here every 5 nm, and differ between them.
/// let at = |nm: usize| (lines.values()[nm - 360], smooth.values()[nm - 360]);
/// assert_eq!(at(545).0, at(545).1);
/// assert_ne!(at(543).0, at(543).1);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Interpolation {
    /// Joins neighboring samples by straight lines, which is how a lamp's 5 nm table is meant and the
    /// reference rule of this crate.
    #[default]
    Linear,
    /// Draws Sprague's fifth-order polynomial (CIE 167:2005, with its boundary formula) through six samples
    /// at one spacing. It is smooth, but may overshoot beside a spectral line.
    Sprague,
}

impl<Q: Quantity, const N: usize, G: Grid> Spectrum<Q, N, G> {
    /// Returns this spectrum at every nanometer of 360..=830 nm, interpolated by straight lines between the
    /// centers of its bins.
    ///
    /// The CIE defines tristimulus values as sums on this grid, so this is the first step from a table to
    /// XYZ. Beyond its data a light is zero, and a factor keeps its end values ([`Quantity::OUTSIDE`]).
    ///
    /// ```
    /// # use nanospectra::{Fine, Power, light::FL11};
    /// static FL11_FINE: Fine<Power> = FL11.fine();
    /// assert_eq!(FL11_FINE.values()[545 - 360], FL11.values()[(545 - 380) / 5]);
    /// // The table ends at 780 nm.
    /// assert_eq!(FL11_FINE.values()[800 - 360], 0.0);
    /// ```
    #[must_use]
    pub const fn fine(&self) -> Fine<Q> {
        self.interpolate(Interpolation::Linear)
    }

    /// Reads this spectrum at the bin centers of another grid, at compile time if you like.
    ///
    /// This suits grids of narrow bins; use [`resample`](Self::resample) to go to wide bins. With fewer than
    /// six bands Sprague's interpolation falls back to straight lines. Beyond its data a light is zero, and a
    /// factor keeps its end values ([`Quantity::OUTSIDE`]).
    ///
    /// ```
    /// # use nanospectra::{Fine, Interpolation, Power, light::FL11};
    /// static SMOOTH: Fine<Power> = FL11.interpolate(Interpolation::Sprague);
    /// assert_eq!(SMOOTH.values()[545 - 360], FL11.values()[(545 - 380) / 5]);
    /// ```
    #[must_use]
    pub const fn interpolate<const M: usize, H: Grid>(&self, by: Interpolation) -> Spectrum<Q, M, H> {
        self.interpolate_outside(by, Q::OUTSIDE)
    }

    /// Interpolates as [`interpolate`](Self::interpolate) does, where `outside` says what lies beyond the
    /// data.
    ///
    /// ```
    /// # use nanospectra::{Fine, Interpolation, Outside, Power, light::FL11};
    /// // The table ends at 780 nm; hold its last value to 830 nm.
    /// let held: Fine<Power> = FL11.interpolate_outside(Interpolation::Linear, Outside::Hold);
    /// assert_eq!(held.values()[830 - 360], *FL11.values().last().unwrap_or(&0.0));
    /// ```
    #[must_use]
    pub const fn interpolate_outside<const M: usize, H: Grid>(
        &self,
        by: Interpolation,
        outside: Outside,
    ) -> Spectrum<Q, M, H> {
        let (first, step) = (Layout::<G, N>::FIRST_CENTER, Layout::<G, N>::STEP);
        let mut values = [0.0; M];
        let mut k = 0;
        while k < M {
            let nm = Layout::<H, M>::center(k);
            values[k] = if nm < first {
                outside.beyond(self.0[0])
            } else if nm > Layout::<G, N>::LAST_CENTER {
                outside.beyond(self.0[N - 1])
            } else {
                let place = Place::of(nm - first, step, N, by);
                // (The index is below N; this check keeps the code for a panic out of firmware.)
                let reference = if place.reference < N { self.0[place.reference] } else { 0.0 };
                let (mut sum, mut j) = (0.0, 0);
                while j < 6 && place.start + j < N {
                    // Zero times NaN is NaN, so a sample without weight must not be added.
                    if place.weights[j] != 0.0 {
                        sum += place.weights[j] * (self.0[place.start + j] - reference);
                    }
                    j += 1;
                }
                reference + sum
            };
            k += 1;
        }
        Spectrum::from_bins(values)
    }
}

/// The place of a wavelength among `n` regular samples, as weights of at most six of them.
///
/// The value is the sample at `reference` plus the weighted deviations from it, which is exact on a sample
/// and for a constant.
pub(crate) struct Place {
    pub(crate) reference: usize,
    pub(crate) start: usize,
    pub(crate) weights: [f32; 6],
}

impl Place {
    /// The place at `distance` from the first of `n` samples that are `step` apart; 0..=(n - 1) * step.
    pub(crate) const fn of(distance: f32, step: f32, n: usize, by: Interpolation) -> Self {
        // Computing first the cell and then the place in it makes both exact on whole nanometers.
        let mut cell = (distance / step) as usize;
        if cell + 2 > n {
            cell = n.saturating_sub(2);
        }
        let t = (distance - cell as f32 * step) / step;
        match by {
            Interpolation::Sprague if n >= 6 => Self::sprague(cell, t, n),
            _ => Place { reference: cell, start: cell, weights: [0.0, t, 0.0, 0.0, 0.0, 0.0] },
        }
    }

    /// The quintic of CIE 167:2005 over samples `cell - 2 ..= cell + 3`. Two samples beyond each end are
    /// given by the boundary formula, whose weights are added to those of the six samples there.
    const fn sprague(cell: usize, t: f32, n: usize) -> Self {
        let quintic = quintic(t);
        let mut start = cell.saturating_sub(2);
        if start + 6 > n {
            start = n - 6;
        }
        let mut weights = [0.0; 6];
        let mut j = 0;
        while j < 6 {
            // Sample cell - 2 + j, or its stand-in beyond an end.
            let k = cell + j;
            if k < 2 {
                let outer = &BEYOND[if k == 0 { 1 } else { 0 }];
                let mut i = 0;
                while i < 6 {
                    weights[i] += quintic[j] * outer[i];
                    i += 1;
                }
            } else if k - 2 >= n {
                let outer = &BEYOND[if k - 2 > n { 1 } else { 0 }];
                let mut i = 0;
                while i < 6 {
                    weights[5 - i] += quintic[j] * outer[i];
                    i += 1;
                }
            } else if k - 2 - start < 6 {
                weights[k - 2 - start] += quintic[j];
            }
            j += 1;
        }
        Place { reference: cell, start, weights }
    }
}

/// Sprague's weights of six samples, from two before `t` to three after, 0 <= t <= 1 between the middle ones.
pub(crate) const fn quintic(t: f32) -> [f32; 6] {
    [
        t * (2.0 + t * (-1.0 + t * (-9.0 + t * (13.0 - 5.0 * t)))) / 24.0,
        t * (-16.0 + t * (16.0 + t * (39.0 + t * (-64.0 + 25.0 * t)))) / 24.0,
        1.0 + t * t * (-30.0 + t * (-70.0 + t * (126.0 - 50.0 * t))) / 24.0,
        t * (16.0 + t * (16.0 + t * (66.0 + t * (-124.0 + 50.0 * t)))) / 24.0,
        t * (-2.0 + t * (-1.0 + t * (-33.0 + t * (61.0 - 25.0 * t)))) / 24.0,
        t * t * t * (7.0 + t * (-12.0 + 5.0 * t)) / 24.0,
    ]
}

/// The sample one step beyond an end, and the one two steps beyond, from the six inside, nearest first.
pub(crate) const BEYOND: [[f32; 6]; 2] = [
    [508.0 / 209.0, -540.0 / 209.0, 488.0 / 209.0, -367.0 / 209.0, 144.0 / 209.0, -24.0 / 209.0],
    [884.0 / 209.0, -1960.0 / 209.0, 3033.0 / 209.0, -2648.0 / 209.0, 1080.0 / 209.0, -180.0 / 209.0],
];
