//! What curves can have, in f64, by a search that shares no code with the solver: the solid of object colors,
//! the least difference of its surface from a color, and a search of sigmoids.

use model::delta_e::de2000;
use model::lab::lab;
use model::linear::solve;
use model::solid::Solid;

type Color = [f64; 3];

/// The observer of a fold: X, Y and Z of each bin, each of which is 1 in sum, and x of its center.
pub struct Fold {
    bins: Vec<(Color, f64)>,
    solid: Solid,
}

pub fn delta_e(one: Color, two: Color) -> f64 {
    de2000(lab(one, [1.0; 3]), lab(two, [1.0; 3]))
}

fn dot(a: Color, b: Color) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

impl Fold {
    pub fn new(bins: Vec<(Color, f64)>) -> Self {
        let solid = Solid::new(&bins.iter().map(|(color, _)| *color).collect::<Vec<_>>());
        Fold { bins, solid }
    }

    /// Whether a spectrum within 0..=1 has the color.
    pub fn contains(&self, color: Color) -> bool {
        self.solid.contains(color)
    }

    pub fn sees(&self, values: impl Iterator<Item = f64>) -> Color {
        let mut sum = [0.0; 3];
        for ((color, _), value) in self.bins.iter().zip(values) {
            (0..3).for_each(|c| sum[c] += value * color[c]);
        }
        sum
    }

    /// The color of the sigmoid of q0 x^2 + q1 x + q2, and its derivatives by q.
    fn sigmoid(&self, q: Color) -> (Color, [Color; 3]) {
        let (mut seen, mut slopes) = ([0.0; 3], [[0.0; 3]; 3]);
        for (color, x) in &self.bins {
            let p = (q[0] * x + q[1]) * x + q[2];
            let root = (1.0 + p * p).sqrt();
            let small = 0.5 / (root * (root + p.abs()));
            let value = if p < 0.0 { small } else { 1.0 - small };
            let slope = 0.5 / (root * root * root);
            for c in 0..3 {
                seen[c] += value * color[c];
                [x * x, *x, 1.0].iter().zip(&mut slopes[c]).for_each(|(by, s)| *s += slope * by * color[c]);
            }
        }
        (seen, slopes)
    }

    /// How near a search of sigmoids with numbers up to 1e4, rounded to f32, comes to a color: by the method
    /// of Levenberg and Marquardt on Lab that is weighted as in CIE94, from several starts.
    pub fn nearest_sigmoid(&self, asked: Color) -> f64 {
        let starts = [[0.0; 3], [-50.0, 0.0, 1.0], [50.0, 0.0, -1.0], [0.0, 20.0, 0.0], [0.0, -20.0, 0.0]];
        starts.iter().map(|start| self.descend(asked, *start)).fold(f64::INFINITY, f64::min)
    }

    fn descend(&self, asked: Color, start: Color) -> f64 {
        let goal = lab(asked, [1.0; 3]);
        let chroma = goal[1].hypot(goal[2]).max(1e-9);
        let (cos, sin) = (goal[1] / chroma, goal[2] / chroma);
        let (sc, sh) = (1.0 + 0.045 * chroma, 1.0 + 0.015 * chroma);
        let left = |seen: Color| {
            let [l, a, b] = lab(seen, [1.0; 3]);
            let (a, b) = (a - goal[1], b - goal[2]);
            [l - goal[0], (a * cos + b * sin) / sc, (b * cos - a * sin) / sh]
        };
        let root_slope = |t: f64| {
            if t > 216.0 / 24389.0 { 1.0 / (3.0 * t.cbrt().powi(2)) } else { 24389.0 / 27.0 / 116.0 }
        };
        let mut q = start;
        let (mut seen, mut slopes) = self.sigmoid(q);
        let mut damping = 1.0;
        for _ in 0..400 {
            let now = left(seen);
            if dot(now, now) < 1e-14 || damping > 1e8 {
                break;
            }
            let [x, y, z] = seen.map(root_slope);
            let by_ab = |a: f64, b: f64| [500.0 * a * x, (200.0 * b - 500.0 * a) * y, -200.0 * b * z];
            let by_seen = [[0.0, 116.0 * y, 0.0], by_ab(cos / sc, sin / sc), by_ab(-sin / sh, cos / sh)];
            let j = model::linear::product(by_seen, slopes);
            // The values of the quadratic at 450, 540 and 610 nm measure a step.
            let at = [-0.65, -0.2, 0.15].map(|x: f64| [x * x, x, 1.0]);
            let size = 1.0 + at.iter().map(|row| dot(*row, q).powi(2)).sum::<f64>().sqrt();
            let weight = damping / (size * size);
            let entry =
                |a: &[Color; 3], i: usize, k: usize| (0..3).map(|row| a[row][i] * a[row][k]).sum::<f64>();
            let matrix = (0..3)
                .map(|i| (0..3).map(|k| entry(&j, i, k) + weight * entry(&at, i, k)).collect())
                .collect();
            let right = (0..3).map(|i| vec![-(0..3).map(|row| j[row][i] * now[row]).sum::<f64>()]).collect();
            let step = solve(matrix, right);
            let trial = [0, 1, 2].map(|k| q[k] + step[k][0]);
            let (there, slopes_there) = self.sigmoid(trial);
            let next = left(there);
            if trial.iter().all(|v| v.abs() <= 1e4) && dot(next, next) < dot(now, now) {
                (q, seen, slopes) = (trial, there, slopes_there);
                damping = (0.2 * damping).max(1e-12);
            } else {
                damping *= 4.0;
            }
        }
        delta_e(asked, self.sigmoid(q.map(|v| f64::from(v as f32))).0)
    }

    /// The least difference of a color from those on the surface of the solid: bands of bins and gaps between
    /// bands, whose start and luminance are found by searches from many starts.
    pub fn nearest_on_surface(&self, asked: Color) -> f64 {
        let count = self.bins.len() as f64;
        let off = |p: [f64; 2]| {
            let root = p[1].clamp(1e-4, 1.0);
            delta_e(asked, self.band(p[0].rem_euclid(count), root * root * root))
        };
        let mut starts = Vec::new();
        for part in [0.4, 0.7, 1.0, 1.3] {
            let root = (asked[1].clamp(1e-6, 1.0) * part).min(1.0 - 1e-6).cbrt();
            let all: Vec<f64> = (0..self.bins.len()).map(|k| off([k as f64 + 0.5, root])).collect();
            for (k, here) in all.iter().enumerate() {
                if *here <= all[(k + 1) % all.len()] && *here < all[(k + all.len() - 1) % all.len()] {
                    starts.push((*here, [k as f64 + 0.5, root]));
                }
            }
        }
        starts.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut least = f64::INFINITY;
        for (_, start) in starts.into_iter().take(5) {
            let mut best = simplex(start, [1.0, 0.02], &off);
            for size in [0.3, -0.1, 0.05, -0.02] {
                let again = simplex(best.0, [size, 0.05 * size], &off);
                best = if again.1 < best.1 { again } else { best };
            }
            least = least.min(best.1);
        }
        least
    }

    /// The color of the band that starts at a place in bins and has this luminance, across the joint of the
    /// ends if it is long.
    fn band(&self, from: f64, luminance: f64) -> Color {
        let (first, mut sum, mut left) = (from as usize, [0.0; 3], luminance);
        for k in 0..=self.bins.len() {
            let (color, _) = self.bins[(first + k) % self.bins.len()];
            let inside = from - first as f64;
            let share = if k == 0 {
                1.0 - inside
            } else if k == self.bins.len() {
                inside
            } else {
                1.0
            };
            let power = color[1].max(0.0) * share;
            let part = if power > left { left / power } else { 1.0 };
            (0..3).for_each(|c| sum[c] += part * share * color[c]);
            left -= part * power;
            if part < 1.0 {
                break;
            }
        }
        sum
    }
}

/// The method of Nelder and Mead.
fn simplex(start: [f64; 2], sizes: [f64; 2], value: &impl Fn([f64; 2]) -> f64) -> ([f64; 2], f64) {
    let corners = [start, [start[0] + sizes[0], start[1]], [start[0], start[1] + sizes[1]]];
    let mut all = corners.map(|p| (p, value(p)));
    for _ in 0..150 {
        all.sort_by(|a, b| a.1.total_cmp(&b.1));
        let middle = [0, 1].map(|k| 0.5 * (all[0].0[k] + all[1].0[k]));
        let at = |part: f64| {
            let p = [0, 1].map(|k| middle[k] + part * (all[2].0[k] - middle[k]));
            (p, value(p))
        };
        let mirrored = at(-1.0);
        let new = if mirrored.1 < all[0].1 {
            let further = at(-2.0);
            if further.1 < mirrored.1 { further } else { mirrored }
        } else if mirrored.1 < all[1].1 {
            mirrored
        } else {
            at(if mirrored.1 < all[2].1 { -0.5 } else { 0.5 })
        };
        if new.1 < all[2].1 {
            all[2] = new;
        } else {
            let best = all[0].0;
            for corner in &mut all[1..] {
                corner.0 = [0, 1].map(|k| 0.5 * (corner.0[k] + best[k]));
                corner.1 = value(corner.0);
            }
        }
    }
    all.into_iter().min_by(|a, b| a.1.total_cmp(&b.1)).expect("three")
}
