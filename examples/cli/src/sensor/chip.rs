//! The chips: their channels, their settings, their exposures.

use clap::ValueEnum;
use nanospectra::sensor::{Exposure, nominal};
use nanospectra::{Curve, Nodes, Observer, Power};

/// The bins of a reconstructed spectrum: 10 nm, wide enough for every chip.
pub type Grid = Nodes<300, 1000>;
pub const BINS: usize = 71;

/// `--sensor`
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Chip {
    As7341,
    As7343,
    As7262,
    As7265x,
    Tcs3472,
    Opt4048,
    Custom,
}

impl Chip {
    pub fn title(self) -> &'static str {
        match self {
            Chip::As7341 => "AS7341",
            Chip::As7343 => "AS7343",
            Chip::As7262 => "AS7262",
            Chip::As7265x => "AS7265x",
            Chip::Tcs3472 => "TCS3472",
            Chip::Opt4048 => "OPT4048",
            Chip::Custom => "custom sensor",
        }
    }

    /// The columns of its channels; none for a custom one, which has those that are left.
    pub fn channels(self) -> &'static [&'static str] {
        match self {
            Chip::As7341 => &["f1", "f2", "f3", "f4", "f5", "f6", "f7", "f8"],
            Chip::As7343 => &["f1", "f2", "fz", "f3", "f4", "f5", "fy", "fxl", "f6", "f7", "f8"],
            Chip::As7262 => &["v", "b", "g", "y", "o", "r"],
            Chip::As7265x => &[
                "410", "435", "460", "485", "510", "535", "560", "585", "610", "645", "680", "705", "730",
                "760", "810", "860", "900", "940",
            ],
            Chip::Tcs3472 => &["red", "green", "blue", "clear"],
            Chip::Opt4048 => &["ch0", "ch1", "ch2"],
            Chip::Custom => &[],
        }
    }

    /// The columns of its exposure.
    pub fn settings(self) -> &'static [&'static str] {
        match self {
            Chip::As7341 | Chip::As7343 => &["gain", "atime", "astep"],
            Chip::As7262 | Chip::As7265x => &["gain", "cycles"],
            Chip::Tcs3472 => &["gain", "atime"],
            Chip::Opt4048 => &[],
            Chip::Custom => &["gain", "time_ms", "full_scale"],
        }
    }

    /// The gains it has; none listed where any may be.
    pub fn gains(self) -> &'static [f32] {
        const AS734X: [f32; 13] =
            [0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0, 256.0, 512.0, 1024.0, 2048.0];
        match self {
            Chip::As7341 => &AS734X[..11],
            Chip::As7343 => &AS734X,
            Chip::As7262 | Chip::As7265x => &[1.0, 3.7, 16.0, 64.0],
            Chip::Tcs3472 => &[1.0, 4.0, 16.0, 60.0],
            Chip::Opt4048 | Chip::Custom => &[],
        }
    }

    /// Whether counts are whole numbers.
    pub fn counts_are_whole(self) -> bool {
        match self {
            Chip::As7341 | Chip::As7343 | Chip::Tcs3472 | Chip::Opt4048 => true,
            Chip::As7262 | Chip::As7265x | Chip::Custom => false,
        }
    }

    /// From the values of [`settings`](Self::settings), or what is wrong and which of them.
    pub fn exposure(self, values: &[f64]) -> Result<Exposure, (usize, String)> {
        let whole = |place: usize, most: u32| {
            let value = values[place];
            if value.fract() == 0.0 && (0.0..=f64::from(most)).contains(&value) {
                Ok(value as u32)
            } else {
                Err((place, format!("not a whole number of 0..{most}; give the register as it is")))
            }
        };
        let gain = values.first().map_or(1.0, |gain| *gain as f32);
        if !self.gains().is_empty() && !self.gains().contains(&gain) {
            let gains: Vec<String> = self.gains().iter().map(f32::to_string).collect();
            let gains = gains.join(", ");
            return Err((0, format!("not one of {gains}; give the factor, not the register's code")));
        }
        Ok(match self {
            Chip::As7341 | Chip::As7343 => {
                Exposure::as7341(gain, whole(1, 255)? as u8, whole(2, 65_534)? as u16)
            }
            Chip::As7262 | Chip::As7265x => Exposure::as726x(gain, whole(1, 255)? as u8),
            Chip::Tcs3472 => Exposure::tcs3472(gain, whole(1, 255)? as u8),
            Chip::Opt4048 => Exposure::opt4048(),
            Chip::Custom => {
                let above_zero = |place: usize| match values[place] as f32 {
                    value if value > 0.0 && value.is_finite() => Ok(value),
                    _ => Err((place, "not above zero; correct it".to_owned())),
                };
                let (gain, time_ms) = (above_zero(0)?, above_zero(1)?);
                if !(1e-12..1e12).contains(&(f64::from(gain) * f64::from(time_ms))) {
                    let what = format!("which with time_ms {time_ms} is no exposure; correct one of them");
                    return Err((0, what));
                }
                let full_scale = whole(2, i32::MAX as u32)?;
                if full_scale == 0 {
                    return Err((2, "no full scale; give the first count that cannot be trusted".into()));
                }
                Exposure::new(gain, time_ms, full_scale)
            }
        })
    }

    /// Settings to choose the next exposure from: every gain at a time that averages mains of 50 and of 60 Hz, shorter
    /// times at the least gain, longer ones at the most.
    pub fn choices(self) -> Vec<Vec<f64>> {
        let (short, usual, long): (&[&[f64]], &[f64], &[&[f64]]) = match self {
            Chip::As7341 | Chip::As7343 => {
                (&[&[2.0, 599.0], &[8.0, 599.0]], &[29.0, 599.0], &[&[59.0, 599.0], &[119.0, 599.0]])
            }
            Chip::As7262 | Chip::As7265x => (&[&[1.0], &[4.0]], &[18.0], &[&[36.0], &[72.0]]),
            Chip::Tcs3472 => (&[&[255.0], &[250.0]], &[235.0], &[&[172.0], &[0.0]]),
            Chip::Opt4048 | Chip::Custom => (&[], &[], &[]),
        };
        let (Some(least), Some(most)) = (self.gains().first(), self.gains().last()) else {
            return Vec::new();
        };
        let with = |gain: &f32, time: &[f64]| [&[f64::from(*gain)], time].concat();
        let below = short.iter().map(|time| with(least, time));
        let usual = self.gains().iter().map(|gain| with(gain, usual));
        below.chain(usual).chain(long.iter().map(|time| with(most, time))).collect()
    }

    /// The most that a channel can report.
    pub fn largest_count(self) -> f64 {
        match self {
            Chip::As7341 | Chip::As7343 | Chip::As7262 | Chip::As7265x | Chip::Tcs3472 => 65_535.0,
            Chip::Opt4048 => f64::from(Exposure::opt4048().full_scale()),
            Chip::Custom => f64::MAX,
        }
    }

    /// How its settings are written.
    pub fn describe(self, values: &[f64]) -> String {
        let named = self.settings().iter().zip(values);
        named.map(|(name, value)| format!("{name} {value}")).collect::<Vec<_>>().join(" ")
    }

    /// The weights of its channels by the data sheet, if that is enough to tell them.
    pub fn nominal(self) -> Option<Vec<[f32; BINS]>> {
        fn rows<const C: usize>(folded: &Observer<C, BINS, Power, Grid>) -> Option<Vec<[f32; BINS]>> {
            Some(folded.weights().to_vec())
        }
        match self {
            Chip::As7341 => rows(&nominal::AS7341.fold(Curve::Step)),
            Chip::As7343 => rows(&nominal::AS7343.fold(Curve::Step)),
            Chip::As7262 => rows(&nominal::AS7262.fold(Curve::Step)),
            Chip::As7265x => rows(&nominal::AS7265X.fold(Curve::Step)),
            Chip::Tcs3472 | Chip::Opt4048 | Chip::Custom => None,
        }
    }
}
