//! A spectrum that is nowhere negative.

use crate::grid::Grid;
use crate::observer::Observer;
use crate::sensor::calibrate::qr::{Triangle, damped_inverse};
use crate::sensor::calibrate::vector::{largest, norm};
use crate::sensor::{BasicCounts, FitError};
use crate::spectrum::{Light, Power, Spectrum};
use crate::sum::sum;

/// Computes the spectrum without negative bins that explains the counts of one reading best.
///
/// A [`Reconstruction`](crate::sensor::Reconstruction) swings below zero beside a line or a narrow LED; this
/// spectrum is 0 there, at the cost of a search for each reading. The search minimizes `|G s - c|^2 + alpha
/// g^2 |s|^2`, where s is the spectrum, G s what the sensor would count of it, c the counts, and g the mean
/// signal of the channels.
///
/// `alpha` is [`DEFAULT_ALPHA`](crate::sensor::DEFAULT_ALPHA) or more, as for a reconstruction;
/// `max_iterations` limits the search. Counts below zero are noise, and no light explains them: they pull the
/// spectrum to 0.
///
/// ```
/// use nanospectra::sensor::{DEFAULT_ALPHA, BasicCounts, nonnegative_spectrum, chip::as7341};
/// use nanospectra::{Curve, Light, Nodes, Observer, Power};
///
/// type Grid = Nodes<400, 700>;
/// static CHIP: Observer<8, 31, Power, Grid> = as7341::NOMINAL.fold(Curve::Step);
/// let mut laser = Light::flat(0.0);
/// let _ = laser.add_line(532.0, 1.0);
/// let light = nonnegative_spectrum(&CHIP, &BasicCounts::new(CHIP.sees(&laser)), DEFAULT_ALPHA, 30)?;
/// assert!(light.iter().all(|(_, value)| value >= 0.0));
/// # Ok::<(), nanospectra::sensor::FitError>(())
/// ```
///
/// # Accuracy
/// Within 1.5e-6 of the peak of the minimum for lines and LEDs seen by channels like the AS7341's, at alpha
/// 1e-3 to 0.1, and within 1e-5 for channels 80 nm wide (searched in `tests/sensor/worst_chips.rs`).
///
/// # Cost
/// Each step is a least squares of `C` unknowns over the bins that are not 0, and there is one of all bins at
/// the end. Lamps and LEDs take up to 5 steps, lasers up to 11; of 4000 random sensors and counts, most of
/// which no light makes, the longest took 34. On a Cortex-M4F 8 channels on 31 bins take 2,700 bytes of stack
/// at opt-level 3 and 2,980 at "s", on 81 bins 5,960 and 6,060.
///
/// # Errors
/// `NotConverged` after `max_iterations` steps: 50 are plenty. `NotFinite` for NaN, infinity or an alpha that
/// is not above 0. `IllConditioned` if no channel sees anything.
pub fn nonnegative_spectrum<const C: usize, const N: usize, G: Grid>(
    sensor: &Observer<C, N, Power, G>,
    basic: &BasicCounts<C>,
    alpha: f32,
    max_iterations: u32,
) -> Result<Light<N, G>, FitError> {
    let signal = norm(&sensor.weights().each_ref().map(norm)) / crate::math::sqrt(C as f32);
    let counted = largest(basic.values());
    if !(signal.is_finite() && counted.is_finite() && alpha > 0.0) {
        return Err(FitError::NotFinite);
    }
    if signal == 0.0 {
        return Err(FitError::IllConditioned { condition: f32::INFINITY });
    }
    if counted == 0.0 {
        return Ok(Spectrum::flat(0.0));
    }
    let mut search = Search {
        g: *sensor.weights(),
        counts: basic.values().map(|count| count / counted),
        root_alpha: crate::math::sqrt(alpha),
    };
    for weight in search.g.as_flattened_mut() {
        *weight /= signal;
    }
    let mut light = Spectrum::<Power, N, G>::from_bins(search.run(max_iterations)?);
    for value in light.values_mut() {
        *value = *value / signal * counted;
    }
    if largest(light.values()).is_finite() { Ok(light) } else { Err(FitError::NotFinite) }
}

/// The search, in `C` unknowns m instead of `N`. At the minimum the spectrum is max(0, G' m), and m is where
/// the convex function alpha |m|^2 / 2 + |max(0, G' m)|^2 / 2 - counts . m is least. The function is made of
/// parabolas, one for each set of bright bins. Each step goes toward the least point of the present one, but
/// not beyond the least point on the way.
struct Search<const C: usize, const N: usize> {
    g: [[f32; N]; C],
    counts: [f32; C],
    root_alpha: f32,
}

impl<const C: usize, const N: usize> Search<C, N> {
    /// Returns the spectrum. The weights become those of its last least squares.
    fn run(&mut self, max_iterations: u32) -> Result<[f32; N], FitError> {
        let mut m = [0.0; C];
        let mut spectrum = self.spectrum(&self.counts);
        let mut iterations = 0;
        while iterations < max_iterations {
            let target = self.least(&spectrum);
            if !largest(&target).is_finite() {
                return Err(FitError::NotFinite);
            }
            // Best for the bins that are bright now. If the same bins are bright there, it is the best of
            // all.
            let there = self.spectrum(&target);
            if spectrum.iter().zip(&there).all(|(now, then)| (*now > 0.0) == (*then > 0.0)) {
                return Ok(self.of_bright(&there));
            }
            match self.step(&m, &target) {
                Some(step) => m.iter_mut().zip(target).for_each(|(m, target)| *m += step * (target - *m)),
                // Only rounding is left: bins of 0 that become bright and dark again.
                None => return Ok(self.of_bright(&spectrum)),
            }
            spectrum = self.spectrum(&m);
            iterations += 1;
        }
        Err(FitError::NotConverged { iterations })
    }

    /// Computes G' m, the spectrum before what is negative is cut off.
    fn spectrum(&self, m: &[f32; C]) -> [f32; N] {
        let mut spectrum = [0.0; N];
        for (row, m) in self.g.iter().zip(m) {
            for (value, weight) in spectrum.iter_mut().zip(row) {
                *value += weight * m;
            }
        }
        spectrum
    }

    /// Computes the spectrum that is best if just these bins are bright. From m it would lose digits: where
    /// no light explains the counts, m is what is left of them over alpha, and its terms cancel.
    fn of_bright(&mut self, spectrum: &[f32; N]) -> [f32; N] {
        for row in &mut self.g {
            row.iter_mut()
                .zip(spectrum)
                .filter(|(_, value)| **value <= 0.0)
                .for_each(|(weight, _)| *weight = 0.0);
        }
        let _ = damped_inverse(&mut self.g, self.root_alpha);
        let mut light = [0.0; N];
        for (row, count) in self.g.iter().zip(&self.counts) {
            light.iter_mut().zip(row).for_each(|(value, share)| *value += share * count);
        }
        light.map(|value| if value > 0.0 { value } else { 0.0 })
    }

    /// Computes the m that is best if just the bins that are bright now stay bright: (alpha + G G') m =
    /// counts over these bins, as least squares.
    fn least(&self, spectrum: &[f32; N]) -> [f32; C] {
        let start = self.counts.map(|count| [count / self.root_alpha]);
        let mut triangle = Triangle::<C, 1>::ridge(self.root_alpha, start);
        for (n, _) in spectrum.iter().enumerate().filter(|(_, value)| **value > 0.0) {
            triangle.absorb(self.g.each_ref().map(|row| row.get(n).copied().unwrap_or(0.0)), [0.0]);
        }
        let [m] = triangle.solve();
        m
    }

    /// Computes how far to go from `m` toward `target`, 0 to 1: all the way unless the function rises there;
    /// then to where it still falls, but at most a twentieth as steeply. `None` if it falls nowhere on the
    /// way.
    fn step(&self, m: &[f32; C], target: &[f32; C]) -> Option<f32> {
        let mut direction = *target;
        for (to, from) in direction.iter_mut().zip(m) {
            *to -= from;
        }
        let (at, along) = (self.spectrum(m), self.spectrum(&direction));
        let alpha = self.root_alpha * self.root_alpha;
        let mut terms = [0.0; C];
        for (term, ((m, d), count)) in terms.iter_mut().zip(m.iter().zip(&direction).zip(&self.counts)) {
            *term = d * (alpha * m - count);
        }
        // The slope of the function on the way.
        let (constant, linear) = (sum(&terms), alpha * sum(&direction.map(|d| d * d)));
        let slope = |t: f32| {
            let mut terms = [0.0; N];
            for (value, (at, along)) in terms.iter_mut().zip(at.iter().zip(&along)) {
                let there = at + t * along;
                *value = if there > 0.0 { there * along } else { 0.0 };
            }
            constant + t * linear + sum(&terms)
        };
        let start = slope(0.0);
        if slope(1.0) <= -1e-3 * start {
            return Some(1.0);
        }
        let (mut near, mut far, mut halvings) = (0.0, 1.0, 0);
        while halvings < 24 && slope(near) < 0.05 * start {
            let middle = 0.5 * (near + far);
            if slope(middle) <= 0.0 {
                near = middle;
            } else {
                far = middle;
            }
            halvings += 1;
        }
        if near > 0.0 { Some(near) } else { None }
    }
}
