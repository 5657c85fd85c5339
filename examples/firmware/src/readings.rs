//! What an AS7341 has said: counts of its channels F1 to F8, all in one exposure.
//!
//! No chip was at hand: these are counts of the nominal channels
//! (`nanospectra::sensor::chip::as7341::NOMINAL`) under lamps of the CIE, at the illuminance given. What a
//! chip on a bench says has noise, and channels 5 to 10 nm elsewhere.

use nanospectra::sensor::{Exposure, chip::as7341};

/// Gain 16, ATIME 29, ASTEP 599: 50 ms, and full scale is 18 000.
pub static EXPOSURE: Exposure = as7341::exposure(16.0, 29, 599);

/// Illuminant A at 500 lx.
pub static INCANDESCENT: [u16; 8] = [474, 874, 1636, 2537, 3523, 4555, 7046, 9000];
/// D65 at 1000 lx.
pub static DAYLIGHT: [u16; 8] = [4427, 6148, 7778, 7991, 7531, 7036, 8114, 7586];
/// FL11 at 500 lx: lines that the channels see badly.
pub static FLUORESCENT: [u16; 8] = [858, 2108, 1930, 1834, 4693, 3781, 4361, 840];
/// LED-B1 at 500 lx.
pub static LED: [u16; 8] = [106, 1023, 1182, 2001, 3619, 5224, 6082, 3066];
/// A black body of 4000 K at 300 lx.
pub static BLACK_BODY: [u16; 8] = [709, 1034, 1530, 1940, 2209, 2453, 3254, 3522];

/// How many readings a second the recording has.
pub const RATE_HZ: f32 = 10.0;
/// How often the LED in it breathes.
pub const BREATH_HZ: f32 = 2.0;

/// A desk under an LED that breathes; somebody opens the curtain, shades the chip, and lets the day in.
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

/// The LED 11 % brighter, 7 % brighter, 7 % and 11 % darker.
const BREATH: [[u16; 8]; 4] = [
    [118, 1140, 1316, 2230, 4032, 5820, 6776, 3416],
    [114, 1095, 1265, 2142, 3874, 5592, 6511, 3282],
    [99, 951, 1098, 1860, 3363, 4855, 5653, 2850],
    [94, 906, 1047, 1773, 3206, 4628, 5388, 2716],
];
