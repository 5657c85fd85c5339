//! Upsampling by three fixed spectra, which is the fastest method and the only linear one.

use crate::color::matrix::{Matrix64, inverse64, product64};
use crate::color::{Rgb, RgbSpace, Srgb};
use crate::grid::{Bins, Grid, Nodes};
use crate::math::const_for;
use crate::spectrum::{Factor, Interpolation, Spectrum};
use crate::upsample::tables::BASIS;
use crate::upsample::viewing::Viewing;
use core::marker::PhantomData;

/// Finds the spectrum of an RGB by adding up three fixed spectra in proportion to red, green and blue.
///
/// Make it by [`new`](Self::new) while compiling, and call [`reflectance`](Self::reflectance).
///
/// The three spectra add up to 1. They are the smoothest that have the colors of the sRGB primaries under D65
/// on 5 nm and stay within 0.012..=0.976 (`tests/upsample/tables.rs` makes them, from CIE data alone). A 3x3
/// matrix mixes them so that the colors are exact for the grid, light and RGB space at hand.
///
/// The method is linear: the spectrum of a mixture of colors is the mixture of their spectra, also for
/// components below 0 and above 1. NaN stays NaN. Components above 4e37 in size overflow.
///
/// # Example
/// ```
/// use nanospectra::color::Rgb;
/// use nanospectra::upsample::{Basis, Viewing};
/// use nanospectra::{Curve, light::D65, observer::CIE_1931};
/// static VIEWING: Viewing<36> =
///     Viewing::new(&CIE_1931.under(&D65.fine()).fold(Curve::Step));
/// static BASIS: Basis<36> = Basis::new(&VIEWING);
/// let teal = BASIS.reflectance(Rgb::new(0.1, 0.5, 0.4));
/// let back = VIEWING.rgb(&teal);
/// assert!((back.r - 0.1).abs() < 1e-6 && (back.g - 0.5).abs() < 1e-6 && (back.b - 0.4).abs() < 1e-6);
/// ```
///
/// # Accuracy
/// Seen under the same light, each component of the color is within 1e-6, for N = 16 bands and more; grays
/// are constant to the bit. Reflectances of sRGB colors are within 0..=1 from 31 bands on. Those of wider
/// spaces are not: of Display P3 on 31 bands they reach -0.21..1.21, of Adobe RGB -0.38..1.38, of BT.2020
/// -0.62..1.62, of ACEScg -0.64..1.64 (`tests/upsample/single_colors.rs`).
///
/// # Cost
/// A color takes 5 ns at N = 31 on x86-64. The spectra take 8 N bytes.
///
/// # Reference
/// I. Mallett, C. Yuksel, "Spectral primary decomposition for rendering with sRGB reflectance", EGSR 2019.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Basis<const N: usize, G = Bins<380, 730>, S = Srgb> {
    red: [f32; N],
    green: [f32; N],
    kind: PhantomData<(G, S)>,
}

impl<const N: usize, G: Grid, S: RgbSpace> Basis<N, G, S> {
    /// Computes the three spectra for the observer, light, grid and RGB space of `viewing`.
    ///
    /// It computes in f64 and is meant for constants. See the [example](#example).
    #[must_use]
    pub const fn new(viewing: &Viewing<N, G, S>) -> Self {
        let spectra = spectra::<N, G>();
        let eye = viewing.eye.weights();
        // The XYZ that the observer sees of each spectrum, and those of the primaries of the space.
        let (mut seen, mut asked): (Matrix64, Matrix64) = ([[0.0; 3]; 3], [[0.0; 3]; 3]);
        const_for!(0..3, |row| {
            const_for!(0..3, |k| {
                asked[row][k] = viewing.to_xyz[row][k] as f64;
                const_for!(0..N, |n| seen[row][k] += eye[row][n] as f64 * spectra[k][n]);
            });
        });
        let mixture = product64(&inverse64(&seen), &asked);
        let (mut red, mut green) = ([0.0; N], [0.0; N]);
        const_for!(0..N, |n| {
            let [r, g, b] = [spectra[0][n], spectra[1][n], spectra[2][n]];
            red[n] = (mixture[0][0] * r + mixture[1][0] * g + mixture[2][0] * b) as f32;
            green[n] = (mixture[0][1] * r + mixture[1][1] * g + mixture[2][1] * b) as f32;
        });
        Basis { red, green, kind: PhantomData }
    }

    /// Returns the reflectance of a color, which is given in linear RGB. See the [example](#example).
    #[must_use]
    #[inline]
    pub fn reflectance(&self, rgb: Rgb<S>) -> Spectrum<Factor, N, G> {
        // The spectrum of blue is 1 minus the other two, so that the three add up to exactly 1.
        let (r, g) = (rgb.r - rgb.b, rgb.g - rgb.b);
        let mut values = [0.0; N];
        for (value, (red, green)) in values.iter_mut().zip(self.red.iter().zip(&self.green)) {
            *value = rgb.b + (r * red + g * green);
        }
        Spectrum::from_bins(values)
    }
}

/// Returns the spectra of red, green and blue at the centers of a grid.
const fn spectra<const N: usize, G: Grid>() -> [[f64; N]; 3] {
    let mut columns = [[0.0; 81]; 2];
    const_for!(0..81, |k| {
        columns[0][k] = BASIS[k][0];
        columns[1][k] = BASIS[k][1];
    });
    let red: Spectrum<Factor, N, G> = on_grid(columns[0]);
    let green: Spectrum<Factor, N, G> = on_grid(columns[1]);
    let mut all = [[0.0; N]; 3];
    const_for!(0..N, |n| {
        let (r, g) = (red.values()[n] as f64, green.values()[n] as f64);
        (all[0][n], all[1][n], all[2][n]) = (r, g, 1.0 - r - g);
    });
    all
}

const fn on_grid<const N: usize, G: Grid>(column: [f32; 81]) -> Spectrum<Factor, N, G> {
    Spectrum::<Factor, 81, Nodes<380, 780>>::from_bins(column).interpolate(Interpolation::Linear)
}
