//! From RGB to spectra.

mod all;
mod any_color;
mod digits;
mod displays;
mod fit;
mod from_rgb;
#[cfg(feature = "libm")]
mod hard;
mod reach;
mod single_colors;
mod tables;
mod worst_reflectances;

#[cfg(feature = "libm")]
use nanospectra::{Fine, Power, light::D65};

#[cfg(feature = "libm")]
const LIGHT: Fine<Power> = D65.fine();

/// Every color of an n^3 cube of encoded values.
#[cfg(feature = "libm")]
fn cube(n: usize, mut f: impl FnMut([f32; 3])) {
    let level = |k: usize| k as f32 / (n - 1) as f32;
    for r in 0..n {
        for g in 0..n {
            for b in 0..n {
                f([level(r), level(g), level(b)]);
            }
        }
    }
}
