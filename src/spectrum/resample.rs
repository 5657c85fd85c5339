//! From one grid of bins to another, keeping the power.

use crate::grid::{Grid, Layout};
use crate::spectrum::{Outside, Quantity, Spectrum};

impl<Q: Quantity, const N: usize, G: Grid> Spectrum<Q, N, G> {
    /// The averages over the bins of another grid, each bin here taken as constant: power over
    /// any range that both grids tile is conserved.
    ///
    /// Beyond its data a light is zero, a factor keeps its end values ([`Quantity::OUTSIDE`]). The target is
    /// named by the caller: `light.resample::<31, Bins<400, 700>>()`.
    ///
    /// # Accuracy
    /// The same grid gives the same bits, a constant stays exactly constant; power is conserved
    /// within 5e-7.
    #[must_use]
    pub fn resample<const M: usize, H: Grid>(&self) -> Spectrum<Q, M, H> {
        self.resample_outside(Q::OUTSIDE)
    }

    /// As [`resample`](Self::resample), where `outside` says what lies beyond the data.
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

    /// The average over `low..high`, where `k` is the first bin that ends above `low`. Pieces of one value
    /// have exactly that average.
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
