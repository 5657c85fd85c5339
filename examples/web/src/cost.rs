//! Computes the color errors of few bands, by every curve of `fold`, against the sum at 1 nm over the 99
//! color evaluation samples.

use crate::board::board;
use crate::fixed::Fixed;
use nanospectra::color::{Lab, Xyz, ciede2000};
use nanospectra::matter::CES;
use nanospectra::observer::CIE_1931;
use nanospectra::{Bins, Curve, Factor, Fine, Grid, Light, Observer, Power, Reflectance};

const SAMPLES: usize = 99;
const NOWHERE: Lab = Lab { l: f32::NAN, a: f32::NAN, b: f32::NAN };

/// The colors of the samples under the light, by the sum at 1 nm.
static TRUTH: Fixed<[Lab; SAMPLES]> = Fixed::new([NOWHERE; SAMPLES]);

fn lab([x, y, z]: [f32; 3], white: [f32; 3]) -> Lab {
    Xyz::new(x, y, z).lab(Xyz::from(white)).unwrap_or(NOWHERE)
}

/// Computes the colors of the samples under the light in `curve`, by the sum at 1 nm.
#[unsafe(no_mangle)]
extern "C" fn look_closely() {
    let eye = CIE_1931.under(&board().curve);
    let white = eye.sees(&Fine::flat(1.0));
    for (seen, sample) in TRUTH.get().iter_mut().zip(&CES) {
        let fine: Fine<Factor> = sample.fine();
        *seen = lab(eye.sees(&fine), white);
    }
}

/// Computes CIEDE2000 of each sample on N bins, with the light and the observer folded by `curve`, or for 3
/// by the averages of both.
#[inline(never)]
fn errors<const N: usize, G: Grid>(light: &Fine<Power>, curve: u32, out: &mut [f32]) {
    let under = |curve| CIE_1931.under(light).fold(curve);
    let eye: Observer<3, N, Factor, G> = match curve {
        0 => under(Curve::Step),
        1 => under(Curve::Parabola),
        2 => under(Curve::Spline),
        _ => {
            let eye: Observer<3, N, Power, G> = CIE_1931.fold(Curve::Step);
            let light: Light<N, G> = light.resample();
            eye.under(&light)
        }
    };
    let white = eye.sees(&Reflectance::flat(1.0));
    for ((error, sample), truth) in out.iter_mut().zip(&CES).zip(TRUTH.get().iter()) {
        let surface: Reflectance<N, G> = sample.resample();
        *error = ciede2000(lab(eye.sees(&surface), white), *truth);
    }
}

/// Writes CIEDE2000 of the 99 samples to `out`, for `bands` bands over range 0 (380..730 nm), 1 (400..700 nm)
/// or 2 (360..830 nm), under the light of the last [`look_closely`], by scheme 0 (step), 1 (parabola), 2
/// (spline) or 3 (not folded). Returns 0, or 1 for a combination that is not compiled in.
#[unsafe(no_mangle)]
extern "C" fn look_coarsely(bands: u32, range: u32, scheme: u32) -> u32 {
    let board = &mut *board();
    let (light, out) = (&board.curve, &mut board.out[..]);
    macro_rules! grids {
        ($($count:literal)*) => {
            match (bands, range) {
                $(
                    ($count, 0) => errors::<$count, Bins<380, 730>>(light, scheme, out),
                    ($count, 1) => errors::<$count, Bins<400, 700>>(light, scheme, out),
                    ($count, 2) => errors::<$count, Bins<360, 830>>(light, scheme, out),
                )*
                _ => return 1,
            }
        };
    }
    grids!(8 12 16 20 24 31 36 40 60 81);
    0
}
