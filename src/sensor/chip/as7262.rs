//! Describes the AS7262 of ams OSRAM, which has six bands in the visible and calibrates itself.
//!
//! # Example
//!
//! The chip reports calibrated values as `f32`. Gain and time are divided out as they are for counts.
//!
//! ```
//! use nanospectra::sensor::chip::as7262;
//!
//! let exposure = as7262::exposure(16.0, 18); // gain 16, 18 cycles of 2.8 ms
//! let basic = exposure.basic_counts(&[806.4_f32, 403.2, 0.0, 0.0, 0.0, 0.0])?;
//! assert!((basic.values()[0] - 1.0).abs() < 1e-5); // 806.4 / (16 * 50.4)
//! assert_eq!(as7262::CHANNELS[1], "b"); // blue peaks at 500 nm and is half as sensitive at 520 nm
//! assert!((as7262::NOMINAL.weights()[1][520 - 360] - 0.5).abs() < 1e-6);
//! let (gain, cycles) = as7262::LADDER_SETTINGS[4];
//! assert_eq!(as7262::LADDER[4], as7262::exposure(gain, cycles));
//! # Ok::<(), nanospectra::sensor::ReadingError>(())
//! ```

use crate::observer::FineObserver;
use crate::sensor::chip::{Chip, Nominal, Setting, of_width};
use crate::sensor::{Exposure, gaussian_responsivities};

/// Returns the exposure that belongs to a gain (one of [`GAINS`]) and an integration time.
///
/// The time is given in `cycles` of 2.8 ms, 1 to 255; 0 counts as 1. The same holds for the AS7261, the
/// AS7263 and the [AS7265x](crate::sensor::chip::as7265x).
///
/// ```
/// # use nanospectra::sensor::chip::as7262;
/// assert!((as7262::exposure(16.0, 18).time_ms() - 50.4).abs() < 1e-4);
/// ```
#[must_use]
pub const fn exposure(gain: f32, cycles: u8) -> Exposure {
    Exposure::new(gain, if cycles == 0 { 2.8 } else { cycles as f32 * 2.8 }, 65_535)
}

/// The gains that can be set, as factors, in the order of the codes 0 to 3 of the control register.
pub static GAINS: [f32; 4] = [1.0, 3.7, 16.0, 64.0];

/// The names of the channels violet, blue, green, yellow, orange and red, which stand in the order of the
/// registers.
///
/// See the module's [example](self#example).
pub static CHANNELS: [&str; 6] = ["v", "b", "g", "y", "o", "r"];

ladder! {
    /// Exposures from the least to the most sensitive, which take every gain at 50 ms.
    ///
    /// A time of 50 ms averages mains of 50 and of 60 Hz. For glaring light there are 3 and 11 ms below that,
    /// for dim light 100 and 200 ms above it. See the module's [example](self#example).
    [(f32, u8); 8]:
    (1.0, 1), (1.0, 4), (1.0, 18), (3.7, 18), (16.0, 18), (64.0, 18), (64.0, 36), (64.0, 72),
}

/// The nominal responsivities, which are Gaussians 40 nm wide that peak at 450 to 650 nm.
///
/// They are [not your chip's own](crate::sensor::chip#nominal-responsivities). See the module's
/// [example](self#example).
pub static NOMINAL: FineObserver<6> =
    gaussian_responsivities(of_width(40.0, [450.0, 500.0, 550.0, 570.0, 600.0, 650.0]));

/// All facts of this module as a [`Chip`], for programs that let their users choose one.
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
