//! Auto-exposure: which exposure to take for the next reading.

use crate::sensor::{Count, Exposure};

/// A channel that has just saturated would still count this much after the step down: enough to predict from
/// it.
const AFTER_SATURATION: f32 = 64.0;

/// Auto-exposure on a ladder of exposures: advises the most sensitive one whose brightest channel will
/// stay below a target share of full scale.
///
/// ```
/// # use nanospectra::sensor::{AutoExposure, chip::as7341};
/// static AUTO: AutoExposure<'static> = nanospectra::const_unwrap!(AutoExposure::new(&as7341::LADDER));
/// let start = AUTO.middle();
/// let advice = AUTO.advise(start, &[120_u16, 300, 280, 210, 0, 0, 0, 0]);
/// assert!(!advice.saturated && advice.next > start); // there is room for more
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AutoExposure<'a> {
    ladder: &'a [Exposure],
    target: f32,
}

/// The exposure that is advised for the next reading.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Advice {
    /// The exposure for the next reading: its place in the ladder.
    pub next: usize,
    /// This reading has a channel at full scale: how much light there is cannot be told, so `next` is a large
    /// step down. If it is the exposure in use already (0), there is too much light for the ladder.
    pub saturated: bool,
}

impl<'a> AutoExposure<'a> {
    /// Takes a ladder from the least to the most sensitive exposure; the target is 0.8 of full scale.
    ///
    /// # Errors
    /// [`LadderError`]: no exposure at all, one that cannot count, one not more sensitive (gain times time) than
    /// the one before.
    pub const fn new(ladder: &'a [Exposure]) -> Result<Self, LadderError> {
        let mut index = 0;
        let mut before = 0.0;
        let mut rest = ladder;
        while let [exposure, others @ ..] = rest {
            let sensitivity = exposure.gain() * exposure.time_ms();
            // Written so that NaN is refused too.
            if !(exposure.gain() > 0.0 && sensitivity > 0.0 && sensitivity < f32::INFINITY)
                || exposure.full_scale() == 0
            {
                return Err(LadderError::CannotCount { index });
            }
            if sensitivity <= before {
                return Err(LadderError::NotSorted { index });
            }
            before = sensitivity;
            index += 1;
            rest = others;
        }
        if index == 0 { Err(LadderError::Empty) } else { Ok(AutoExposure { ladder, target: 0.8 }) }
    }

    /// The same ladder with another target: the share of full scale, 0.1..=0.9 (beyond it counts as the end),
    /// that the brightest channel shall stay below. It moves to less only above (1 + target) / 2, so that it
    /// does not swing.
    #[must_use]
    pub const fn with_target(self, share: f32) -> Self {
        let target = if share > 0.9 {
            0.9
        } else if share > 0.1 {
            share
        } else {
            0.1
        };
        AutoExposure { target, ..self }
    }

    /// The exposure at a place of the ladder; the last one beyond it.
    #[must_use]
    pub fn exposure(&self, index: usize) -> Exposure {
        let last = self.ladder.last().copied().unwrap_or(Exposure::new(1.0, 1.0, 1));
        self.ladder.get(index).copied().unwrap_or(last)
    }

    /// The middle of the ladder: where to begin.
    #[must_use]
    pub const fn middle(&self) -> usize {
        self.ladder.len() / 2
    }

    /// The next place, from the raw counts of a reading at the place `in_use`.
    ///
    /// A light that does not change is found in four readings, wherever it begins, on a ladder like the
    /// [AS7341's](crate::sensor::chip::as7341::LADDER) (full scales of thousands of counts, steps of up to
    /// 8): saturated readings step down until 64 counts would be left of a full scale, and what is then
    /// counted tells the rest. With NaN among the counts it stays.
    #[must_use]
    pub fn advise<T: Count, const C: usize>(&self, in_use: usize, counts: &[T; C]) -> Advice {
        let in_use = in_use.min(self.ladder.len().saturating_sub(1));
        let used = self.exposure(in_use);
        if used.saturated(counts).count() > 0 {
            let keeps_enough = |exposure: &Exposure| {
                used.full_scale() as f32 * (used.per_count() / exposure.per_count()) >= AFTER_SATURATION
            };
            let next = self.ladder.iter().take(in_use).position(keeps_enough);
            return Advice { next: next.unwrap_or(in_use.saturating_sub(1)), saturated: true };
        }
        let stay = Advice { next: in_use, saturated: false };
        let mut brightest = 0.0;
        for count in counts {
            let count = count.to_f32();
            if count.is_nan() {
                return stay;
            }
            brightest = if count > brightest { count } else { brightest };
        }
        // A count may be up to one more than it says; the margin is never a smaller share at a finer
        // exposure, so that what was right from afar stays right.
        let margin = brightest / AFTER_SATURATION;
        let bound = brightest + if margin > 1.0 { margin } else { 1.0 };
        let fits = |exposure: &Exposure| {
            bound * (used.per_count() / exposure.per_count()) < self.target * exposure.full_scale() as f32
        };
        let best = self.ladder.iter().rposition(fits).unwrap_or(0);
        let too_near = brightest > 0.5 * (1.0 + self.target) * used.full_scale() as f32;
        if best > in_use || too_near { Advice { next: best, ..stay } } else { stay }
    }
}

/// Why a ladder was refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum LadderError {
    /// It has no exposure.
    Empty,
    /// Gain, time or full scale of this exposure is not above zero, or not finite.
    CannotCount {
        /// Place in the ladder.
        index: usize,
    },
    /// This exposure is not more sensitive than the one before.
    NotSorted {
        /// Place in the ladder.
        index: usize,
    },
}

impl LadderError {
    /// The reason without its numbers, for [`const_unwrap!`](crate::const_unwrap).
    #[must_use]
    pub const fn message(&self) -> &'static str {
        match self {
            LadderError::Empty => "no exposure to choose from",
            LadderError::CannotCount { .. } => {
                "an exposure has a gain, a time or a full scale that is not above zero"
            }
            LadderError::NotSorted { .. } => "an exposure is not more sensitive than the one before",
        }
    }
}

impl core::fmt::Display for LadderError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(self.message())?;
        match self {
            LadderError::Empty => Ok(()),
            LadderError::CannotCount { index } | LadderError::NotSorted { index } => {
                write!(f, " (exposure {index})")
            }
        }
    }
}

impl core::error::Error for LadderError {}
