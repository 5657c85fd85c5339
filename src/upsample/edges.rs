//! The nearest color that a curve has, for colors that no curve has.
//!
//! The colors of all curves fill the solid of object colors, up to its surface. The colors on the surface
//! belong to spectra that are 1 in a band of wavelengths and 0 elsewhere, or the other way round (the optimal
//! colors of Schroedinger and MacAdam). On a grid all bins of such a spectrum are 0 or 1, but for the two at
//! its edges. A curve comes as near to it as its steepness allows. So the nearest color is found by the
//! middle and the size of a band, and then by the steepness, too.
//!
//! The band lies on a ring that joins the ends of the spectrum: a band that runs across the joint leaves a
//! gap. Lengths on the ring are shares of what the three responses are in the mean, so that a step along it
//! can be seen everywhere.

use crate::color::matrix::apply;
use crate::upsample::rsqrt::unsigmoid;
use crate::upsample::seen::{Asked, Eye};
use crate::upsample::simplex::{Vertex, least};

/// A band of bins that are 1, or a gap of bins that are 0.
#[derive(Clone, Copy)]
struct Band {
    /// Where it begins and ends, in bins from the start of the grid. Its length is at least that of a bin.
    from: f32,
    to: f32,
    /// How much of the bins it takes; below 1 if it would be shorter than a bin.
    height: f32,
    is_gap: bool,
}

/// How many middles of bands are tried for each size.
const MIDDLES: u8 = 8;
/// The sizes that are tried, as shares of the cube root of the size asked for. The best of each group is
/// improved.
const SIZES: [&[f32]; 2] = [&[0.4], &[0.6, 0.8, 1.0]];
/// How many steps improve the band of each group, first from a large simplex and then from a small one, and
/// how many improve the curve in the same way.
const STEPS: [usize; 4] = [45, 12, 30, 30];
/// The curve is good enough when all corners of the simplex are as good as the best, to within this share.
const ALIKE: f32 = 1e-3;
/// The steepest curve has a quadratic of this to the fourth, 65536. Steeper ones would lose digits.
const STEEPEST: f32 = 16.0;
/// What stands for the steepness of a band itself.
const STEP: f32 = 0.0;

/// Returns the curve that is found nearest to a color, in the sense of CIEDE2000, and its difference.
#[inline(never)]
pub(super) fn nearest<const N: usize>(eye: &Eye<'_, N>, asked: &Asked, mean: f32) -> ([f32; 3], f32) {
    let ring = eye.rows.iter().map(mean_of).sum::<f32>();
    // The middle, the root of the size and the steepness.
    let off = |p: &[f32; 3]| {
        let band = eye.band(ring, p[0], p[1]);
        asked.delta_e(if p[2] == STEP { eye.sees_band(&band) } else { eye.sees(eye.curve(&band, p[2])) })
    };
    let root = crate::math::cbrt(mean.clamp(1e-5, 1.0));
    let mut best = ([0.5, root, STEP], f32::INFINITY);
    for sizes in SIZES {
        let mut start = ([0.5, root, STEP], f32::INFINITY);
        for size in sizes {
            let size = (size * root).min(0.9995);
            let length = size * size * size;
            // Evenly spread ones, and the two at the ends of the spectrum.
            let even = (0..MIDDLES).map(|k| (f32::from(k) + 0.5) / f32::from(MIDDLES));
            for middle in even.chain([0.5 * length, 1.0 - 0.5 * length]) {
                try_it(&mut start, [middle, size, STEP], off);
            }
        }
        let wide = [0.5 / f32::from(MIDDLES), 0.05 * start.0[1], 0.0];
        let found = least(start, wide, (STEPS[0], 0.0), off);
        let found = least(found, [-0.003, 0.005, 0.0], (STEPS[1], 0.0), off);
        if found.1 < best.1 {
            best = found;
        }
    }
    let [middle, root, _] = best.0;
    let steepest = [middle, root, STEEPEST];
    let start = (steepest, off(&steepest));
    let found = least(start, [0.002, 0.003, -0.22 * STEEPEST], (STEPS[2], ALIKE), off);
    let found = least(found, [0.05, 0.01 * root, -0.1 * found.0[2]], (STEPS[3], ALIKE), off);
    let [middle, root, steepness] = found.0;
    (eye.curve(&eye.band(ring, middle, root), steepness), found.1)
}

/// Replaces the best point by another one if that is better.
fn try_it(best: &mut Vertex, trial: [f32; 3], value: impl Fn(&[f32; 3]) -> f32) {
    let found = value(&trial);
    if found < best.1 {
        *best = (trial, found);
    }
}

/// Returns what the three responses of a bin are in the mean, but no less than 0.
fn mean_of([a, b, c, _]: &[f32; 4]) -> f32 {
    let mean = (a + b + c) * (1.0 / 3.0);
    if mean > 0.0 { mean } else { 0.0 }
}

impl<const N: usize> Eye<'_, N> {
    /// Returns the band about `middle` whose size is the cube of `root`, both as shares of the ring.
    fn band(&self, ring: f32, middle: f32, root: f32) -> Band {
        let root = root.clamp(0.0, 1.0);
        let size = root * root * root;
        let from = middle - 0.5 * size;
        let from = from - from as i32 as f32;
        let from = if from < 0.0 { from + 1.0 } else { from };
        let to = from + size;
        let is_gap = to > 1.0;
        let (from, to) = if is_gap { (to - 1.0, from) } else { (from, to) };
        let [from, to] = self.places([ring * from, ring * to]);
        let height = (to - from).clamp(0.0, 1.0);
        let middle = 0.5 * (from + to);
        let (from, to) = if height < 1.0 { (middle - 0.5, middle + 0.5) } else { (from, to) };
        Band { from, to, height, is_gap }
    }

    /// Returns how many bins make up each of two lengths of the ring, of which the second is not shorter.
    fn places(&self, [first, second]: [f32; 2]) -> [f32; 2] {
        let (mut from, mut bins, mut passed, mut sought) = (0.0, 0.0, 0.0, first);
        let mut is_second = false;
        for row in self.rows {
            let mean = mean_of(row);
            if !is_second && sought < passed + mean {
                from = bins + (sought - passed) / mean;
                (is_second, sought) = (true, second);
            }
            if is_second && sought < passed + mean {
                return [from, bins + (sought - passed) / mean];
            }
            passed += mean;
            bins += 1.0;
        }
        [if is_second { from } else { bins }, bins]
    }

    fn sees_band(&self, band: &Band) -> [f32; 3] {
        let (mut seen, mut bin) = ([0.0; 3], 0.0);
        for [a, b, c, _] in self.rows {
            let (from, to) = (band.from.max(bin), band.to.min(bin + 1.0));
            let part = if from < to { band.height * (to - from) } else { 0.0 };
            let share = if band.is_gap { 1.0 - part } else { part };
            seen = [seen[0] + share * a, seen[1] + share * b, seen[2] + share * c];
            bin += 1.0;
        }
        apply(&self.to_xyz, seen)
    }

    /// Returns the curve that has the values of the band in the two bins at its edges, and whose quadratic is
    /// the fourth power of `steepness`.
    fn curve(&self, band: &Band, steepness: f32) -> [f32; 3] {
        let (first, last) = (self.rows.first().map_or(0.0, |r| r[3]), self.rows.last().map_or(0.0, |r| r[3]));
        let bins = N as f32;
        let per_bin = if N > 1 { (last - first) / (bins - 1.0) } else { 0.0 };
        let sign = if band.is_gap { -1.0 } else { 1.0 };
        let steepness = steepness.clamp(1.0, STEEPEST);
        let steep = sign * ((steepness * steepness) * (steepness * steepness));
        // Both are above -1.
        let (i, j) = (((band.from + 1.0) as u32) as f32 - 1.0, ((band.to + 1.0) as u32) as f32 - 1.0);
        let (a, b) = (band.height * (i + 1.0 - band.from), band.height * (band.to - j));
        // Bins beyond the ends may have any value.
        let at = |bin: f32, value: f32| {
            let inside = 0.0 <= bin && bin < bins;
            (
                first + per_bin * bin,
                if inside { sign * unsigmoid(value.clamp(1e-5, 1.0 - 1e-5)) } else { 0.0 },
            )
        };
        let ((x, u), (y, v)) = (at(i, a), at(j, b));
        // A band is no shorter than a bin, so that its edges lie in different ones.
        let slope = (v - u) / (y - x);
        [-steep, slope + steep * (x + y), u - slope * x - steep * x * y]
    }
}
