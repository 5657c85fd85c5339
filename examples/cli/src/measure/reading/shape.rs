//! Finds the peak, the centroid and the width of a spectrum.

use super::Reading;
use crate::measure::source::Source;

/// The shape of a spectrum, in nm, by its samples and straight lines between them.
#[derive(Clone, Copy, Debug, Default)]
pub struct Shape {
    /// The wavelength of the highest sample.
    pub peak: f64,
    /// The mean wavelength, weighed by power.
    pub centroid: Option<f64>,
    /// The width of the peak at half its height.
    pub width: Option<f64>,
}

/// Adds the shape of a light.
pub fn measure(reading: &mut Reading, source: &Source) {
    let shape = of(&source.samples);
    if shape.centroid.is_none() {
        reading.note("centroid_nm", "the power of the samples does not sum to more than zero");
    }
    if shape.width.is_none() {
        reading.note("fwhm_nm", "the samples end before they fall to half of the peak on both sides");
    }
    reading.shape = Some(shape);
}

/// Returns the shape of samples, of which there are at least two.
pub fn of(samples: &[(f64, f64)]) -> Shape {
    // Samples of any size stay finite in the sums.
    let height = samples.iter().map(|sample| sample.1).fold(f64::NEG_INFINITY, f64::max);
    let peak = samples.iter().position(|sample| sample.1 == height).unwrap_or(0);
    let (mut power, mut moment) = (0.0, 0.0);
    for pair in samples.windows(2) {
        let [(a, p), (b, q)] = [pair[0], pair[1]].map(|(nm, value)| (nm, value / height));
        power += (b - a) * f64::midpoint(p, q);
        // The integral of the wavelength times a straight line.
        moment += (b - a) * (p * (2.0 * a + b) + q * (a + 2.0 * b)) / 6.0;
    }
    let half = height / 2.0;
    let above = (peak..samples.len() - 1).find_map(|k| crossing(samples[k], samples[k + 1], half));
    let below = (0..peak).rev().find_map(|k| crossing(samples[k + 1], samples[k], half));
    Shape {
        peak: samples[peak].0,
        centroid: (power > 0.0 && height > 0.0).then(|| moment / power),
        width: above.zip(below).filter(|_| height > 0.0).map(|(above, below)| above - below),
    }
}

/// Returns where the line from a sample to a farther one falls to `half`.
fn crossing(from: (f64, f64), to: (f64, f64), half: f64) -> Option<f64> {
    (from.1 > half && to.1 <= half).then(|| from.0 + (to.0 - from.0) * (from.1 - half) / (from.1 - to.1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_triangle_has_the_shape_of_geometry() {
        let shape = of(&[(400.0, 0.0), (500.0, 0.0), (530.0, 3.0), (590.0, 0.0), (700.0, 0.0)]);
        assert_eq!(shape.peak, 530.0);
        // The centroid of a triangle is the mean of its corners, and its half width is half its base.
        assert!((shape.centroid.unwrap_or(0.0) - 540.0).abs() < 1e-9);
        assert_eq!(shape.width, Some(45.0));
        assert_eq!(of(&[(400.0, 1.0), (500.0, 2.0)]).width, None);
        assert_eq!(of(&[(400.0, -1.0), (500.0, -2.0)]).centroid, None);
    }
}
