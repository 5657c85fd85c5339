//! Conversion from one grid of bins to another that conserves power.

use crate::grid::{Grid, Layout};
use crate::spectrum::{Outside, Quantity, Spectrum};

impl<Q: Quantity, const N: usize, G: Grid> Spectrum<Q, N, G> {
    /// Returns the averages over the bins of another grid, where each bin of this spectrum is taken as
    /// constant.
    ///
    /// Power over any range that both grids tile is conserved. Beyond its data a light is zero, and a factor
    /// keeps its end values ([`Quantity::OUTSIDE`]).
    ///
    /// ```
    /// # use nanospectra::{Bins, Light};
    /// let fine = Light::<4, Bins<400, 600>>::from_bins([1.0, 3.0, 5.0, 7.0]);
    /// let coarse = fine.resample::<2, Bins<400, 600>>();
    /// assert_eq!(coarse.values(), &[2.0, 6.0]);
    /// assert_eq!(coarse.power(), fine.power());
    /// ```
    ///
    /// # Accuracy
    /// Resampling to the same grid gives the same bits, and a constant stays exactly constant. Power is
    /// conserved within 5e-7.
    #[must_use]
    pub fn resample<const M: usize, H: Grid>(&self) -> Spectrum<Q, M, H> {
        self.resample_outside(Q::OUTSIDE)
    }

    /// Resamples as [`resample`](Self::resample) does, where `outside` says what lies beyond the data.
    ///
    /// ```
    /// # use nanospectra::{Bins, Light, Outside};
    /// let short = Light::<2, Bins<500, 600>>::from_bins([1.0, 3.0]);
    /// let held = short.resample_outside::<4, Bins<450, 650>>(Outside::Hold);
    /// assert_eq!(held.values(), &[1.0, 1.0, 3.0, 3.0]);
    /// ```
    #[must_use]
    pub fn resample_outside<const M: usize, H: Grid>(&self, outside: Outside) -> Spectrum<Q, M, H> {
        let mut values = [0.0; M];
        let mut k = 0;
        for (j, value) in values.iter_mut().enumerate() {
            let (low, high) = (Layout::<H, M>::edge_units(j), Layout::<H, M>::edge_units(j + 1));
            while k < N && Layout::<G, N>::edge_units(k + 1) <= low {
                k += 1;
            }
            *value = self.average(k, low, high, outside);
        }
        Spectrum::from_bins(values)
    }

    /// The average over `low..high`, where `k` is the first bin that ends above `low`. If all pieces have one
    /// value, the average is exactly that value.
    fn average(&self, mut k: usize, low: i64, high: i64, outside: Outside) -> f32 {
        let (mut from, mut first, mut all_equal, mut sum) = (low, None, true, 0.0);
        while from < high {
            let (to, value) = if from < Layout::<G, N>::edge_units(0) {
                (Layout::<G, N>::edge_units(0), outside.beyond(self.0.first().copied().unwrap_or(0.0)))
            } else if let Some(value) = self.0.get(k) {
                k += 1;
                (Layout::<G, N>::edge_units(k), *value)
            } else {
                (high, outside.beyond(self.0.last().copied().unwrap_or(0.0)))
            };
            let to = if to < high { to } else { high };
            all_equal &= *first.get_or_insert(value) == value;
            sum += (to - from) as f32 * value;
            from = to;
        }
        if all_equal { first.unwrap_or(0.0) } else { sum / (high - low) as f32 }
    }
}
