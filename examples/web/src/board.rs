//! The memory that JavaScript and the module share. It has fixed buffers, whose addresses JavaScript asks for
//! once.

use crate::fixed::Fixed;
use core::cell::RefMut;
use core::mem::offset_of;
use nanospectra::{Fine, Interpolation, Outside, Power, SamplesError, Spectrum};

/// The most samples that a spectrum can have; spectrometers have 2048 or 3648 pixels.
pub const CAPACITY: usize = 4096;

/// The results for JavaScript.
pub type Out = [f32; 512];

/// All inputs and results.
pub struct Board {
    /// The samples that JavaScript gives, as pairs of wavelength in nm and value.
    pub samples: [(f32, f32); CAPACITY],
    /// The spectrum at every nanometer of 360..=830, to which JavaScript may also write.
    pub curve: Fine<Power>,
    /// The light on surfaces at every nanometer, to which JavaScript may also write.
    pub light: Fine<Power>,
    /// The results, in places that each function documents.
    pub out: Out,
}

// JavaScript writes the two numbers of a pair one after the other.
const _: () = assert!(offset_of!((f32, f32), 0) == 0 && offset_of!((f32, f32), 1) == 4);

static BOARD: Fixed<Board> = Fixed::new(Board {
    samples: [(0.0, 0.0); CAPACITY],
    curve: Spectrum::flat(0.0),
    light: Spectrum::flat(0.0),
    out: [0.0; 512],
});

/// Returns all of it, until what is returned is dropped.
pub fn board() -> RefMut<'static, Board> {
    BOARD.get()
}

#[unsafe(no_mangle)]
extern "C" fn samples() -> *mut (f32, f32) {
    BOARD.address().wrapping_byte_add(offset_of!(Board, samples)).cast()
}

#[unsafe(no_mangle)]
extern "C" fn curve() -> *mut f32 {
    BOARD.address().wrapping_byte_add(offset_of!(Board, curve)).cast()
}

#[unsafe(no_mangle)]
extern "C" fn light() -> *mut f32 {
    BOARD.address().wrapping_byte_add(offset_of!(Board, light)).cast()
}

#[unsafe(no_mangle)]
extern "C" fn out() -> *mut f32 {
    BOARD.address().wrapping_byte_add(offset_of!(Board, out)).cast()
}

/// Writes numbers from place `at` on. The number of values is known and the function is inlined, so that
/// nothing has to be checked at run time.
#[cfg(not(feature = "cost"))]
#[inline(always)]
pub fn put<const N: usize>(out: &mut Out, at: usize, values: [f32; N]) {
    if let Some(slots) = out.get_mut(at..).and_then(|rest| rest.first_chunk_mut()) {
        *slots = values;
    }
}

/// Returns the first `count` samples.
pub fn given(samples: &[(f32, f32); CAPACITY], count: u32) -> &[(f32, f32)] {
    samples.get(..count as usize).unwrap_or(samples)
}

/// Returns an error as a number: its kind, plus 8 times the index of the sample or the number that is needed.
pub fn code(error: SamplesError) -> u32 {
    match error {
        SamplesError::TooFew { needed } => 1 + 8 * needed as u32,
        SamplesError::NotFinite { index } => 2 + 8 * index as u32,
        SamplesError::NotIncreasing { index } => 3 + 8 * index as u32,
        _ => 5,
    }
}

/// Interpolates the samples at every nanometer into `curve`, by straight lines. (JavaScript follows Sprague's
/// rule by the same operations, since it needs them for the measured tables too.) Outside the samples the curve
/// is zero, or holds the end values if `hold` is 1. Returns 0, or the [`code`] of an error.
#[unsafe(no_mangle)]
extern "C" fn interpolate(count: u32, hold: u32) -> u32 {
    let board = &mut *board();
    let outside = if hold == 0 { Outside::Zero } else { Outside::Hold };
    match Fine::interpolated_outside(given(&board.samples, count), Interpolation::Linear, outside) {
        Ok(fine) => {
            board.curve = fine;
            0
        }
        Err(error) => code(error),
    }
}

/// Writes the spectrum of a black body, scaled to 1 at 560 nm, to `curve`.
#[cfg(any(feature = "light", feature = "scene"))]
#[unsafe(no_mangle)]
extern "C" fn black_body(kelvin: f32) {
    board().curve = Fine::at_centers(|nm| nanospectra::light::blackbody_relative(nm, kelvin));
}
