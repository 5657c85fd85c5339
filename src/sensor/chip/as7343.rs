//! Describes the AS7343 and TCS3448 of ams OSRAM, which have eleven bands in the visible, a clear and an
//! infrared channel.
//!
//! Registers and counts are those of the [AS7341](crate::sensor::chip::as7341).
//!
//! # Example
//!
//! ```
//! use nanospectra::sensor::chip::as7343;
//!
//! let exposure = as7343::exposure(2048.0, 29, 599); // gain 2048, 50 ms
//! assert_eq!(exposure.full_scale(), 18_000);
//! // F3 peaks at 475 nm and is half as sensitive at 494 nm.
//! assert_eq!(as7343::CHANNELS[3], "f3");
//! assert!((as7343::NOMINAL.weights()[3][494 - 360] - 0.5).abs() < 1e-6);
//! let (gain, atime, astep) = as7343::LADDER_SETTINGS[14];
//! assert_eq!((gain, as7343::LADDER[14]), (2048.0, as7343::exposure(gain, atime, astep)));
//! ```

use crate::observer::FineObserver;
pub use crate::sensor::chip::as7341::exposure;
use crate::sensor::chip::{Chip, Nominal, Setting, as7341};
use crate::sensor::{Exposure, gaussian_responsivities};

/// The gains that can be set, as factors, in the order of the codes 0 to 12 of register AGAIN.
pub static GAINS: [f32; 13] =
    [0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0, 256.0, 512.0, 1024.0, 2048.0];

/// The names of the channels F1, F2, FZ, F3, F4, F5, FY, FXL, F6, F7 and F8, which are sorted by wavelength
/// and not in the order of the registers.
///
/// See the module's [example](self#example).
pub static CHANNELS: [&str; 11] = ["f1", "f2", "fz", "f3", "f4", "f5", "fy", "fxl", "f6", "f7", "f8"];

ladder! {
    /// Exposures from the least to the most sensitive, which take every gain at 50 ms.
    ///
    /// A time of 50 ms averages mains of 50 and of 60 Hz. For glaring light there are 5 and 15 ms below that,
    /// for dim light 100 and 200 ms above it. See the module's [example](self#example).
    [(f32, u8, u16); 17]:
    (0.5, 2, 599), (0.5, 8, 599), (0.5, 29, 599), (1.0, 29, 599), (2.0, 29, 599), (4.0, 29, 599),
    (8.0, 29, 599), (16.0, 29, 599), (32.0, 29, 599), (64.0, 29, 599), (128.0, 29, 599), (256.0, 29, 599),
    (512.0, 29, 599), (1024.0, 29, 599), (2048.0, 29, 599), (2048.0, 59, 599), (2048.0, 119, 599),
}

/// The nominal responsivities of the [`CHANNELS`], which are Gaussians that peak at 405 to 745 nm.
///
/// The widths are those that users of the TCS3448 tabulate. The infrared and the clear channel are not among
/// them. They are [not your chip's own](crate::sensor::chip#nominal-responsivities). See the module's
/// [example](self#example).
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

/// All facts of this module as a [`Chip`], for programs that let their users choose one; registers and counts
/// are those of the AS7341.
pub static CHIP: Chip = Chip {
    name: "AS7343",
    summary: "eleven bands from 405 to 745 nm; the TCS3448 is alike",
    channels: &CHANNELS,
    settings: &[Setting::gain(&GAINS), Setting::register("atime", 255), Setting::register("astep", 65_534)],
    ladder: &STEPS,
    nominal: Some(Nominal::Visible(NOMINAL.weights())),
    ..as7341::CHIP
};
