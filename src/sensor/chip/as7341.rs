//! Describes the AS7341 of ams OSRAM, which has eight bands in the visible, a clear and an infrared channel.
//!
//! # Example
//!
//! ```
//! use nanospectra::sensor::chip::as7341;
//!
//! let exposure = as7341::exposure(16.0, 29, 599); // gain 16, ATIME 29, ASTEP 599
//! assert!((exposure.time_ms() - 50.04).abs() < 1e-3); // 30 * 600 * 2.78 us
//! assert_eq!(exposure.full_scale(), 18_000); // 30 * 600
//! // F2 peaks at 445 nm and is half as sensitive at 460 nm.
//! assert_eq!(as7341::CHANNELS[1], "f2");
//! assert!((as7341::NOMINAL.weights()[1][460 - 360] - 0.5).abs() < 1e-6);
//! // One step of the ladder up doubles the gain.
//! let (gain, atime, astep) = as7341::LADDER_SETTINGS[8];
//! assert_eq!(as7341::LADDER[8], as7341::exposure(gain, atime, astep));
//! assert_eq!(as7341::LADDER[8].gain(), 2.0 * as7341::LADDER[7].gain());
//! ```
//!
//! # Reference
//! Data sheet DS000504.

use crate::observer::FineObserver;
use crate::sensor::chip::{Chip, Nominal, Setting};
use crate::sensor::{Exposure, gaussian_responsivities};

/// Returns the exposure that belongs to a gain (one of [`GAINS`]) and the registers ATIME and ASTEP.
///
/// The time is (ATIME + 1) (ASTEP + 1) 2.78 us, and the same product is the full scale if it is below 65,535.
/// ASTEP is at most 65,534.
///
/// ```
/// # use nanospectra::sensor::chip::as7341;
/// let exposure = as7341::exposure(16.0, 29, 599);
/// assert!((exposure.time_ms() - 50.04).abs() < 1e-3);
/// assert_eq!(exposure.full_scale(), 18_000); // and not 65 535
/// ```
#[must_use]
pub const fn exposure(gain: f32, atime: u8, astep: u16) -> Exposure {
    let steps = (atime as u32 + 1) * (astep as u32 + 1);
    Exposure::new(gain, steps as f32 * 2.78e-3, if steps < 65_535 { steps } else { 65_535 })
}

/// The gains that can be set, as factors, in the order of the codes 0 to 10 of register AGAIN.
pub static GAINS: [f32; 11] = [0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0, 256.0, 512.0];

/// The names of the channels F1 to F8, which are sorted by wavelength.
///
/// Drivers give clear and near infrared too, behind F8 or behind both F4 and F8, which [`NOMINAL`] does not
/// have. See the module's [example](self#example).
pub static CHANNELS: [&str; 8] = ["f1", "f2", "f3", "f4", "f5", "f6", "f7", "f8"];

ladder! {
    /// Exposures from the least to the most sensitive, which take every gain at 50 ms.
    ///
    /// A time of 50 ms averages mains of 50 and of 60 Hz. For glaring light there are 5 and 15 ms below that,
    /// for dim light 100 and 200 ms above it. The ladder spans more than four and a half decades of
    /// sensitivity. See the module's [example](self#example).
    [(f32, u8, u16); 15]:
    (0.5, 2, 599), (0.5, 8, 599), (0.5, 29, 599), (1.0, 29, 599), (2.0, 29, 599), (4.0, 29, 599),
    (8.0, 29, 599), (16.0, 29, 599), (32.0, 29, 599), (64.0, 29, 599), (128.0, 29, 599), (256.0, 29, 599),
    (512.0, 29, 599), (512.0, 59, 599), (512.0, 119, 599),
}

/// The nominal responsivities of F1 to F8, which are Gaussians that peak at 415 to 680 nm.
///
/// They are [not your chip's own](crate::sensor::chip#nominal-responsivities). See the module's
/// [example](self#example).
pub static NOMINAL: FineObserver<8> = gaussian_responsivities([
    (415.0, 26.0),
    (445.0, 30.0),
    (480.0, 36.0),
    (515.0, 39.0),
    (555.0, 39.0),
    (590.0, 40.0),
    (630.0, 50.0),
    (680.0, 52.0),
]);

/// All facts of this module as a [`Chip`], for programs that let their users choose one.
pub static CHIP: Chip = Chip {
    name: "AS7341",
    summary: "eight bands from 415 to 680 nm",
    channels: &CHANNELS,
    settings: &[Setting::gain(&GAINS), Setting::register("atime", 255), Setting::register("astep", 65_534)],
    ladder: &STEPS,
    largest_count: 65_535,
    whole_counts: true,
    to_xyz: None,
    to_lux: None,
    exposure: |settings| match *settings {
        [gain, atime, astep] => Some(exposure(gain, atime as u8, astep as u16)),
        _ => None,
    },
    nominal: Some(Nominal::Visible(NOMINAL.weights())),
};
