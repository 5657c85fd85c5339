//! Computes the color of a light, and what the colors of lights and surfaces share.

use crate::board::{Out, board, put};
use nanospectra::FineObserver;
use nanospectra::color::{Cct, Rgb, Srgb, Uv1960, Uv1976, Xy, Xyz};
use nanospectra::observer::{CIE_1931, KM};

/// The places of results in `out`. A result that is not defined is NaN.
pub mod at {
    /// X, Y, Z with Y = 100 for a light, or for the perfect white in the light of a surface.
    pub const XYZ: usize = 0;
    /// For lights, X, Y, Z of the curve as it is, times 683.002.
    pub const ABSOLUTE: usize = 3;
    /// x, y; then u, v of 1960; then u', v' of 1976.
    pub const CHROMATICITY: usize = 6;
    /// Correlated color temperature in K, Duv, and the reason of [`white`](super::white).
    pub const CCT: usize = 12;
    /// Encoded sRGB, then its 8-bit codes, then 1 if the color was in the gamut. The module `core` only has
    /// linear sRGB here.
    pub const SRGB: usize = 15;
    /// For surfaces, L*, a*, b* and CIEDE2000 to white.
    #[cfg(feature = "light")]
    pub const LAB: usize = 22;
}

/// Returns the observer by its place in the list of names.
pub fn eye(number: u32) -> &'static FineObserver<3> {
    #[cfg(feature = "light")]
    if let Some(named) = nanospectra::observer::ALL.get(number as usize) {
        return named.functions;
    }
    let _ = number;
    &CIE_1931
}

/// Computes the color of the light in `curve`. Returns 0, or 1 if its Y is not above zero.
#[unsafe(no_mangle)]
extern "C" fn see_light(observer: u32) -> u32 {
    let board = &mut *board();
    let seen = Xyz::from(eye(observer).sees(&board.curve));
    let standard = if observer == 0 { seen } else { Xyz::from(CIE_1931.sees(&board.curve)) };
    let Some(relative) = seen.with_y(100.0).filter(|_| standard.y > 0.0) else { return 1 };
    let out = &mut board.out;
    put(out, at::XYZ, relative.to_array());
    put(out, at::ABSOLUTE, seen.to_array().map(|value| value * KM));
    chromaticity(out, relative);
    put(out, at::CCT, white(standard));
    show(out, Rgb::from_xyz(relative));
    0
}

/// Writes to `out` L*, a*, b* of X, Y, Z relative to a white. Returns 0, or 1 if that is not a white.
#[unsafe(no_mangle)]
extern "C" fn lab(x: f32, y: f32, z: f32, white_x: f32, white_y: f32, white_z: f32) -> u32 {
    let Some(lab) = Xyz::new(x, y, z).lab(Xyz::new(white_x, white_y, white_z)) else { return 1 };
    put(&mut board().out, 0, [lab.l, lab.a, lab.b]);
    0
}

#[cfg_attr(feature = "light", inline(never))]
pub fn chromaticity(out: &mut Out, xyz: Xyz) {
    let nan = f32::NAN;
    let Xy { x, y } = xyz.xy().unwrap_or(Xy { x: nan, y: nan });
    let uv = xyz.uv1960().unwrap_or(Uv1960 { u: nan, v: nan });
    let uv1976 = xyz.uv1976().unwrap_or(Uv1976 { u: nan, v: nan });
    put(out, at::CHROMATICITY, [x, y, uv.u, uv.v, uv1976.u, uv1976.v]);
}

/// Returns CCT, Duv and 0. If these are not defined, the third number is 1 for too cold, 2 for too hot, 3 for
/// too far from the locus, and 4 for no chromaticity.
fn white(xyz: Xyz) -> [f32; 3] {
    let why = match xyz.cct() {
        Some(Cct::Near { cct_k, duv }) => return [cct_k, duv, 0.0],
        Some(Cct::TooCold) => 1.0,
        Some(Cct::TooHot) => 2.0,
        Some(_) => 3.0,
        None => 4.0,
    };
    [f32::NAN, f32::NAN, why]
}

/// Writes the color as a display shows it, clipped: encoded, in 8 bits, and whether it was in the gamut.
#[cfg(feature = "light")]
#[inline(never)]
pub fn show(out: &mut Out, color: Rgb<Srgb>) {
    let clipped = color.clip().rgb;
    let code = clipped.encode();
    // Rounding can leave a white beyond the gamut by this little.
    let inside = color.to_array().iter().zip(clipped.to_array()).all(|(a, b)| (a - b).abs() <= 1e-5);
    put(out, at::SRGB, code.to_array());
    put(out, at::SRGB + 3, code.to_u8().map(f32::from));
    put(out, at::SRGB + 6, [f32::from(u8::from(inside))]);
}

/// Writes the color as a display shows it, clipped and linear, since JavaScript has a power function of its
/// own.
#[cfg(not(feature = "light"))]
fn show(out: &mut Out, color: Rgb<Srgb>) {
    put(out, at::SRGB, color.clip().rgb.to_array());
}
