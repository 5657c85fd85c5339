//! Readings of an AS7341: counts of its channels F1 to F8, all in the same exposure.
//!
//! The counts are computed, not measured. They are those of the nominal channels
//! (`nanospectra::sensor::chip::as7341::NOMINAL`) under lamps of the CIE at the given illuminance. The
//! readings of a real chip have noise, and its channels lie 5 to 10 nm elsewhere.

use nanospectra::sensor::{Exposure, chip::as7341};

/// The exposure of all readings: gain 16, ATIME 29 and ASTEP 599, which is 50 ms with a full scale of 18 000.
pub static EXPOSURE: Exposure = as7341::exposure(16.0, 29, 599);

/// The counts under illuminant A at 500 lx.
pub static INCANDESCENT: [u16; 8] = [474, 874, 1636, 2537, 3523, 4555, 7046, 9000];
/// The counts under D65 at 1000 lx.
pub static DAYLIGHT: [u16; 8] = [4427, 6148, 7778, 7991, 7531, 7036, 8114, 7586];
/// The counts under FL11 at 500 lx, whose lines the channels resolve badly.
pub static FLUORESCENT: [u16; 8] = [858, 2108, 1930, 1834, 4693, 3781, 4361, 840];
/// The counts under LED-B1 at 500 lx.
pub static LED: [u16; 8] = [106, 1023, 1182, 2001, 3619, 5224, 6082, 3066];
/// The counts under a black body of 4000 K at 300 lx.
pub static BLACK_BODY: [u16; 8] = [709, 1034, 1530, 1940, 2209, 2453, 3254, 3522];

/// How many readings per second the recording has.
pub const RATE_HZ: f32 = 10.0;
/// The frequency at which the LED in the recording gets brighter and darker.
pub const BREATH_HZ: f32 = 2.0;

/// A recording of a desk under an LED that gets brighter and darker. Then somebody opens the curtain and
/// shades the chip, and at last there is daylight.
pub static RECORDING: [[u16; 8]; 14] = [
    LED,
    BREATH[0],
    BREATH[1],
    BREATH[2],
    BREATH[3],
    LED,
    BREATH[0],
    BREATH[1],
    BREATH[2],
    BREATH[3],
    [11511, 15984, 18000, 18000, 18000, 18000, 18000, 18000],
    [0; 8],
    DAYLIGHT,
    [4471, 6209, 7855, 8071, 7606, 7106, 8195, 7662],
];

/// The counts of the LED when it is 11 % brighter, 7 % brighter, 7 % darker and 11 % darker.
const BREATH: [[u16; 8]; 4] = [
    [118, 1140, 1316, 2230, 4032, 5820, 6776, 3416],
    [114, 1095, 1265, 2142, 3874, 5592, 6511, 3282],
    [99, 951, 1098, 1860, 3363, 4855, 5653, 2850],
    [94, 906, 1047, 1773, 3206, 4628, 5388, 2716],
];
