//! Describes the AS7265x of ams OSRAM, which has 18 bands from the ultraviolet to the near infrared on three
//! dies.
//!
//! The chip calibrates itself. Gains and integration times are those of the
//! [AS7262](crate::sensor::chip::as7262).
//!
//! # Example
//!
//! ```
//! use nanospectra::sensor::chip::as7265x;
//!
//! let exposure = as7265x::exposure(16.0, 18); // gain 16, 18 cycles of 2.8 ms
//! assert!((exposure.time_ms() - 50.4).abs() < 1e-4);
//! // The last band peaks at 940 nm and is half as sensitive at 950 nm.
//! assert_eq!(as7265x::CHANNELS[17], "940");
//! assert!((as7265x::NOMINAL.weights()[17][950 - 300] - 0.5).abs() < 1e-6);
//! ```

use crate::grid::Nodes;
use crate::observer::Observer;
pub use crate::sensor::chip::as7262::{GAINS, LADDER, LADDER_SETTINGS, exposure};
use crate::sensor::chip::{Chip, Nominal, as7262, of_width};
use crate::sensor::gaussian_responsivities;
use crate::spectrum::Power;

/// The channels, named after their peaks in nm and sorted by wavelength, which is not the order in which the
/// three dies are read.
///
/// See the module's [example](self#example).
pub static CHANNELS: [&str; 18] = [
    "410", "435", "460", "485", "510", "535", "560", "585", "610", "645", "680", "705", "730", "760", "810",
    "860", "900", "940",
];

/// The nominal responsivities of the [`CHANNELS`], which are Gaussians 20 nm wide that peak at 410 to 940 nm.
///
/// They are [not your chip's own](crate::sensor::chip#nominal-responsivities). See the module's
/// [example](self#example).
pub static NOMINAL: Observer<18, 701, Power, Nodes<300, 1000>> = gaussian_responsivities(of_width(
    20.0,
    [
        410.0, 435.0, 460.0, 485.0, 510.0, 535.0, 560.0, 585.0, 610.0, 645.0, 680.0, 705.0, 730.0, 760.0,
        810.0, 860.0, 900.0, 940.0,
    ],
));

/// All facts of this module as a [`Chip`], for programs that let their users choose one; settings are those
/// of the AS7262.
pub static CHIP: Chip = Chip {
    name: "AS7265x",
    summary: "18 bands of 20 nm, called by their peaks",
    channels: &CHANNELS,
    nominal: Some(Nominal::Wide(NOMINAL.weights())),
    ..as7262::CHIP
};
