//! The quantities of a light: color rendering, efficacy, its effects on the body clock and on plants, and its
//! dominant wavelength.

use crate::board::{Board, board, put};
use crate::fixed::Fixed;
use crate::measure::{at, eye};
use core::mem::offset_of;
use nanospectra::color::{Cri, RenderingError, Tm30, Xy, cri, dominant_wavelength, tm30};
use nanospectra::radiometry::{AlphaOpic, illuminance, luminous_efficacy, photon_flux};
use nanospectra::{Fine, Power};

/// Writes to `out` the dominant wavelength and the purity of the chromaticity that is there, relative to a
/// white.
#[unsafe(no_mangle)]
extern "C" fn dominant(observer: u32, white_x: f32, white_y: f32) {
    let out = &mut board().out;
    let [x, y] = [out[at::CHROMATICITY], out[at::CHROMATICITY + 1]];
    let found = dominant_wavelength(Xy { x, y }, Xy { x: white_x, y: white_y }, eye(observer));
    let values = found.map_or([f32::NAN, 0.0], |dominant| [dominant.nm, dominant.purity]);
    out[..2].copy_from_slice(&values);
}

/// The bands of photons in nm: PAR and ePAR; blue, green, red and far red; then the two of R:FR.
const PHOTONS: [(f32, f32); 8] = [
    (400.0, 700.0),
    (400.0, 750.0),
    (400.0, 500.0),
    (500.0, 600.0),
    (600.0, 700.0),
    (700.0, 800.0),
    (655.0, 665.0),
    (725.0, 735.0),
];

/// Writes to `out` the luminous efficacy of radiation in lm/W and the daylight efficacy ratios of the five
/// receptors, which are NaN if they are not defined. Behind them are, for a light in W/m2/nm, the alpha-opic
/// irradiances in W/m2, the equivalent daylight illuminances in lx, the illuminance in lx, and the photons of
/// each of [`PHOTONS`] in umol/m2/s.
#[unsafe(no_mangle)]
extern "C" fn photometry() {
    let board = &mut *board();
    let (light, out) = (&board.curve, &mut board.out);
    let alpha_opic = AlphaOpic::new(light);
    put(out, 0, [luminous_efficacy(light).unwrap_or(f32::NAN)]);
    put(out, 1, AlphaOpic::der(light).map_or([f32::NAN; 5], AlphaOpic::to_array));
    put(out, 6, alpha_opic.to_array());
    put(out, 11, alpha_opic.edi().to_array());
    put(out, 16, [illuminance(light)]);
    put(out, 17, PHOTONS.map(|(from, to)| photon_flux(light, from, to)));
}

/// Returns the reason why there is no color rendering as a number; 0 stands for success.
fn reason(error: RenderingError) -> u32 {
    use nanospectra::color::Cct;
    match error {
        RenderingError::Dark => 1,
        RenderingError::Unreal => 2,
        RenderingError::NoReference(Cct::TooCold) => 3,
        RenderingError::NoReference(Cct::TooHot) => 4,
        _ => 5,
    }
}

fn put_cri(light: &Fine<Power>, out: &mut [f32; 17]) -> u32 {
    match cri(light) {
        Ok(Cri { ra, r, dc, .. }) => {
            let [out_ra, out_dc, out_r @ ..] = out;
            (*out_ra, *out_dc, *out_r) = (ra, dc, r);
            0
        }
        Err(error) => reason(error),
    }
}

/// Writes to `out` Ra, the distance to the reference and R1..R15. Returns 0, or the reason why there are
/// none.
#[unsafe(no_mangle)]
extern "C" fn rendering() -> u32 {
    let Board { curve, out, .. } = &mut *board();
    out.first_chunk_mut().map_or(0, |out| put_cri(curve, out))
}

/// Writes to `out` Rf and Rg; then Rf, chroma shift, hue shift and the number of samples for each of 16 hue
/// bins; then Rf of the 99 samples. Returns 0, or the reason why there are none.
#[unsafe(no_mangle)]
extern "C" fn fidelity() -> u32 {
    let board = &mut *board();
    match tm30(&board.curve) {
        Ok(Tm30 { rf, rg, rf_ces, bins, .. }) => {
            let out = &mut board.out;
            put(out, 0, [rf, rg]);
            for (k, bin) in bins.iter().enumerate() {
                let values = match bin {
                    Some(bin) => [bin.rf, bin.chroma_shift, bin.hue_shift, f32::from(bin.count)],
                    None => [f32::NAN, f32::NAN, f32::NAN, 0.0],
                };
                put(out, 2 + 4 * k, values);
            }
            put(out, 2 + 4 * 16, rf_ces);
            0
        }
        Err(error) => reason(error),
    }
}

/// The most lights of a batch.
const BATCH: usize = 512;

/// A batch, with 471 numbers of each light that come in and 20 that go out.
struct Batch {
    lights: [Fine<Power>; BATCH],
    results: [[f32; 20]; BATCH],
}

static BATCHES: Fixed<Batch> =
    Fixed::new(Batch { lights: [Fine::flat(0.0); BATCH], results: [[0.0; 20]; BATCH] });

#[unsafe(no_mangle)]
extern "C" fn batch_lights() -> *mut Fine<Power> {
    BATCHES.address().wrapping_byte_add(offset_of!(Batch, lights)).cast()
}

#[unsafe(no_mangle)]
extern "C" fn batch_results() -> *mut [f32; 20] {
    BATCHES.address().wrapping_byte_add(offset_of!(Batch, results)).cast()
}

/// Computes for each of the first `count` lights X, Y, Z (sums with the CIE 1931 functions), then Ra, the
/// distance to the reference and R1..R15, which are NaN where there are none.
#[unsafe(no_mangle)]
extern "C" fn measure_batch(count: u32) {
    let Batch { lights, results } = &mut *BATCHES.get();
    for (light, result) in lights.iter().zip(results).take(count as usize) {
        let [x, y, z, rest @ ..] = result;
        [*x, *y, *z] = eye(0).sees(light);
        if put_cri(light, rest) != 0 {
            *rest = [f32::NAN; 17];
        }
    }
}
