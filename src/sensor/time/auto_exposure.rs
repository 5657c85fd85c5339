//! Auto-exposure: which exposure to take for the next reading.

use crate::sensor::{Count, Exposure};

/// After the step down, a channel that has just saturated would still count this much. That is enough to
/// predict the next exposure from it.
const AFTER_SATURATION: f32 = 64.0;

/// Advises which of a list of exposures to take next: the most sensitive one whose brightest channel will
/// stay below a target share of full scale.
///
/// The list (the ladder) goes from the least to the most sensitive exposure; the modules of [`chip`] have one
/// ready. [`new`](Self::new) takes it, [`middle`](Self::middle) says where to begin, and
/// [`advise`](Self::advise) is called with each reading.
///
/// # Example
///
/// ```
/// use nanospectra::sensor::{AutoExposure, chip::as7341};
///
/// static AUTO: AutoExposure<'static> = nanospectra::const_unwrap!(AutoExposure::new(&as7341::LADDER));
/// let start = AUTO.middle();
/// let advice = AUTO.advise(start, &[120_u16, 300, 280, 210, 0, 0, 0, 0]);
/// assert!(!advice.saturated && advice.next > start); // there is room for more
/// // What to set for the next reading, and the exposure to read it with.
/// let (gain, atime, astep) = as7341::LADDER_SETTINGS[advice.next];
/// assert_eq!(AUTO.exposure(advice.next), as7341::exposure(gain, atime, astep));
/// ```
///
/// [`chip`]: crate::sensor::chip
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AutoExposure<'a> {
    ladder: &'a [Exposure],
    target: f32,
}

/// The exposure that is advised for the next reading, as [`AutoExposure::advise`] returns it.
///
/// See the [example](AutoExposure#example).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Advice {
    /// The exposure to take for the next reading, as its place in the ladder.
    pub next: usize,
    /// Whether this reading has a channel at full scale. How much light there is cannot be told then, so that
    /// `next` is a large step down. If the exposure in use is already the first one, 0, there is too much
    /// light for the ladder.
    pub saturated: bool,
}

impl<'a> AutoExposure<'a> {
    /// Takes a ladder from the least to the most sensitive exposure, with a target of 0.8 of full scale. See
    /// the [example](#example).
    ///
    /// # Errors
    /// [`LadderError`] if there is no exposure at all, if one cannot count, or if one is not more sensitive
    /// (gain times time) than the one before.
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

    /// Returns the middle place of the ladder, where to begin. See the [example](#example).
    #[must_use]
    pub const fn middle(&self) -> usize {
        self.ladder.len() / 2
    }

    /// Returns the next place in the ladder, from the raw counts of a reading at the place `in_use`. See the
    /// [example](#example).
    ///
    /// A light that does not change is found in four readings, wherever the search begins, on a ladder like
    /// the [AS7341's](crate::sensor::chip::as7341::LADDER) (full scales of thousands of counts, steps of up
    /// to 8). Saturated readings step down until 64 counts would be left of a full scale, and the next
    /// reading tells the rest. With NaN among the counts the place stays.
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
        // A count may be up to one more than it says. The margin is never a smaller share at a finer
        // exposure, so that an exposure which was right from afar stays right.
        let margin = brightest / AFTER_SATURATION;
        let bound = brightest + if margin > 1.0 { margin } else { 1.0 };
        let fits = |exposure: &Exposure| {
            bound * (used.per_count() / exposure.per_count()) < self.target * exposure.full_scale() as f32
        };
        let best = self.ladder.iter().rposition(fits).unwrap_or(0);
        let too_near = brightest > 0.5 * (1.0 + self.target) * used.full_scale() as f32;
        if best > in_use || too_near { Advice { next: best, ..stay } } else { stay }
    }

    /// Returns the exposure at a place of the ladder, or the last one for a place beyond it. See the
    /// [example](#example).
    #[must_use]
    pub fn exposure(&self, index: usize) -> Exposure {
        let last = self.ladder.last().copied().unwrap_or(Exposure::new(1.0, 1.0, 1));
        self.ladder.get(index).copied().unwrap_or(last)
    }

    /// Replaces the target: the share of full scale, 0.1..=0.9, that the brightest channel shall stay below.
    ///
    /// A share outside this range counts as its nearer end. The advice moves to less sensitive exposures only
    /// above (1 + target) / 2, so that it does not swing between two of them.
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
}

/// Why a ladder was refused by [`AutoExposure::new`].
///
/// # Example
///
/// ```
/// use nanospectra::sensor::{AutoExposure, Exposure, LadderError};
///
/// let [fast, slow] = [10.0, 100.0].map(|ms| Exposure::new(1.0, ms, 65_535));
/// assert_eq!(AutoExposure::new(&[slow, fast]), Err(LadderError::NotSorted { index: 1 }));
/// assert_eq!(AutoExposure::new(&[]), Err(LadderError::Empty));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum LadderError {
    /// The ladder does not have any exposure. See the [example](#example).
    Empty,
    /// The gain, time or full scale of this exposure is not above zero, or it is not finite.
    CannotCount {
        /// The place of this exposure in the ladder, which counts from 0.
        index: usize,
    },
    /// This exposure is not more sensitive than the one before. See the [example](#example).
    NotSorted {
        /// The place of this exposure in the ladder, which counts from 0.
        index: usize,
    },
}

impl LadderError {
    /// Returns the reason without its numbers, for [`const_unwrap!`](crate::const_unwrap).
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
