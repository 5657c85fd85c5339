//! Defines the value of `--sensor`, which is a chip of the library or one that the log describes.

use crate::output::number::shortest;
use clap::ValueEnum;
use clap::builder::PossibleValue;
use nanospectra::sensor::Exposure;
use nanospectra::sensor::chip::{self, Setting, SettingValues};
use nanospectra::{Nodes, Observer, Power};
use std::sync::LazyLock;

/// The bins of a reconstructed spectrum, which are 10 nm wide and cover the range of every chip.
pub type Grid = Nodes<300, 1000>;
pub const BINS: usize = 71;

/// The value of `--sensor`: a chip that the library knows, or `None` for a custom sensor.
#[derive(Clone, Copy, Debug)]
pub struct Chip(pub Option<&'static chip::Chip>);

/// The name of each chip on the command line.
static NAMED: LazyLock<Vec<(Chip, &'static str)>> = LazyLock::new(|| {
    let known = chip::ALL.map(|chip| (Chip(Some(chip)), &*chip.name.to_lowercase().leak()));
    known.into_iter().chain([(Chip(None), "custom")]).collect()
});
static CHIPS: LazyLock<Vec<Chip>> = LazyLock::new(|| NAMED.iter().map(|(chip, _)| *chip).collect());

impl ValueEnum for Chip {
    fn value_variants<'a>() -> &'a [Self] {
        &CHIPS
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let called = NAMED.iter().find(|(chip, _)| chip.title() == self.title())?.1;
        Some(PossibleValue::new(called))
    }
}

/// The columns that hold the settings of a custom sensor.
const CUSTOM: [&str; 3] = ["gain", "time_ms", "full_scale"];

impl Chip {
    pub fn title(self) -> &'static str {
        self.0.map_or("custom sensor", |chip| chip.name)
    }

    /// Returns the columns of the channels, which are none for a custom sensor: it has the columns that are
    /// left.
    pub fn channels(self) -> &'static [&'static str] {
        self.0.map_or(&[], |chip| chip.channels)
    }

    /// Returns the columns of the exposure's settings.
    pub fn settings(self) -> Vec<&'static str> {
        self.0.map_or(CUSTOM.into(), |chip| chip.settings.iter().map(|setting| setting.name).collect())
    }

    /// Returns whether the chip's counts are whole numbers.
    pub fn counts_are_whole(self) -> bool {
        self.0.is_some_and(|chip| chip.whole_counts)
    }

    /// Returns the exposure of values of [`settings`](Self::settings), or which of them is wrong and why.
    pub fn exposure(self, values: &[f64]) -> Result<Exposure, (usize, String)> {
        let Some(chip) = self.0 else { return custom(values) };
        let values: Vec<f32> = values.iter().map(|value| *value as f32).collect();
        for (place, (setting, value)) in chip.settings.iter().zip(&values).enumerate() {
            if !setting.allows(*value) {
                return Err((place, wanted(setting)));
            }
        }
        chip.exposure(&values).ok_or((0, "which is not a setting of this chip; check the data sheet".into()))
    }

    /// Returns the settings from which the next exposure is chosen.
    pub fn choices(self) -> Vec<Vec<f64>> {
        let choices = self.0.map_or(&[][..], |chip| chip.ladder);
        choices.iter().map(|settings| settings.iter().map(|value| f64::from(*value)).collect()).collect()
    }

    /// Returns the largest count that a channel can report.
    pub fn largest_count(self) -> f64 {
        self.0.map_or(f64::MAX, |chip| chip.largest_count.into())
    }

    /// Formats the chip's settings with their names.
    pub fn describe(self, values: &[f64]) -> String {
        let named = self.settings().into_iter().zip(values);
        named.map(|(name, value)| format!("{name} {}", shortest(*value as f32))).collect::<Vec<_>>().join(" ")
    }

    /// Returns the weights of the channels by the data sheet, if that is enough to compute them.
    pub fn nominal(self) -> Option<Vec<[f32; BINS]>> {
        let channel = |k: usize| -> Option<[f32; BINS]> {
            let alone: Observer<1, BINS, Power, Grid> = self.0?.nominal(k)?;
            let [weights] = *alone.weights();
            Some(weights)
        };
        (0..self.0?.channels.len()).map(channel).collect()
    }
}

/// Returns what a setting of a chip may be, in words.
fn wanted(setting: &Setting) -> String {
    match setting.values {
        SettingValues::OneOf(gains) => {
            let gains = gains.iter().map(f32::to_string).collect::<Vec<_>>().join(", ");
            format!("which is not one of {gains}; give the factor, not the register's code")
        }
        SettingValues::UpTo(most) => not_whole(most),
    }
}

fn not_whole(most: u32) -> String {
    format!("which is not a whole number of 0..{most}; give the value of the register")
}

fn custom(values: &[f64]) -> Result<Exposure, (usize, String)> {
    let above_zero = |place: usize| match values[place] as f32 {
        value if value > 0.0 && value.is_finite() => Ok(value),
        _ => Err((place, "which is not above zero; correct it".to_owned())),
    };
    let (gain, time_ms) = (above_zero(0)?, above_zero(1)?);
    if !(1e-12..1e12).contains(&(f64::from(gain) * f64::from(time_ms))) {
        let what = format!("which with time_ms {time_ms} is out of range; correct one of them");
        return Err((0, what));
    }
    let (full_scale, most) = (values[2], i32::MAX as u32);
    if full_scale.fract() != 0.0 || !(0.0..=f64::from(most)).contains(&full_scale) {
        return Err((2, not_whole(most)));
    }
    if full_scale == 0.0 {
        return Err((2, "which cannot be a full scale; give the first count that cannot be trusted".into()));
    }
    Ok(Exposure::new(gain, time_ms, full_scale as u32))
}
