//! AS7343 and TCS3448 of ams OSRAM: eleven bands of the visible, clear and infrared.

use crate::observer::FineObserver;
pub use crate::sensor::chip::as7341::exposure;
use crate::sensor::chip::{Chip, Nominal, Setting, as7341};
use crate::sensor::{Exposure, gaussian_responsivities};

/// The gains of register AGAIN, 0 to 12.
pub static GAINS: [f32; 13] =
    [0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0, 256.0, 512.0, 1024.0, 2048.0];

/// F1, F2, FZ, F3, F4, F5, FY, FXL, F6, F7, F8: by wavelength, which is not the order of the registers.
pub static CHANNELS: [&str; 11] = ["f1", "f2", "fz", "f3", "f4", "f5", "fy", "fxl", "f6", "f7", "f8"];

ladder! {
    /// Every gain at 50 ms, which averages mains of 50 and of 60 Hz, 5 and 15 ms below that for glaring
    /// light, 100 and 200 ms above it.
    [(f32, u8, u16); 17]:
    (0.5, 2, 599), (0.5, 8, 599), (0.5, 29, 599), (1.0, 29, 599), (2.0, 29, 599), (4.0, 29, 599),
    (8.0, 29, 599), (16.0, 29, 599), (32.0, 29, 599), (64.0, 29, 599), (128.0, 29, 599), (256.0, 29, 599),
    (512.0, 29, 599), (1024.0, 29, 599), (2048.0, 29, 599), (2048.0, 59, 599), (2048.0, 119, 599),
}

/// 405 to 745 nm, in the order of [`CHANNELS`], as Gaussians (widths as users of the TCS3448 tabulate them);
/// [not your chip's own](crate::sensor::chip#nominal-responsivities). Without the infrared and the clear
/// channel.
pub static NOMINAL: FineObserver<11> = gaussian_responsivities([
    (405.0, 28.0),
    (425.0, 29.0),
    (450.0, 67.0),
    (475.0, 38.0),
    (515.0, 48.0),
    (550.0, 44.0),
    (555.0, 123.0),
    (600.0, 93.0),
    (640.0, 58.0),
    (690.0, 63.0),
    (745.0, 77.0),
]);

/// All facts of this module as data; registers and counts are as on the AS7341.
pub static CHIP: Chip = Chip {
    name: "AS7343",
    summary: "eleven bands from 405 to 745 nm; the TCS3448 is alike",
    channels: &CHANNELS,
    settings: &[Setting::gain(&GAINS), Setting::register("atime", 255), Setting::register("astep", 65_534)],
    ladder: &STEPS,
    nominal: Some(Nominal::Visible(NOMINAL.weights())),
    ..as7341::CHIP
};
