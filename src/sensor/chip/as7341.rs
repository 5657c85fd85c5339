//! AS7341 of ams OSRAM: eight bands of the visible, clear and infrared.
//!
//! # Reference
//! Data sheet DS000504.

use crate::observer::FineObserver;
use crate::sensor::chip::{Chip, Nominal, Setting};
use crate::sensor::{Exposure, gaussian_responsivities};

/// The exposure of these settings: the gain (one of [`GAINS`]) and the registers ATIME and ASTEP (at most
/// 65,534). The time is (ATIME + 1) (ASTEP + 1) 2.78 us, and the same product is the full scale if it is below
/// 65,535.
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

/// The gains of register AGAIN, 0 to 10.
pub static GAINS: [f32; 11] = [0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0, 256.0, 512.0];

/// F1 to F8, by wavelength. Drivers give clear and near infrared behind them, which [`NOMINAL`] does not
/// have.
pub static CHANNELS: [&str; 8] = ["f1", "f2", "f3", "f4", "f5", "f6", "f7", "f8"];

ladder! {
    /// Over four and a half decades of sensitivity: every gain at 50 ms, which averages mains of 50 and of 60
    /// Hz, 5 ms below that for glaring light, 100 and 200 ms above it.
    [(f32, u8, u16); 15]:
    (0.5, 2, 599), (0.5, 8, 599), (0.5, 29, 599), (1.0, 29, 599), (2.0, 29, 599), (4.0, 29, 599),
    (8.0, 29, 599), (16.0, 29, 599), (32.0, 29, 599), (64.0, 29, 599), (128.0, 29, 599), (256.0, 29, 599),
    (512.0, 29, 599), (512.0, 59, 599), (512.0, 119, 599),
}

/// F1 to F8, 415 to 680 nm, as Gaussians; [not your chip's own](crate::sensor::chip#nominal-responsivities).
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

/// All facts of this module as data.
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
