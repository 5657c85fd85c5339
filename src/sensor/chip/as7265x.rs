//! AS7265x of ams OSRAM: 18 bands from the ultraviolet to the near infrared on three dies, calibrated by the chip.

use crate::grid::Nodes;
use crate::observer::Observer;
use crate::sensor::chip::as7262::STEPS;
pub use crate::sensor::chip::as7262::{GAINS, LADDER, LADDER_SETTINGS, exposure};
use crate::sensor::chip::{Chip, Nominal, Setting};
use crate::sensor::gaussian_responsivities;
use crate::spectrum::Power;

/// The peaks in nm: by wavelength, which is not the order in which the three dies are read.
pub static CHANNELS: [&str; 18] = [
    "410", "435", "460", "485", "510", "535", "560", "585", "610", "645", "680", "705", "730", "760", "810",
    "860", "900", "940",
];

/// 18 bands of 20 nm from 410 to 940 nm, in the order of [`CHANNELS`], as Gaussians;
/// [not your chip's own](crate::sensor::chip#nominal-responsivities).
pub static NOMINAL: Observer<18, 701, Power, Nodes<300, 1000>> = gaussian_responsivities([
    (410.0, 20.0),
    (435.0, 20.0),
    (460.0, 20.0),
    (485.0, 20.0),
    (510.0, 20.0),
    (535.0, 20.0),
    (560.0, 20.0),
    (585.0, 20.0),
    (610.0, 20.0),
    (645.0, 20.0),
    (680.0, 20.0),
    (705.0, 20.0),
    (730.0, 20.0),
    (760.0, 20.0),
    (810.0, 20.0),
    (860.0, 20.0),
    (900.0, 20.0),
    (940.0, 20.0),
]);

/// The same as data.
pub static CHIP: Chip = Chip {
    name: "AS7265x",
    summary: "18 bands of 20 nm, called by their peaks",
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
    nominal: Some(Nominal::Wide(NOMINAL.weights())),
};
