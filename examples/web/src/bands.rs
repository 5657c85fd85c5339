//! Turns many spectra of a 5 nm instrument into X, Y, Z, in a module that is built for speed.

use crate::fixed::Fixed;
use core::mem::offset_of;
use nanospectra::observer::CIE_1931;
use nanospectra::{Curve, Light, Nodes, Observer, Power};

type Grid = Nodes<380, 780>;
/// The most spectra of a batch.
const READINGS: usize = 1024;

static EYE: Observer<3, 81, Power, Grid> = CIE_1931.fold(Curve::Spline);

/// The spectra of 81 bands that come in, and X, Y, Z of each that go out.
struct Readings {
    spectra: [Light<81, Grid>; READINGS],
    xyz: [[f32; 3]; READINGS],
}

static INSTRUMENT: Fixed<Readings> =
    Fixed::new(Readings { spectra: [Light::flat(0.0); READINGS], xyz: [[0.0; 3]; READINGS] });

#[unsafe(no_mangle)]
extern "C" fn spectra() -> *mut Light<81, Grid> {
    INSTRUMENT.address().wrapping_byte_add(offset_of!(Readings, spectra)).cast()
}

#[unsafe(no_mangle)]
extern "C" fn xyz() -> *mut [f32; 3] {
    INSTRUMENT.address().wrapping_byte_add(offset_of!(Readings, xyz)).cast()
}

/// Computes X, Y, Z of the first `count` spectra, by the CIE 1931 functions folded to their bands.
#[unsafe(no_mangle)]
extern "C" fn measure(count: u32) {
    let Readings { spectra, xyz } = &mut *INSTRUMENT.get();
    EYE.sees_each(spectra.get(..count as usize).unwrap_or(spectra), xyz);
}

/// Computes the same by one plain sum for each channel, to compare speeds.
#[cfg(feature = "bench")]
#[unsafe(no_mangle)]
extern "C" fn measure_plainly(count: u32) {
    let Readings { spectra, xyz } = &mut *INSTRUMENT.get();
    for (spectrum, xyz) in spectra.iter().zip(xyz).take(count as usize) {
        for (value, row) in xyz.iter_mut().zip(EYE.weights()) {
            *value = row.iter().zip(spectrum.values()).fold(0.0, |sum, (a, b)| sum + a * b);
        }
    }
}
