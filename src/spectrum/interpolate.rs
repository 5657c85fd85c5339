//! From the nodes of one grid to those of another: straight lines, or Sprague's quintic.

use crate::grid::{Grid, Layout};
use crate::spectrum::{Fine, Outside, Quantity, Spectrum};

/// How to read between samples. The choice moves xy by up to 3.4e-4, so it has a name.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Interpolation {
    /// Straight lines between samples: what a 5 nm lamp table means, and the reference rule here.
    #[default]
    Linear,
    /// Sprague's fifth-order polynomial (CIE 167:2005) with its boundary formula: smooth, may
    /// overshoot beside a line; needs six samples at one spacing.
    Sprague,
}

impl<Q: Quantity, const N: usize, G: Grid> Spectrum<Q, N, G> {
    /// This spectrum at every nanometer of 360..=830, by straight lines between the centers of its bins: what
    /// the CIE's sums ask of a table. Beyond its data a light is zero, a factor keeps its end values
    /// ([`Quantity::OUTSIDE`]).
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

    /// Reads this spectrum at the bin centers of another grid; `const`, as [`fine`](Self::fine).
    ///
    /// With fewer than six bands Sprague's interpolation falls back to straight lines. Beyond its data a
    /// light is zero, a factor keeps its end values ([`Quantity::OUTSIDE`]).
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

    /// As [`interpolate`](Self::interpolate), where `outside` says what lies beyond the data.
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
                // (The index is below N; saying so keeps the panic out of an image.)
                let reference = if place.reference < N { self.0[place.reference] } else { 0.0 };
                let (mut sum, mut j) = (0.0, 0);
                while j < 6 && place.start + j < N {
                    // Zero times a NaN is a NaN: what has no weight must not count.
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

/// Where a wavelength falls among `n` regular samples, as weights of at most six of them.
///
/// The value is the sample at `reference` plus the weighted deviations from it: exact on a
/// sample, and exact for a constant.
pub(crate) struct Place {
    pub(crate) reference: usize,
    pub(crate) start: usize,
    pub(crate) weights: [f32; 6],
}

impl Place {
    /// `distance` from the first of `n` samples `step` apart, 0..=(n - 1) * step.
    pub(crate) const fn of(distance: f32, step: f32, n: usize, by: Interpolation) -> Self {
        // The cell first and the place in it after: both exact on whole nanometers.
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

    /// CIE 167:2005: the quintic over samples `cell - 2 ..= cell + 3`; two beyond each end come
    /// from the boundary formula, whose weights are added to those of the six samples there.
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
