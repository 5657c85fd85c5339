//! Describes color sensors by what their data sheets say, in one module for each chip.
//!
//! # Example
//!
//! An exposure from the ladder of the AS7341, and what to write into the registers of the chip for it.
//!
//! ```
//! use nanospectra::sensor::AutoExposure;
//! use nanospectra::sensor::chip::as7341;
//!
//! let auto = AutoExposure::new(&as7341::LADDER)?;
//! let (gain, atime, astep) = as7341::LADDER_SETTINGS[auto.middle()];
//! assert_eq!((gain, atime, astep), (16.0, 29, 599));
//! assert_eq!(auto.exposure(auto.middle()), as7341::exposure(gain, atime, astep));
//! # Ok::<(), nanospectra::sensor::LadderError>(())
//! ```
//!
//! # What each module has
//!
//! All modules use the same names, so that whoever knows one chip knows the others:
//!
//! | name | what it is |
//! |---|---|
//! | `exposure(..)` | turns gain and registers into an [`Exposure`] with its time and its full scale |
//! | `GAINS` | the gains that can be set, as factors |
//! | `CHANNELS` | the channels, in the order that everything else in the module has them |
//! | `LADDER` | exposures for [`AutoExposure`](crate::sensor::AutoExposure) |
//! | `LADDER_SETTINGS` | what to set on the chip for each exposure of `LADDER` |
//! | `NOMINAL` | an [`Observer`] with the responsivities of the data sheet |
//! | `TO_XYZ`, `TO_LUX` | published matrices |
//! | `CHIP` | all of this as a [`Chip`], for programs that let their users choose |
//!
//! A name is missing where the chip has no such thing, or where its maker publishes nothing to make it from.
//! What a program does not name is not in its image. If a driver crate has the name of a chip's module,
//! import `chip` and write `chip::as7341`.
//!
//!
//! # Nominal responsivities
//!
//! `NOMINAL` holds Gaussians with the peaks and widths of the data sheet, each of them 1 at its peak. They
//! are *not* the chip on your bus. Real peaks lie 5 to 10 nm beside the nominal ones (users have measured
//! 410, 440, 470, 510, 550, 583, 620 and 670 nm for the AS7341), real curves are no Gaussians, and every
//! channel leaks a little infrared.
//!
//! Use them for simulation, for tests and for a first look. An instrument is made from a measured table
//! ([`responsivities`](crate::sensor::responsivities)) or from measured patches
//! ([`Fit`](crate::sensor::Fit)).

use crate::grid::{Grid, Nodes};
use crate::math::const_for;
use crate::observer::{Curve, Observer};
use crate::sensor::{Calibration, Exposure};
use crate::spectrum::Power;

/// Makes `LADDER`, `LADDER_SETTINGS` and the same numbers for [`Chip::ladder`] from one list of settings.
macro_rules! ladder {
    ($(#[$doc:meta])* [$settings:ty; $length:literal]: $(($($setting:literal),+)),+ $(,)?) => {
        $(#[$doc])*
        pub static LADDER: [Exposure; $length] = [$(exposure($($setting),+)),+];

        /// What to set for each exposure of [`LADDER`], as [`exposure`] takes it.
        ///
        /// See the module's [example](self#example).
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

/// All chips of this module as data, in a list that a program can show or search.
///
/// A program that uses this list holds the 1 nm tables of all chips, 100 KB.
pub static ALL: [&Chip; 6] =
    [&as7341::CHIP, &as7343::CHIP, &as7262::CHIP, &as7265x::CHIP, &tcs3472::CHIP, &opt4048::CHIP];

/// Finds the chip of this name, in capitals or small letters.
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

/// A chip as data, which holds the same facts as the module of the chip.
///
/// It is for programs that let their users choose a chip: [`named`] finds one, and
/// [`exposure`](Self::exposure) turns its settings into an [`Exposure`].
///
/// # Example
///
/// ```
/// use nanospectra::sensor::chip;
///
/// let chip = chip::named("as7341").expect("a known chip");
/// assert_eq!((chip.name, chip.channels.len(), chip.largest_count), ("AS7341", 8, 65_535));
/// let exposure = chip.exposure(&[16.0, 29.0, 599.0]).expect("settings that it has");
/// assert_eq!(exposure.full_scale(), 18_000);
/// assert_eq!(chip.peak_nm(7), Some(680.0)); // F8
/// assert!(chip.settings[0].name == "gain" && chip.settings[0].allows(16.0));
/// ```
#[derive(Debug)]
pub struct Chip {
    /// The name of the chip, as the maker writes it. See the [example](#example).
    pub name: &'static str,
    /// A few words that say what the channels are.
    pub summary: &'static str,
    /// The names of the channels in lower case, which stand in the order of `NOMINAL` and `TO_XYZ`.
    pub channels: &'static [&'static str],
    /// What [`exposure`](Self::exposure) takes: the gain first, then registers. See the [example](#example).
    ///
    /// It is empty if counts do not depend on settings.
    pub settings: &'static [Setting],
    /// The settings of `LADDER`, which go from the least to the most sensitive; empty if there is nothing to
    /// set.
    pub ladder: &'static [&'static [f32]],
    /// The largest count that a channel can report. See the [example](#example).
    pub largest_count: u32,
    /// Says whether the chip reports whole numbers. A chip that corrects its counts by its own calibration
    /// reports fractions.
    pub whole_counts: bool,
    /// The rows of `TO_XYZ`, if the maker of the chip publishes such a matrix.
    pub to_xyz: Option<[&'static [f32]; 3]>,
    /// The row of `TO_LUX`, if the chip has one because lux is not Y.
    pub to_lux: Option<&'static [f32]>,
    exposure: fn(&[f32]) -> Option<Exposure>,
    nominal: Option<Nominal>,
}

impl Chip {
    /// Returns the exposure that these [`settings`](Self::settings) make. See the [example](#example).
    ///
    /// `None` if their number is wrong or if the chip does not have one of them.
    #[must_use]
    pub fn exposure(&self, settings: &[f32]) -> Option<Exposure> {
        let allowed = self.settings.iter().zip(settings).all(|(setting, value)| setting.allows(*value));
        (self.exposure)(settings).filter(|_| allowed)
    }

    /// Returns one channel of `NOMINAL` on any grid.
    ///
    /// `None` if there is no such channel, or if nothing is known of its responsivity. It computes in f64, as
    /// [`fold`](Observer::fold) does.
    ///
    /// ```
    /// # use nanospectra::sensor::chip::as7341;
    /// # use nanospectra::{Nodes, Observer, Power};
    /// let f3: Option<Observer<1, 31, Power, Nodes<400, 700>>> = as7341::CHIP.nominal(2);
    /// let [weights] = f3.map_or([[0.0; 31]], |f3| *f3.weights());
    /// assert!(weights[8] > weights[7] && weights[8] > weights[9]); // F3 peaks at 400 + 8 * 10 nm
    /// ```
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

    /// Returns the wavelength in whole nm at which one channel of `NOMINAL` peaks. See the
    /// [example](#example).
    ///
    /// `None` as for [`nominal`](Self::nominal).
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

/// Something that can be set on a chip, which is its gain or a register.
///
/// # Example
///
/// ```
/// use nanospectra::sensor::chip::{SettingValues, as7341};
///
/// let [gain, atime, _] = as7341::CHIP.settings else { return };
/// assert!(gain.name == "gain" && gain.allows(16.0) && !gain.allows(17.0));
/// assert_eq!((atime.name, atime.values), ("atime", SettingValues::UpTo(255)));
/// assert!(atime.allows(29.0) && !atime.allows(0.5) && !atime.allows(256.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// What the setting is called: "gain", or the name of the register in lower case.
    pub name: &'static str,
    /// Which values can be set. See the [example](#example).
    pub values: SettingValues,
}

/// Which values a setting can take.
///
/// See the [example](Setting#example) of [`Setting`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SettingValues {
    /// The setting takes one of these factors.
    OneOf(&'static [f32]),
    /// The setting takes a whole number from 0 to this one.
    UpTo(u32),
}

impl Setting {
    const fn gain(gains: &'static [f32]) -> Self {
        Setting { name: "gain", values: SettingValues::OneOf(gains) }
    }

    const fn register(name: &'static str, most: u32) -> Self {
        Setting { name, values: SettingValues::UpTo(most) }
    }

    /// Returns whether this can be set to `value`. See the [example](#example).
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
