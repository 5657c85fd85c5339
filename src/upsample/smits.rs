//! Upsampling by seven fixed curves, after Smits.

use crate::color::Rgb;
use crate::grid::{Bins, Grid, Layout};
use crate::math::const_for;
use crate::spectrum::{Factor, Spectrum};
use crate::upsample::tables::SMITS;
use core::marker::PhantomData;

/// Finds the spectrum of an RGB by adding up seven fixed curves, after Smits' classic method.
///
/// The spectrum is a sum of three terms: white times the smallest component; cyan, magenta or yellow times
/// the difference to the next larger component; and red, green or blue times the difference from there to the
/// largest component.
///
/// The curves were made for primaries close to those of sRGB under light of *equal energy*, so colors are off
/// under D65. Prefer [`Sigmoid`](crate::upsample::Sigmoid) or [`Basis`](crate::upsample::Basis) unless you
/// compare methods or reproduce older renderings.
///
/// # Example
/// ```
/// use nanospectra::color::{Rgb, Srgb};
/// use nanospectra::upsample::SmitsBins;
/// static SMITS: SmitsBins = SmitsBins::new();
/// let yellow = SMITS.reflectance(Rgb::<Srgb>::new(1.0, 1.0, 0.0));
/// assert_eq!(yellow.values()[3], 0.6651); // the paper's table
/// ```
///
/// # Accuracy
/// The spectrum does not have the color that was asked for, not even to 8 bits: under D65 it is off by 0.9
/// CIEDE2000 in the mean and by up to 2.1. [`Viewing::delta_e`](crate::upsample::Viewing::delta_e) computes
/// the error of a color at hand. Values reach 1.015, and the values of a gray vary by 8e-4.
///
/// # Cost
/// The curves take 28 N bytes.
///
/// # Reference
/// B. Smits, "An RGB-to-spectrum conversion for reflectances", J. Graphics Tools 4 (1999).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Smits<const N: usize, G = Bins<380, 730>> {
    curves: [[f32; N]; 7],
    grid: PhantomData<G>,
}

/// Smits' method on the ten bins that the paper uses. See the [example](Smits#example).
pub type SmitsBins = Smits<10, Bins<380, 720>>;

impl<const N: usize, G: Grid> Smits<N, G> {
    /// Computes the seven curves on a grid as averages of the paper's ten steps, in f64; for `const` use.
    ///
    /// Beyond the paper's range the outer steps are continued. See the [example](#example).
    #[must_use]
    pub const fn new() -> Self {
        let mut curves = [[0.0; N]; 7];
        const_for!(0..N, |n| {
            let low = Layout::<G, N>::START + n as f64 * Layout::<G, N>::WIDTH;
            const_for!(0..7, |c| curves[c][n] = average(c, low, low + Layout::<G, N>::WIDTH));
        });
        Smits { curves, grid: PhantomData }
    }

    /// Returns the reflectance of a color, which is given in linear RGB.
    ///
    /// If a component is NaN, the whole spectrum is NaN. See the [example](#example).
    #[must_use]
    pub fn reflectance<S>(&self, rgb: Rgb<S>) -> Spectrum<Factor, N, G> {
        let [white, cyan, magenta, yellow, red, green, blue] = &self.curves;
        let Rgb { r, g, b, .. } = rgb;
        let (least, (pair, middle), (single, most)) = if r <= g && r <= b {
            if g <= b { (r, (cyan, g - r), (blue, b - g)) } else { (r, (cyan, b - r), (green, g - b)) }
        } else if g <= r && g <= b {
            if r <= b { (g, (magenta, r - g), (blue, b - r)) } else { (g, (magenta, b - g), (red, r - b)) }
        } else if r <= g {
            (b, (yellow, r - b), (green, g - r))
        } else {
            (b, (yellow, g - b), (red, r - g))
        };
        let mut values = [0.0; N];
        for (k, value) in values.iter_mut().enumerate() {
            let at = |curve: &[f32; N]| curve.get(k).copied().unwrap_or(0.0);
            *value = least * at(white) + middle * at(pair) + most * at(single);
        }
        Spectrum::from_bins(values)
    }
}

impl<const N: usize, G: Grid> Default for Smits<N, G> {
    fn default() -> Self {
        Self::new()
    }
}

/// Returns the average of a curve, which has ten steps of 34 nm, over `low..high`.
const fn average(curve: usize, low: f64, high: f64) -> f32 {
    let mut sum = 0.0;
    const_for!(0..10, |step| {
        // The outer steps are continued as far as the grid reaches.
        let from = if step == 0 { 0.0 } else { 380.0 + 34.0 * step as f64 };
        let to = if step == 9 { 1e7 } else { 380.0 + 34.0 * (step + 1) as f64 };
        let from = if from > low { from } else { low };
        let to = if to < high { to } else { high };
        if from < to {
            sum += (to - from) / (high - low) * SMITS[step][curve] as f64;
        }
    });
    sum as f32
}
