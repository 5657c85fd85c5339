//! What folding must give, by brute force: weight k of the small observer is the fine observer
//! looking at the curve reconstructed from the bins (0, .., 0, 1, 0, .., 0).

use super::linear::solve;

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reconstruction {
    /// Each bin is flat.
    Step,
    /// In each bin the parabola that has the averages of the bin and its two neighbors; an end bin
    /// goes on with its neighbor's parabola. Two bins make a line, one bin is flat.
    Parabola,
    /// The derivative of the natural cubic spline through the running integral at the edges: the
    /// curve is level at both ends.
    Spline,
    /// The same with not-a-knot ends: the outer two bins at each end share one parabola. Needs
    /// three bins, which are then one parabola.
    SplineNotAKnot,
}

/// N equal bins from `low` to `high` nm.
#[derive(Clone, Copy, Debug)]
pub struct EqualBins {
    pub low: f64,
    pub high: f64,
    pub count: usize,
}

impl EqualBins {
    pub fn width(&self) -> f64 {
        (self.high - self.low) / self.count as f64
    }

    pub fn edge(&self, index: usize) -> f64 {
        self.low + (self.high - self.low) * index as f64 / self.count as f64
    }

    fn index(&self, nm: f64) -> usize {
        (((nm - self.low) / self.width()).max(0.0) as usize).min(self.count - 1)
    }
}

/// A curve made from bin averages; outside the bins it keeps its value at the outer edge.
pub struct Reconstructed<'a> {
    how: Reconstruction,
    grid: EqualBins,
    bins: &'a [f64],
    /// Second derivatives of the integral's spline at the edges; empty without a spline.
    bends: Vec<f64>,
}

impl<'a> Reconstructed<'a> {
    pub fn new(how: Reconstruction, grid: EqualBins, bins: &'a [f64]) -> Reconstructed<'a> {
        assert_eq!(bins.len(), grid.count);
        let bends = match how {
            Reconstruction::Step | Reconstruction::Parabola => Vec::new(),
            _ => all_bends(grid, &[bins.to_vec()], how).remove(0),
        };
        Reconstructed { how, grid, bins, bends }
    }

    pub fn at(&self, nm: f64) -> f64 {
        let nm = nm.clamp(self.grid.low, self.grid.high);
        let k = self.grid.index(nm);
        let width = self.grid.width();
        let here = self.bins[k];
        match self.how {
            Reconstruction::Step => here,
            Reconstruction::Parabola if self.grid.count == 1 => here,
            Reconstruction::Parabola if self.grid.count == 2 => {
                // t from -1/2 to 3/2 across both
                let t = (nm - self.grid.low) / width - 0.5;
                self.bins[0] + (self.bins[1] - self.bins[0]) * t
            }
            Reconstruction::Parabola => {
                let middle = k.clamp(1, self.grid.count - 2);
                let (before, here) = (self.bins[middle - 1], self.bins[middle]);
                let after = self.bins[middle + 1];
                // from -1/2 to 1/2 across the middle bin; t^2 averages 1/12 there
                let t = (nm - self.grid.edge(middle)) / width - 0.5;
                here + 0.5 * (after - before) * t + 0.5 * (after - 2.0 * here + before) * (t * t - 1.0 / 12.0)
            }
            Reconstruction::Spline | Reconstruction::SplineNotAKnot => {
                let (left, right) = (self.bends[k], self.bends[k + 1]);
                let (x0, x1) = (self.grid.edge(k), self.grid.edge(k + 1));
                here - left * (x1 - nm).powi(2) / (2.0 * width) + right * (nm - x0).powi(2) / (2.0 * width)
                    - width * (right - left) / 6.0
            }
        }
    }

    /// Average over the 1 nm cell around a node, exact for these piecewise parabolas.
    fn over_cell(&self, node: f64) -> f64 {
        let (low, high) = (node - 0.5, node + 0.5);
        let mut cuts = vec![low, high];
        cuts.extend((0..=self.grid.count).map(|i| self.grid.edge(i)).filter(|&e| low < e && e < high));
        cuts.sort_by(f64::total_cmp);
        cuts.windows(2)
            .map(|pair| {
                let (middle, half) = (0.5 * (pair[0] + pair[1]), 0.5 * (pair[1] - pair[0]));
                // two-point Gauss, exact to the third degree, never on an edge
                let reach = half / 3f64.sqrt();
                half * (self.at(middle - reach) + self.at(middle + reach))
            })
            .sum()
    }

    /// Value a fine node sees: a point of the spline, a 1 nm cell of step and parabola.
    pub fn at_node(&self, node: f64) -> f64 {
        match self.how {
            Reconstruction::Step | Reconstruction::Parabola => self.over_cell(node),
            _ => self.at(node),
        }
    }
}

/// A row of 471 numbers as (nm, weight) at 360, 361, ..., 830 nm.
pub fn on_cie_nodes(row: &[f64]) -> Vec<(f64, f64)> {
    assert_eq!(row.len(), 471);
    (360..=830).map(f64::from).zip(row.iter().copied()).collect()
}

/// The N weights of one fine row given as (nm, weight).
pub fn weights(fine: &[(f64, f64)], grid: EqualBins, how: Reconstruction) -> Vec<f64> {
    let units: Vec<Vec<f64>> =
        (0..grid.count).map(|k| (0..grid.count).map(|j| f64::from(u8::from(j == k))).collect()).collect();
    let bends = match how {
        Reconstruction::Step | Reconstruction::Parabola => vec![Vec::new(); grid.count],
        _ => all_bends(grid, &units, how),
    };
    units
        .iter()
        .zip(bends)
        .map(|(bins, bends)| {
            let curve = Reconstructed { how, grid, bins, bends };
            fine.iter().map(|&(nm, weight)| weight * curve.at_node(nm)).sum()
        })
        .collect()
}

/// For each set of bins the second derivatives at the N + 1 edges of the cubic spline through the
/// running integral: `M[j-1] + 4 M[j] + M[j+1] = 6 / h^2 (F[j+1] - 2 F[j] + F[j-1])` inside; at an
/// end M = 0, or for not-a-knot the third derivative does not change at the first inner edge.
fn all_bends(grid: EqualBins, sets: &[Vec<f64>], how: Reconstruction) -> Vec<Vec<f64>> {
    let (n, width) = (grid.count, grid.width());
    let mut matrix = vec![vec![0.0; n + 1]; n + 1];
    let mut right = vec![vec![0.0; sets.len()]; n + 1];
    matrix[0][0] = 1.0;
    matrix[n][n] = 1.0;
    if how == Reconstruction::SplineNotAKnot {
        assert!(n >= 3, "not-a-knot ends need three bins");
        (matrix[0][1], matrix[0][2]) = (-2.0, 1.0);
        (matrix[n][n - 1], matrix[n][n - 2]) = (-2.0, 1.0);
    }
    for j in 1..n {
        matrix[j][j - 1] = 1.0;
        matrix[j][j] = 4.0;
        matrix[j][j + 1] = 1.0;
        for (value, bins) in right[j].iter_mut().zip(sets) {
            *value = 6.0 / width * (bins[j] - bins[j - 1]);
        }
    }
    let solution = solve(matrix, right);
    (0..sets.len()).map(|s| solution.iter().map(|row| row[s]).collect()).collect()
}
