//! TCS3472 of ams OSRAM (TCS34721, TCS34725): red, green, blue and clear.
//!
//! # Reference
//! ams DN40, "Lux and CCT calculations using ams color sensors".

use crate::sensor::Exposure;
use crate::sensor::chip::{Chip, Setting};

/// The exposure of these settings: the gain (one of [`GAINS`]) and the register ATIME. Each of 256 - ATIME
/// cycles lasts 2.4 ms and fills 1024 counts. Shorter than 150 ms a light on mains may saturate the cell in
/// its crests while the average does not show it (ripple): only 75 % of the full scale are trusted there.
///
/// ```
/// # use nanospectra::sensor::chip::tcs3472;
/// let exposure = tcs3472::exposure(4.0, 0xf6); // 10 cycles
/// assert!((exposure.time_ms() - 24.0).abs() < 1e-4);
/// assert_eq!(exposure.full_scale(), 7680);
/// ```
#[must_use]
pub const fn exposure(gain: f32, atime: u8) -> Exposure {
    let cycles = 256 - atime as u32;
    let counts = 1024 * cycles;
    let counts = if counts < 65_535 { counts } else { 65_535 };
    let ripples = cycles * 24 < 1500;
    Exposure::new(gain, cycles as f32 * 2.4, if ripples { counts - counts / 4 } else { counts })
}

/// The gains of register AGAIN, 0 to 3.
pub static GAINS: [f32; 4] = [1.0, 4.0, 16.0, 60.0];

/// Red, green, blue, clear. The registers begin with clear.
pub static CHANNELS: [&str; 4] = ["red", "green", "blue", "clear"];

ladder! {
    /// Every gain at 50 ms, which averages mains of 50 and of 60 Hz, 2 and 14 ms below that for glaring
    /// light, 200 and 614 ms above it.
    [(f32, u8); 8]:
    (1.0, 255), (1.0, 250), (1.0, 235), (4.0, 235), (16.0, 235), (60.0, 235), (60.0, 172), (60.0, 0),
}

/// All facts of this module as data.
pub static CHIP: Chip = Chip {
    name: "TCS3472",
    summary: "red, green, blue and clear",
    channels: &CHANNELS,
    settings: &[Setting::gain(&GAINS), Setting::register("atime", 255)],
    ladder: &STEPS,
    largest_count: 65_535,
    whole_counts: true,
    to_xyz: None,
    to_lux: None,
    exposure: |settings| match *settings {
        [gain, atime] => Some(exposure(gain, atime as u8)),
        _ => None,
    },
    nominal: None,
};
