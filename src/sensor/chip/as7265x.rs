//! AS7265x of ams OSRAM: 18 bands from the ultraviolet to the near infrared on three dies, calibrated by the
//! chip.

use crate::grid::Nodes;
use crate::observer::Observer;
pub use crate::sensor::chip::as7262::{GAINS, LADDER, LADDER_SETTINGS, exposure};
use crate::sensor::chip::{Chip, Nominal, as7262, of_width};
use crate::sensor::gaussian_responsivities;
use crate::spectrum::Power;

/// The peaks in nm: by wavelength, which is not the order in which the three dies are read.
pub static CHANNELS: [&str; 18] = [
    "410", "435", "460", "485", "510", "535", "560", "585", "610", "645", "680", "705", "730", "760", "810",
    "860", "900", "940",
];

/// 18 bands of 20 nm from 410 to 940 nm, in the order of [`CHANNELS`], as Gaussians;
/// [not your chip's own](crate::sensor::chip#nominal-responsivities).
pub static NOMINAL: Observer<18, 701, Power, Nodes<300, 1000>> = gaussian_responsivities(of_width(
    20.0,
    [
        410.0, 435.0, 460.0, 485.0, 510.0, 535.0, 560.0, 585.0, 610.0, 645.0, 680.0, 705.0, 730.0, 760.0,
        810.0, 860.0, 900.0, 940.0,
    ],
));

/// All facts of this module as data; what is set is as on the AS7262.
pub static CHIP: Chip = Chip {
    name: "AS7265x",
    summary: "18 bands of 20 nm, called by their peaks",
    channels: &CHANNELS,
    nominal: Some(Nominal::Wide(NOMINAL.weights())),
    ..as7262::CHIP
};
