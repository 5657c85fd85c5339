//! Computes the colors of wavelengths and chromaticities for plots.

use nanospectra::color::{Rgb, Srgb, Xy, Xyz};
use nanospectra::observer::CIE_1931;

/// How quickly the ends of the spectrum become dark. It was chosen by eye, and is slower than in vision.
const FADE: f32 = 0.35;

/// Returns what a display can show of the light of one wavelength (360..=830 nm).
///
/// This is its hue, which becomes darker towards both ends.
pub fn of_wavelength(nm: f32) -> [u8; 3] {
    let k = (nm.clamp(360.0, 830.0) - 360.0) as usize;
    let xyz = Xyz::from(CIE_1931.weights().map(|row| row[k]));
    let seen = (2.0 * (xyz.x + xyz.y + xyz.z)).min(1.0);
    xyz.xy().map_or([0; 3], |xy| encoded(brightest(xy).map(|c| c * seen.powf(FADE))))
}

/// Returns nearly the brightest color of a chromaticity that a display can show.
pub fn of_chromaticity(xy: Xy) -> [u8; 3] {
    encoded(brightest(xy))
}

/// Returns the brightest linear color of a chromaticity, where negative components are set to 0.
///
/// No display reaches a spectral color.
fn brightest(xy: Xy) -> [f32; 3] {
    let linear = xy.xyz(100.0).map_or([0.0; 3], |xyz| Rgb::<Srgb>::from_xyz(xyz).to_array());
    let top = linear.into_iter().fold(f32::MIN_POSITIVE, f32::max);
    linear.map(|c| c.max(0.0) / top)
}

fn encoded([r, g, b]: [f32; 3]) -> [u8; 3] {
    Rgb::<Srgb>::new(r, g, b).encode().to_u8()
}

/// Formats a color as `#rrggbb`.
pub fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}
