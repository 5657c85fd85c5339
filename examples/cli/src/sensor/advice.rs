//! Chooses the gain and the time of the next reading.

use crate::sensor::chip::Chip;
use nanospectra::sensor::{AutoExposure, Exposure};

/// The exposure for the next reading of the same light.
pub struct Next {
    pub settings: String,
    pub exposure: Exposure,
    /// Whether it is the exposure in use.
    pub same: bool,
}

/// The relative difference in sensitivity below which two exposures count as one.
const ALIKE: f32 = 1e-3;

/// Chooses among the chip's own exposures and the one in use. Returns `None` if there is no choice.
pub fn of<const C: usize>(chip: Chip, used: Exposure, settings: &[f64], counts: &[f32; C]) -> Option<Next> {
    let sensitivity = |exposure: &Exposure| exposure.gain() * exposure.time_ms();
    let mut ladder = vec![(used, settings.to_vec())];
    for choice in chip.choices() {
        let exposure = chip.exposure(&choice).ok()?;
        let alike = |(other, _): &(Exposure, Vec<f64>)| {
            (sensitivity(other) / sensitivity(&exposure) - 1.0).abs() < ALIKE
        };
        if !ladder.iter().any(alike) {
            ladder.push((exposure, choice));
        }
    }
    if ladder.len() == 1 {
        return None;
    }
    ladder.sort_by(|a, b| sensitivity(&a.0).total_cmp(&sensitivity(&b.0)));
    let exposures: Vec<Exposure> = ladder.iter().map(|(exposure, _)| *exposure).collect();
    let in_use = exposures.iter().position(|exposure| *exposure == used)?;
    let advice = AutoExposure::new(&exposures).ok()?.advise(in_use, counts);
    let (exposure, settings) = ladder.get(advice.next)?;
    Some(Next { settings: chip.describe(settings), exposure: *exposure, same: advice.next == in_use })
}
