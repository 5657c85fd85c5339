//! AS7262 of ams OSRAM: six bands of the visible, calibrated by the chip itself.

use crate::observer::FineObserver;
use crate::sensor::chip::{Chip, Nominal, Setting, of_width};
use crate::sensor::{Exposure, gaussian_responsivities};

/// The exposure of these settings: the gain (one of [`GAINS`]) and the integration time in `cycles` of 2.8
/// ms, 1 to 255 (0 counts as 1): the rule of the AS7261, AS7263 and AS7265x too.
///
/// ```
/// # use nanospectra::sensor::chip::as7262;
/// assert!((as7262::exposure(16.0, 18).time_ms() - 50.4).abs() < 1e-4);
/// ```
#[must_use]
pub const fn exposure(gain: f32, cycles: u8) -> Exposure {
    Exposure::new(gain, if cycles == 0 { 2.8 } else { cycles as f32 * 2.8 }, 65_535)
}

/// The gains, 0 to 3 of the control register.
pub static GAINS: [f32; 4] = [1.0, 3.7, 16.0, 64.0];

/// Violet, blue, green, yellow, orange and red, as the registers have them.
pub static CHANNELS: [&str; 6] = ["v", "b", "g", "y", "o", "r"];

ladder! {
    /// Every gain at 50 ms, which averages mains of 50 and of 60 Hz, 3 and 11 ms below that for glaring
    /// light, 100 and 200 ms above it.
    [(f32, u8); 8]:
    (1.0, 1), (1.0, 4), (1.0, 18), (3.7, 18), (16.0, 18), (64.0, 18), (64.0, 36), (64.0, 72),
}

/// Six bands of 40 nm from 450 to 650 nm, as Gaussians;
/// [not your chip's own](crate::sensor::chip#nominal-responsivities).
pub static NOMINAL: FineObserver<6> =
    gaussian_responsivities(of_width(40.0, [450.0, 500.0, 550.0, 570.0, 600.0, 650.0]));

/// All facts of this module as data.
pub static CHIP: Chip = Chip {
    name: "AS7262",
    summary: "six bands at 450, 500, 550, 570, 600 and 650 nm",
    channels: &CHANNELS,
    settings: &[Setting::gain(&GAINS), Setting::register("cycles", 255)],
    ladder: &STEPS,
    largest_count: 65_535,
    whole_counts: false,
    to_xyz: None,
    to_lux: None,
    exposure: |settings| match *settings {
        [gain, cycles] => Some(exposure(gain, cycles as u8)),
        _ => None,
    },
    nominal: Some(Nominal::Visible(NOMINAL.weights())),
};
