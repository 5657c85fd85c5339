//! What the crate knows of each chip: one chip, one file.
//!
//! All of them use the same names, so that whoever knows one chip knows the others:
//!
//! | name | what it is |
//! |---|---|
//! | `exposure(..)` | gain and registers to an [`Exposure`]: time, full scale, rule of saturation |
//! | `GAINS` | the gains that can be set, as factors |
//! | `CHANNELS` | the channels, in the order that everything else here has them |
//! | `LADDER`, `LADDER_SETTINGS` | exposures for [`AutoExposure`](crate::sensor::AutoExposure), and what to set for each |
//! | `NOMINAL` | an [`Observer`] with the responsivities of the data sheet |
//! | `TO_XYZ`, `TO_LUX` | published matrices |
//! | `CHIP` | all of this as a [`Chip`], for programs that let their users choose |
//!
//! A name is missing where the chip has no such thing, or its maker publishes nothing to make it from. What a
//! program does not name is not in its image. Beside a driver crate of the same name, import `chip` and write
//! `chip::as7341`.
//!
//! ```
//! use nanospectra::sensor::AutoExposure;
//! use nanospectra::sensor::chip::as7341;
//!
//! let auto = AutoExposure::new(&as7341::LADDER)?;
//! let (gain, atime, astep) = as7341::LADDER_SETTINGS[auto.middle()]; // for the registers of the chip
//! assert_eq!(auto.exposure(auto.middle()), as7341::exposure(gain, atime, astep));
//! # Ok::<(), nanospectra::sensor::LadderError>(())
//! ```
//!
//! # Nominal responsivities
//!
//! They are Gaussians with the peaks and widths of data sheets, *not* the chip on your bus, and each is 1 at
//! its peak. Real peaks lie 5 to 10 nm beside the nominal ones (users have measured 410, 440, 470, 510, 550,
//! 583, 620 and 670 nm for the AS7341), real curves are no Gaussians, and every channel leaks a little
//! infrared. They serve for simulation, for tests and for a first look; a measured table
//! ([`responsivities`](crate::sensor::responsivities)) or measured patches ([`Fit`](crate::sensor::Fit)) make
//! an instrument.

use crate::grid::{Grid, Nodes};
use crate::math::const_for;
use crate::observer::{Curve, Observer};
use crate::sensor::{Calibration, Exposure};
use crate::spectrum::Power;

/// `LADDER`, `LADDER_SETTINGS` and the same numbers for [`Chip::ladder`], from one list of settings.
macro_rules! ladder {
    ($(#[$doc:meta])* [$settings:ty; $length:literal]: $(($($setting:literal),+)),+ $(,)?) => {
        $(#[$doc])*
        pub static LADDER: [Exposure; $length] = [$(exposure($($setting),+)),+];

        /// What [`exposure`] takes for each exposure of [`LADDER`].
        pub static LADDER_SETTINGS: [$settings; $length] = [$(($($setting),+)),+];

        pub(in crate::sensor::chip) static STEPS: [&[f32]; $length] = [$(&[$($setting as f32),+]),+];
    };
}

pub mod as7262;
pub mod as7265x;
pub mod as7341;
pub mod as7343;
pub mod opt4048;
pub mod tcs3472;

/// All chips of this module. (A program that uses this list holds the 1 nm tables of all of them, 100 KB.)
pub static ALL: [&Chip; 6] =
    [&as7341::CHIP, &as7343::CHIP, &as7262::CHIP, &as7265x::CHIP, &tcs3472::CHIP, &opt4048::CHIP];

/// The chip of this name, in capitals or small letters.
///
/// ```
/// # use nanospectra::sensor::chip;
/// let chip = chip::named("as7341").expect("a known chip");
/// let exposure = chip.exposure(&[16.0, 29.0, 599.0]).expect("settings that it has");
/// assert_eq!((chip.name, exposure.full_scale()), ("AS7341", 18_000));
/// assert_eq!(chip.exposure(&[17.0, 29.0, 599.0]), None); // there is no gain of 17
/// ```
#[must_use]
pub fn named(name: &str) -> Option<&'static Chip> {
    ALL.into_iter().find(|chip| chip.name.eq_ignore_ascii_case(name))
}

/// A chip as data, for programs that let their users choose one: the same facts as in its module.
#[derive(Debug)]
pub struct Chip {
    /// Its name, as the maker writes it.
    pub name: &'static str,
    /// What its channels are, in a few words.
    pub summary: &'static str,
    /// The names of its channels in lower case, in the order of `NOMINAL` and `TO_XYZ`.
    pub channels: &'static [&'static str],
    /// What [`exposure`](Self::exposure) takes: the gain first, then registers; nothing if counts do not
    /// depend on them.
    pub settings: &'static [Setting],
    /// The settings of `LADDER`, from the least to the most sensitive; none if there is nothing to set.
    pub ladder: &'static [&'static [f32]],
    /// The most that a channel can report.
    pub largest_count: u32,
    /// Whether counts are whole numbers. Those of chips that calibrate themselves are not.
    pub whole_counts: bool,
    /// The rows of `TO_XYZ`, if there is one.
    pub to_xyz: Option<[&'static [f32]; 3]>,
    /// The row of `TO_LUX`, if lux is not Y.
    pub to_lux: Option<&'static [f32]>,
    exposure: fn(&[f32]) -> Option<Exposure>,
    nominal: Option<Nominal>,
}

impl Chip {
    /// The exposure that these [`settings`](Self::settings) make; `None` if their number is another or the
    /// chip does not have one of them.
    #[must_use]
    pub fn exposure(&self, settings: &[f32]) -> Option<Exposure> {
        let allowed = self.settings.iter().zip(settings).all(|(setting, value)| setting.allows(*value));
        (self.exposure)(settings).filter(|_| allowed)
    }

    /// One channel of `NOMINAL` on any grid; `None` if there is no such channel, or nothing is known of it.
    #[must_use]
    pub fn nominal<const N: usize, G: Grid>(&self, channel: usize) -> Option<Observer<1, N, Power, G>> {
        match self.nominal? {
            Nominal::Visible(rows) => Some(
                Observer::<1, 471, Power, Nodes<360, 830>>::from_weights([*rows.get(channel)?])
                    .fold(Curve::Step),
            ),
            Nominal::Wide(rows) => Some(
                Observer::<1, 701, Power, Nodes<300, 1000>>::from_weights([*rows.get(channel)?])
                    .fold(Curve::Step),
            ),
        }
    }

    /// The wavelength at which one channel of `NOMINAL` peaks, in whole nm; `None` as for
    /// [`nominal`](Self::nominal).
    #[must_use]
    pub fn peak_nm(&self, channel: usize) -> Option<f32> {
        let (first_nm, row) = match self.nominal? {
            Nominal::Visible(rows) => (360.0, rows.get(channel)?.as_slice()),
            Nominal::Wide(rows) => (300.0, rows.get(channel)?.as_slice()),
        };
        let (place, _) = row.iter().enumerate().max_by(|(_, a), (_, b)| a.total_cmp(b))?;
        Some(first_nm + place as f32)
    }
}

/// Something that is set on a chip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// "gain", or the name of the register in lower case.
    pub name: &'static str,
    /// What it may be.
    pub values: SettingValues,
}

/// What a setting may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SettingValues {
    /// One of these factors.
    OneOf(&'static [f32]),
    /// A whole number from 0 to this one.
    UpTo(u32),
}

impl Setting {
    const fn gain(gains: &'static [f32]) -> Self {
        Setting { name: "gain", values: SettingValues::OneOf(gains) }
    }

    const fn register(name: &'static str, most: u32) -> Self {
        Setting { name, values: SettingValues::UpTo(most) }
    }

    /// Whether it may be set to `value`.
    #[must_use]
    pub fn allows(&self, value: f32) -> bool {
        match self.values {
            SettingValues::OneOf(values) => values.contains(&value),
            SettingValues::UpTo(most) => value as u32 as f32 == value && value as u32 <= most,
        }
    }
}

/// The weights of `NOMINAL`, without the number of channels in the type.
#[derive(Clone, Copy, Debug)]
enum Nominal {
    /// From 360 to 830 nm.
    Visible(&'static [[f32; 471]]),
    /// From 300 to 1000 nm.
    Wide(&'static [[f32; 701]]),
}

/// Bands of one width at these peaks, in nm.
const fn of_width<const C: usize>(width: f64, peaks: [f64; C]) -> [(f64, f64); C] {
    let mut bands = [(0.0, width); C];
    const_for!(0..C, |c| bands[c].0 = peaks[c]);
    bands
}

/// The rows of a matrix, without the number of channels in the type.
const fn rows<const C: usize>(matrix: &'static Calibration<C>) -> [&'static [f32]; 3] {
    let [x, y, z] = matrix.rows();
    [x, y, z]
}
