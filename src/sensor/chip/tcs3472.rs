//! Describes the TCS3472 of ams OSRAM (TCS34721, TCS34725), which has a red, a green, a blue and a clear
//! channel.
//!
//! # Example
//!
//! ```
//! use nanospectra::sensor::Calibration;
//! use nanospectra::sensor::chip::tcs3472;
//!
//! let exposure = tcs3472::exposure(4.0, 0xf6); // gain 4, 10 cycles of 2.4 ms
//! let [clear, red, green, blue] = [2800_u16, 960, 1200, 700]; // in the order of the registers
//! let basic = exposure.basic_counts(&[red, green, blue, clear])?; // in the order of `CHANNELS`
//! assert!((basic.values()[0] - 10.0).abs() < 1e-5); // 960 / (4 * 24)
//! assert_eq!(tcs3472::CHANNELS[0], "red");
//!
//! // Illuminance by DN40, for a chip without a window: 310 (0.136 R + G - 0.444 B), where the infrared light,
//! // (R + G + B - C) / 2, has been subtracted from R, G and B. As one row:
//! static TO_LUX: Calibration<4, 1> = Calibration::from_rows([[-0.21, 0.654, -0.79, 0.346]]).scaled(310.0);
//! let [lux] = TO_LUX.apply(&basic);
//! assert!((lux - 3225.9).abs() < 0.1); // 310 (0.136 * 930 + 1170 - 0.444 * 670) / (4 * 24)
//!
//! let (gain, atime) = tcs3472::LADDER_SETTINGS[3];
//! assert_eq!(tcs3472::LADDER[3], tcs3472::exposure(gain, atime));
//! # Ok::<(), nanospectra::sensor::ReadingError>(())
//! ```
//!
//! # Reference
//! ams DN40, "Lux and CCT calculations using ams color sensors".

use crate::sensor::Exposure;
use crate::sensor::chip::{Chip, Setting};

/// Returns the exposure that belongs to a gain (one of [`GAINS`]) and the register ATIME.
///
/// The chip integrates for 256 - ATIME cycles, each of which lasts 2.4 ms and adds up to 1024 counts. A light
/// on mains flickers, and its crests may saturate the cell although the average stays below full scale (the
/// data sheet calls this ripple saturation). For times below 150 ms only 75 % of the full scale is therefore
/// trusted.
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

/// The gains that can be set, as factors, in the order of the codes 0 to 3 of register AGAIN.
pub static GAINS: [f32; 4] = [1.0, 4.0, 16.0, 60.0];

/// The names of the channels red, green, blue and clear, where the registers begin with clear.
///
/// See the module's [example](self#example).
pub static CHANNELS: [&str; 4] = ["red", "green", "blue", "clear"];

ladder! {
    /// Exposures from the least to the most sensitive, which take every gain at 50 ms.
    ///
    /// A time of 50 ms averages mains of 50 and of 60 Hz. For glaring light there are 2 and 14 ms below that,
    /// for dim light 200 and 614 ms above it. See the module's [example](self#example).
    [(f32, u8); 8]:
    (1.0, 255), (1.0, 250), (1.0, 235), (4.0, 235), (16.0, 235), (60.0, 235), (60.0, 172), (60.0, 0),
}

/// All facts of this module as a [`Chip`], for programs that let their users choose one.
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
