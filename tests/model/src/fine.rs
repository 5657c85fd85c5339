//! Color with hardly any grid: the trapezoidal rule every 0.1 nm from 360 to 830 nm, everything
//! joined by straight lines. The truth coarse methods are measured against.

use super::interpolation::Outside;
use super::tables::Observer;

/// Any increasing knots joined by straight lines.
#[derive(Clone, Debug)]
pub struct Curve {
    knots: Vec<(f64, f64)>,
    outside: Outside,
}

impl Curve {
    pub fn new(knots: Vec<(f64, f64)>, outside: Outside) -> Curve {
        assert!(!knots.is_empty() && knots.windows(2).all(|pair| pair[0].0 < pair[1].0));
        Curve { knots, outside }
    }

    pub fn at(&self, nm: f64) -> f64 {
        let above = self.knots.partition_point(|knot| knot.0 <= nm);
        let end = if above == 0 {
            self.knots[0]
        } else if above == self.knots.len() {
            self.knots[above - 1]
        } else {
            let ((x0, y0), (x1, y1)) = (self.knots[above - 1], self.knots[above]);
            let t = (nm - x0) / (x1 - x0);
            return y0 * (1.0 - t) + y1 * t;
        };
        if self.outside == Outside::Hold || end.0 == nm { end.1 } else { 0.0 }
    }

    /// Exact average from `low` to `high`, knot by knot.
    pub fn mean(&self, low: f64, high: f64) -> f64 {
        let first = self.knots[0].0;
        let last = self.knots[self.knots.len() - 1].0;
        let mut cuts = vec![low, high];
        cuts.extend(self.knots.iter().map(|knot| knot.0).filter(|&x| low < x && x < high));
        cuts.sort_by(f64::total_cmp);
        let area: f64 = cuts
            .windows(2)
            .map(|pair| {
                let middle = 0.5 * (pair[0] + pair[1]);
                let inside = first <= middle && middle <= last;
                if !inside && self.outside == Outside::Zero {
                    0.0
                } else {
                    // straight in between, so the middle is the mean
                    (pair[1] - pair[0]) * self.at(middle)
                }
            })
            .sum();
        area / (high - low)
    }
}

const NODES: usize = 4701;

fn nm(i: usize) -> f64 {
    360.0 + i as f64 / 10.0
}

/// Every 0.1 nm from 360 to 830.
pub fn nodes() -> impl Iterator<Item = f64> {
    (0..NODES).map(nm)
}

/// A curve at the [`nodes`].
pub fn values(curve: &Curve) -> Vec<f64> {
    nodes().map(|nm| curve.at(nm)).collect()
}

/// The observer every 0.1 nm, times the trapezoid's weights and a light: made once, it prices
/// many surfaces.
pub struct FineEye {
    rows: [Vec<f64>; 3],
    scale: f64,
}

impl FineEye {
    pub fn new(observer: Observer, light: &Curve) -> FineEye {
        let cmf = observer.published().map(|row| Curve::new(row.points(), Outside::Zero));
        let weight = |i: usize| if i == 0 || i == NODES - 1 { 0.05 } else { 0.1 };
        let powers: Vec<f64> = (0..NODES).map(|i| weight(i) * light.at(nm(i))).collect();
        let rows = cmf.map(|row| {
            powers.iter().enumerate().map(|(i, power)| power * row.at(nm(i))).collect::<Vec<f64>>()
        });
        let scale = 100.0 / rows[1].iter().sum::<f64>();
        FineEye { rows, scale }
    }

    /// XYZ of the perfect white under the light, Y = 100.
    pub fn white(&self) -> [f64; 3] {
        self.rows.each_ref().map(|row| self.scale * row.iter().sum::<f64>())
    }

    pub fn sees(&self, surface: &Curve) -> [f64; 3] {
        self.sees_values(&values(surface))
    }

    /// The same of a surface known every 0.1 nm, as [`values`] has it.
    pub fn sees_values(&self, surface: &[f64]) -> [f64; 3] {
        self.rows.each_ref().map(|row| self.scale * row.iter().zip(surface).map(|(w, r)| w * r).sum::<f64>())
    }

    /// What makes Y = 100 of the sum of power times y-bar.
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// Each row at the [`nodes`], light, trapezoid and scale in it.
    pub fn weights(&self) -> [Vec<f64>; 3] {
        self.rows.each_ref().map(|row| row.iter().map(|weight| self.scale * weight).collect())
    }
}
