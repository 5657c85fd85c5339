//! Finds the spectrum of a surface for an RGB color.

use crate::board::board;
#[cfg(feature = "paint")]
use nanospectra::color::EncodedRgb;
use nanospectra::color::Srgb;
use nanospectra::light::D65;
use nanospectra::observer::CIE_1931;
use nanospectra::upsample::{Sigmoid, Viewing};
use nanospectra::{Curve, Nodes};

/// The bands of the spectra, which are every 10 nm in the module `core` and every 5 nm in the module `paint`.
#[cfg(not(feature = "paint"))]
mod bands {
    pub type Grid = super::Nodes<400, 700>;
    pub const N: usize = 31;
}
#[cfg(feature = "paint")]
mod bands {
    pub type Grid = super::Nodes<380, 780>;
    pub const N: usize = 81;
}
pub use bands::{Grid, N};

static VIEWING: Viewing<N, Grid> = Viewing::new(&CIE_1931.under(&D65.fine()).fold(Curve::Step));
/// The start map, which is the small one in the module `core`.
#[cfg(not(feature = "paint"))]
type Start = nanospectra::upsample::LinearStart;
#[cfg(feature = "paint")]
type Start = nanospectra::upsample::CubicStart;
static SIGMOID: Sigmoid<N, Grid, Srgb, Start> = Sigmoid::new(&VIEWING);

/// Writes a reflectance of a linear sRGB color to `out`, with one number for each band. Returns 0, or 1 for a
/// color that no smooth spectrum has, and then nothing is written.
#[cfg(not(feature = "paint"))]
#[unsafe(no_mangle)]
extern "C" fn upsample(r: f32, g: f32, b: f32) -> u32 {
    let Some(solved) = SIGMOID.solve(nanospectra::color::Rgb::new(r, g, b)) else { return 1 };
    if let Some(out) = board().out.first_chunk_mut() {
        *out = *solved.on_grid::<N, Grid>().values();
    }
    0
}

#[cfg(feature = "paint")]
mod methods {
    use super::*;
    use crate::board::put;
    use crate::display::displayed;
    use crate::fixed::Fixed;
    use nanospectra::color::{Lab, Xyz};
    use nanospectra::upsample::{Basis, Smits, Status};
    use nanospectra::{Factor, Observer, Reflectance};

    static BASIS: Basis<N, Grid> = Basis::new(&VIEWING);

    /// The reflectance that was found last.
    static PAINT: Fixed<Reflectance<N, Grid>> = Fixed::new(Reflectance::flat(0.0));

    /// Finds a reflectance of an encoded sRGB color by method 0 (sigmoid), 1 (basis) or 2 (Smits). A color
    /// that no smooth spectrum has is desaturated if `desaturate` is 1, and is otherwise approached as near
    /// as possible. Writes to `out` the 81 numbers of the reflectance, the encoded RGB of its color,
    /// CIEDE2000 between the two colors, and the share of the way from gray that a desaturated color has
    /// kept. Returns 0 for exact, 1 for unreachable, 2 for desaturated, 3 for not within 0..=1, 4 for
    /// approximate, and 5 for not finite.
    #[unsafe(no_mangle)]
    extern "C" fn upsample(r: f32, g: f32, b: f32, method: u32, desaturate: u32) -> u32 {
        let rgb = EncodedRgb::<Srgb>::new(r, g, b).decode();
        let (mut kept, mut status) = (f32::NAN, 4);
        let spectrum = match method {
            0 => {
                let solved =
                    if desaturate == 0 { SIGMOID.reflectance(rgb) } else { SIGMOID.desaturated(rgb) };
                status = match solved.status {
                    Status::Exact => 0,
                    Status::Desaturated { kept: share, .. } => {
                        kept = share;
                        2
                    }
                    Status::NotFinite => 5,
                    _ => 1,
                };
                solved.spectrum.on_grid()
            }
            1 => {
                let spectrum = BASIS.reflectance(rgb);
                let possible = spectrum.values().iter().all(|share| (0.0..=1.0).contains(share));
                status = if possible { 0 } else { 3 };
                spectrum
            }
            // Making its curves anew takes 70 numbers in the module instead of 567.
            _ => Smits::<N, Grid>::new().reflectance(rgb),
        };
        let out = &mut board().out;
        put(out, 0, *spectrum.values());
        put(out, N, VIEWING.rgb(&spectrum).encode().to_array());
        put(out, N + 3, [VIEWING.delta_e(rgb, &spectrum), kept]);
        *PAINT.get() = spectrum;
        status
    }

    /// Computes the color of that reflectance under the light in `light`. Writes to `out` X, Y, Z (Y = 100
    /// for white), L*, a*, b*, and 8-bit sRGB adapted to D65. Returns 0, or 1 if the light is dark.
    #[unsafe(no_mangle)]
    extern "C" fn paint_under() -> u32 {
        let board = &mut *board();
        let eye: Observer<3, N, Factor, Grid> =
            CIE_1931.under(&board.light).fold(Curve::Step).with_white_y(100.0);
        let white = Xyz::from(eye.row_sums().map(|sum| sum as f32));
        if white.with_y(100.0).is_none() {
            return 1;
        }
        let seen = Xyz::from(eye.sees(&*PAINT.get()));
        let lab = seen.lab(white).unwrap_or(Lab::new(f32::NAN, f32::NAN, f32::NAN));
        let (_, code) = displayed(seen, white);
        put(&mut board.out, 0, seen.to_array());
        put(&mut board.out, 3, [lab.l, lab.a, lab.b]);
        put(&mut board.out, 6, code);
        0
    }
}
