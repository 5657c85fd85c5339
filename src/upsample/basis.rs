//! Three fixed spectra, mixed in proportion: the fastest way, and the only linear one.

use crate::color::matrix::{Matrix64, inverse64, product64};
use crate::color::{Rgb, RgbSpace, Srgb};
use crate::grid::{Bins, Grid, Nodes};
use crate::math::const_for;
use crate::spectrum::{Factor, Interpolation, Spectrum};
use crate::upsample::tables::BASIS;
use crate::upsample::viewing::Viewing;
use core::marker::PhantomData;

/// Upsampling as r R + g G + b B with three spectra that sum to 1.
///
/// The three are the smoothest that have the colors of the sRGB primaries under D65 on 5 nm and stay within
/// 0.012..=0.976 (`tests/upsample/tables.rs` makes them, from CIE data alone). For the grid, light and space
/// at hand they are mixed by a 3x3 matrix that makes them exact there.
///
/// Linear: the spectrum of a mixture of lights is the mixture of their spectra, components below 0 and above
/// 1 included, and NaN stays NaN. Components above 4e37 in size overflow.
///
/// # Accuracy
/// The color comes back within 1e-6, for N = 16 bands and more; grays are constant to the bit. sRGB colors
/// are within 0..=1 from 31 bands on. Those of wider spaces are not: of Display P3 on 31 bands they reach
/// -0.21..1.21, of Adobe RGB -0.38..1.38, of BT.2020 -0.62..1.62, of ACEScg -0.64..1.64
/// (`tests/upsample/single_colors.rs`).
///
/// # Cost
/// 5 ns at N = 31 on x86-64; 8 N bytes.
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
    /// For this eye, light, grid and RGB space; for `const` use.
    ///
    /// ```
    /// use nanospectra::color::Rgb;
    /// use nanospectra::upsample::{Basis, Viewing};
    /// use nanospectra::{Bins, Curve, light::D65, observer::CIE_1931};
    /// static VIEWING: Viewing<36> =
    ///     Viewing::new(&CIE_1931.under(&D65.fine()).fold(Curve::Step));
    /// static BASIS: Basis<36> = Basis::new(&VIEWING);
    /// let teal = BASIS.reflectance(Rgb::new(0.1, 0.5, 0.4));
    /// let back = VIEWING.rgb(&teal);
    /// assert!((back.r - 0.1).abs() < 1e-6 && (back.g - 0.5).abs() < 1e-6 && (back.b - 0.4).abs() < 1e-6);
    /// ```
    #[must_use]
    pub const fn new(viewing: &Viewing<N, G, S>) -> Self {
        let spectra = spectra::<N, G>();
        let eye = viewing.eye.weights();
        // XYZ of each spectrum, and what makes those of the primaries of them.
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

    /// The reflectance of a color (linear RGB).
    #[must_use]
    #[inline]
    pub fn reflectance(&self, rgb: Rgb<S>) -> Spectrum<Factor, N, G> {
        // Blue is what the others leave of 1, so the three sum to exactly 1.
        let (r, g) = (rgb.r - rgb.b, rgb.g - rgb.b);
        let mut values = [0.0; N];
        for (value, (red, green)) in values.iter_mut().zip(self.red.iter().zip(&self.green)) {
            *value = rgb.b + (r * red + g * green);
        }
        Spectrum::from_bins(values)
    }
}

/// Red, green and blue at the centers of a grid.
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
