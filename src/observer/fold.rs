//! Folding: the conversion of an observer from 1 nm to `N` bins that keeps the color of the light itself.
//!
//! The `N` numbers of a coarse spectrum are averages over bins. A *conservative* reconstruction draws a curve
//! that has those averages. The response of the fine observer to that curve is linear in the averages, and
//! its coefficients are the folded weights. Every such curve reproduces a constant, so the color of the light
//! itself (or of a white surface) is the same at every `N`.

use crate::grid::{Grid, Layout};
use crate::math::const_for;
use crate::observer::Observer;
use crate::spectrum::Quantity;

/// Says which curve a folded observer assumes between the averages over bins.
///
/// [`Observer::fold`] takes it; see the [example](Observer::fold) there. [`Spline`](Curve::Spline) is the
/// choice for surfaces, and [`Step`](Curve::Step) for narrow filters and single lines, or where no weight may
/// be negative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Curve {
    /// The spectrum is taken as constant within each bin, so weights are never negative. This suits narrow
    /// filters and single lines.
    Step,
    /// The spectrum is taken, in each bin, as the parabola that has the averages of this bin and its two
    /// neighbors.
    Parabola,
    /// The spectrum is taken as the histospline, the smoothest of these curves: the derivative of the natural
    /// cubic spline through the cumulative sums. This suits surfaces, for which 16 bins are then better than
    /// 60 without a fold.
    Spline,
}

impl<const C: usize, const N: usize, Q: Quantity, G: Grid> Observer<C, N, Q, G> {
    /// Reduces this observer, which reads a spectrum at 1 nm, to one that reads averages over the `M` bins of
    /// the grid `H`. This is called folding.
    ///
    /// A spectrum of `M` averages does not say what happens within a bin. Folding assumes a [`Curve`] that
    /// has these averages, lets the fine observer look at the curve, and stores the result as `M` weights for
    /// each channel. Put the observer [`under`](Observer::under) a light *before* it is folded: then every
    /// spectral line of the light counts at its own wavelength, and the `M` numbers describe the smooth
    /// reflectance of a surface.
    ///
    /// Weights of the fine grid outside `H` go to the end bins. Nothing of a light that is included is lost,
    /// and a spectrum counts as if it kept its end values beyond `H`. For an eye on 380..730 nm this hardly
    /// matters. A silicon sensor reaches 1000 nm, so fold it to a grid that covers what it sees.
    ///
    /// This function is meant for constants: it takes 6 to 14 thousand steps of the compiler for three rows.
    /// It computes in f64 and rounds each weight once.
    ///
    /// ```
    /// use nanospectra::matter::TCS;
    /// use nanospectra::{Curve, Factor, FineObserver, Observer, light::FL11, observer::CIE_1931};
    ///
    /// // The eye under FL11 at 1 nm, with 471 weights a channel, and the same with 16.
    /// static FINE: FineObserver<3, Factor> = CIE_1931.under(&FL11.fine()).with_white_y(100.0);
    /// static FOLDED: Observer<3, 16> = FINE.fold(Curve::Spline);
    ///
    /// // Test color sample 1 of CIE 13.3, light grayish red, seen at 1 nm and as 16 averages.
    /// let (fine, folded) = (FINE.sees(&TCS[0]), FOLDED.sees(&TCS[0].resample()));
    /// assert!(fine.iter().zip(&folded).all(|(fine, folded)| (fine - folded).abs() < 0.05));
    /// ```
    ///
    /// # Accuracy
    /// The response to a constant is that of the fine observer within 4e-7 at every `M`. With
    /// `Curve::Spline` and 16 bins over 380..730 nm, surfaces under the CIE FL and LED lamps are
    /// within 0.06 CIEDE2000 in the mean.
    ///
    /// # Cost
    /// At run time three rows of 471 weights on 16 bins take 1,170 bytes of stack on a Cortex-M4F at
    /// opt-level 3 and 1,160 at "s", and 6,850 and 6,830 if [`under`](Observer::under) is called with it,
    /// whose result alone has 5,652 bytes.
    #[must_use]
    pub const fn fold<const M: usize, H: Grid>(&self, curve: Curve) -> Observer<C, M, Q, H> {
        const {
            assert!(
                Layout::<H, M>::START < Layout::<G, N>::END && Layout::<G, N>::START < Layout::<H, M>::END,
                "the grid to fold to does not overlap the observer's"
            );
        }
        // Where a cell of the fine grid is wider than half a bin, it may not be taken as a point.
        let fine = Layout::<G, N>::WIDTH * 2.0 <= Layout::<H, M>::WIDTH;
        let mut weights = [[0.0; M]; C];
        const_for!(0..C, |c| {
            let folded: [f64; M] = match curve {
                Curve::Step => Moments::of_cells::<N, G, H>(&self.0[c]).mass,
                Curve::Parabola => Moments::of_cells::<N, G, H>(&self.0[c]).parabola(),
                Curve::Spline if fine => Moments::of_points::<N, G, H>(&self.0[c]).spline(),
                Curve::Spline => Moments::of_cells::<N, G, H>(&self.0[c]).spline(),
            };
            const_for!(0..M, |k| weights[c][k] = round(folded[k]));
        });
        Observer::from_weights(weights)
    }
}

/// Rounds a weight to f32. A weight that is too small to matter becomes 0, because subnormals slow down every
/// sum.
const fn round(weight: f64) -> f32 {
    if -1e-30 < weight && weight < 1e-30 { 0.0 } else { weight as f32 }
}

/// The sum of the fine weights that fall into each bin, and their first and second moment about the center of
/// the bin, in units in which the bin reaches from -1/2 to 1/2.
struct Moments<const M: usize> {
    mass: [f64; M],
    first: [f64; M],
    second: [f64; M],
}

impl<const M: usize> Moments<M> {
    const NONE: Self = Moments { mass: [0.0; M], first: [0.0; M], second: [0.0; M] };

    /// The moments with each fine weight at a point: its node, or the outer edge of the grid if the node lies
    /// outside.
    const fn of_points<const N: usize, G: Grid, H: Grid>(row: &[f32; N]) -> Self {
        let mut moments = Self::NONE;
        const_for!(0..N, |n| {
            let node = Layout::<G, N>::START + (n as f64 + 0.5) * Layout::<G, N>::WIDTH;
            let (bin, t) = Self::place(bins_from_start::<M, H>(node));
            moments.mass[bin] += row[n] as f64;
            moments.first[bin] += row[n] as f64 * t;
            moments.second[bin] += row[n] as f64 * t * t;
        });
        moments
    }

    /// The moments with each fine weight spread evenly over its cell, which may lie across edges of bins.
    const fn of_cells<const N: usize, G: Grid, H: Grid>(row: &[f32; N]) -> Self {
        let mut moments = Self::NONE;
        const_for!(0..N, |n| {
            let start = Layout::<G, N>::START + n as f64 * Layout::<G, N>::WIDTH;
            let low = bins_from_start::<M, H>(start);
            let high = bins_from_start::<M, H>(start + Layout::<G, N>::WIDTH);
            let density = row[n] as f64 / (high - low);
            let mut from = low;
            while from < high {
                // The piece ends at the next edge; outside the grid, where the grid begins or the cell ends.
                let to = if from < 0.0 {
                    0.0
                } else if from >= M as f64 {
                    high
                } else {
                    (from as usize + 1) as f64
                };
                let to = if to < high { to } else { high };
                moments.add_piece(density, from, to);
                from = to;
            }
        });
        moments
    }

    const fn add_piece(&mut self, density: f64, from: f64, to: f64) {
        let mass = density * (to - from);
        let (bin, middle) = Self::place((from + to) / 2.0);
        let outside = from < 0.0 || from >= M as f64;
        let half = if outside { 0.0 } else { (to - from) / 2.0 };
        self.mass[bin] += mass;
        self.first[bin] += mass * middle;
        self.second[bin] += mass * (middle * middle + half * half / 3.0);
    }

    /// The bin of a position that is counted in bins from the grid's start, and the place in it, -1/2..=1/2.
    const fn place(position: f64) -> (usize, f64) {
        // (With the position compared as an integer no bounds check is needed, so that a fold at run time
        // contains no panic either.)
        let bin = position as usize;
        if position <= 0.0 {
            (0, -0.5)
        } else if bin >= M {
            (M - 1, 0.5)
        } else {
            (bin, position - bin as f64 - 0.5)
        }
    }

    /// The weights for parabolas. Bin k has the curve `s + (r - l)/2 t + (r - 2 s + l)/2 (t^2 - 1/12)`, where
    /// `s` is its average and `l` and `r` are those of its neighbors; an end bin continues its neighbor's
    /// parabola.
    const fn parabola(&self) -> [f64; M] {
        let mut weights = self.mass;
        if M < 3 {
            return if M == 2 { self.line() } else { weights };
        }
        const_for!(0..M, |k| {
            // (Written as limits, from which the compiler sees that all three bins exist: no panic is left.)
            let middle = if k < 1 {
                1
            } else if k > M - 2 {
                M - 2
            } else {
                k
            };
            let shift = k as f64 - middle as f64;
            // The moments about the middle bin's center, where t = (place in this bin) + shift.
            let first = self.first[k] + shift * self.mass[k];
            let second = self.second[k] + 2.0 * shift * self.first[k] + shift * shift * self.mass[k];
            let slope = first / 2.0;
            let bend = (second - self.mass[k] / 12.0) / 2.0;
            weights[k] -= self.mass[k];
            weights[middle] += self.mass[k] - 2.0 * bend;
            weights[middle - 1] += bend - slope;
            weights[middle + 1] += bend + slope;
        });
        weights
    }

    /// The weights for two bins, whose curve is the straight line with their averages.
    const fn line(&self) -> [f64; M] {
        // The line is s0 + (s1 - s0) p, with p counted from the center of the first bin.
        let mut weights = self.mass;
        let lever = self.first[0] + self.first[1] + self.mass[1];
        weights[0] = self.mass[0] + self.mass[1] - lever;
        weights[1] = lever;
        weights
    }

    /// The weights for the histospline. With m the second derivative of the cumulative sum at the inner
    /// edges, `m[i-1] + 4 m[i] + m[i+1] = 6 (s[i] - s[i-1])`, and m = 0 at both ends. The response is
    /// `mass . s + g . m`, so its weights are `mass + 6 D' T^-1 g`, which takes one solution of the
    /// transposed system.
    const fn spline(&self) -> [f64; M] {
        // g[i] belongs to the edge below bin i, for i in 1..M.
        let mut g = [0.0; M];
        const_for!(1..M, |i| g[i] = self.below(i - 1) + self.above(i));
        // T is symmetric, so eliminate upwards and then substitute back.
        let mut pivot = [4.0; M];
        const_for!(2..M, |i| {
            let factor = 1.0 / pivot[i - 1];
            pivot[i] -= factor;
            g[i] -= factor * g[i - 1];
        });
        let mut above = 0.0;
        const_for!(1..M, |k| {
            let i = M - k;
            above = (g[i] - above) / pivot[i];
            g[i] = above;
        });
        let mut weights = self.mass;
        const_for!(1..M, |i| {
            weights[i] += 6.0 * g[i];
            weights[i - 1] -= 6.0 * g[i];
        });
        weights
    }

    /// What `m` at a bin's upper edge contributes: the moment of (u^2)/2 - 1/6 with u = t + 1/2.
    const fn below(&self, k: usize) -> f64 {
        self.second[k] / 2.0 + self.first[k] / 2.0 - self.mass[k] / 24.0
    }

    /// What `m` at a bin's lower edge contributes: the moment of 1/6 - (1 - u)^2/2.
    const fn above(&self, k: usize) -> f64 {
        -self.second[k] / 2.0 + self.first[k] / 2.0 + self.mass[k] / 24.0
    }
}

/// A wavelength counted in bins from the start of the coarse grid.
const fn bins_from_start<const M: usize, H: Grid>(nm: f64) -> f64 {
    (nm - Layout::<H, M>::START) / Layout::<H, M>::WIDTH
}
