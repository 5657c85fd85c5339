//! The classic: seven curves, and a color as white plus what it has more of.

use crate::color::Rgb;
use crate::grid::{Bins, Grid, Layout};
use crate::math::const_for;
use crate::spectrum::{Factor, Spectrum};
use crate::upsample::tables::SMITS;
use core::marker::PhantomData;

/// Upsampling after Smits: the least component times white, what the next one has more times cyan, magenta
/// or yellow, what the largest has more times red, green or blue.
///
/// Made for primaries close to sRGB seen under *equal energy*, and so off under D65. Equal components pass
/// through white alone, or through white and one of cyan, magenta, yellow.
///
/// # Accuracy
/// It does not give the color back, not even to 8 bits: 0.9 CIEDE2000 in the mean and up to 2.1 under
/// D65. What it is for a color at hand is
/// [`Viewing::delta_e`](crate::upsample::Viewing::delta_e). Values reach 1.015, and a gray ripples by 8e-4.
///
/// # Cost
/// 28 N bytes.
///
/// # Reference
/// B. Smits, "An RGB-to-spectrum conversion for reflectances", J. Graphics Tools 4 (1999).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Smits<const N: usize, G = Bins<380, 730>> {
    curves: [[f32; N]; 7],
    grid: PhantomData<G>,
}

/// The ten bins of the paper.
pub type SmitsBins = Smits<10, Bins<380, 720>>;

impl<const N: usize, G: Grid> Smits<N, G> {
    /// The seven curves on any grid: averages of the ten steps, the outer ones held; for `const` use.
    ///
    /// ```
    /// use nanospectra::color::{Rgb, Srgb};
    /// use nanospectra::upsample::SmitsBins;
    /// static SMITS: SmitsBins = SmitsBins::new();
    /// let yellow = SMITS.reflectance(Rgb::<Srgb>::new(1.0, 1.0, 0.0));
    /// assert_eq!(yellow.values()[3], 0.6651); // the paper's table
    /// ```
    #[must_use]
    pub const fn new() -> Self {
        let mut curves = [[0.0; N]; 7];
        const_for!(0..N, |n| {
            let low = Layout::<G, N>::START + n as f64 * Layout::<G, N>::WIDTH;
            const_for!(0..7, |c| curves[c][n] = average(c, low, low + Layout::<G, N>::WIDTH));
        });
        Smits { curves, grid: PhantomData }
    }

    /// The reflectance of a color (linear RGB); NaN in any component is NaN everywhere.
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

/// The average of a curve's ten steps of 34 nm over `low..high`.
const fn average(curve: usize, low: f64, high: f64) -> f32 {
    let mut sum = 0.0;
    const_for!(0..10, |step| {
        // The outer steps reach as far as it takes.
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
