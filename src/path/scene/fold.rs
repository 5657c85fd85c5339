//! Folds a scene into the observer that looks at it.

use crate::observer::Observer;
use crate::path::PolarizedObserver;
use crate::path::scene::{Part, Scene};
use crate::spectrum::{Factor, Power, Spectrum};

/// The error that is returned if a part polarizes light, which one number for each bin does not describe.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PolarizationError {
    /// The number of the first part that polarizes light, counted from 0.
    pub part: usize,
}

impl core::fmt::Display for PolarizationError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(
            f,
            "part {} polarizes light: call fold_polarized or leaving_polarized, or leave its effect out",
            self.part
        )
    }
}

impl core::error::Error for PolarizationError {}

/// The observer on the way back to the lamp. It has weights for Stokes vectors only while parts need them.
enum Eye<const C: usize, const N: usize, G> {
    Plain(Observer<C, N, Power, G>),
    Stokes(PolarizedObserver<C, N, Power, G>),
}

impl<const C: usize, const N: usize, G> Eye<C, N, G> {
    fn unpolarized(self) -> Observer<C, N, Power, G> {
        match self {
            Eye::Plain(eye) => eye,
            Eye::Stokes(eye) => eye.unpolarized_light(),
        }
    }

    fn polarized(self) -> PolarizedObserver<C, N, Power, G> {
        match self {
            Eye::Plain(eye) => eye.polarized(),
            Eye::Stokes(eye) => eye,
        }
    }

    fn through(self, factors: &Spectrum<Factor, N, G>) -> Self {
        match self {
            Eye::Plain(eye) => Eye::Plain(eye.through(factors)),
            Eye::Stokes(eye) => Eye::Stokes(eye.through(factors)),
        }
    }
}

impl<const N: usize, const CAP: usize, G> Scene<'_, N, CAP, G> {
    /// Folds the whole scene into an observer, so that it sees a lamp as if it looked through the scene.
    ///
    /// `scene.fold(&eye)?.sees(&lamp)` returns what `eye` sees of the lamp's light. Call
    /// [`under`](Observer::under) with the lamp to look at a reflectance that the light meets before the
    /// first part. Fold again when a part changes; there is no need to when the lamp changes. See the
    /// [example](#example).
    ///
    /// # Accuracy
    /// What it sees differs from what the observer sees of [`leaving`](Self::leaving) by at most 4e-7 of the
    /// sum of the absolute values of all terms, and by 3e-8 more for each part beyond four.
    ///
    /// # Errors
    /// Returns a [`PolarizationError`] if a mirror, a polarizer or a retarder is in the scene and its effect
    /// is not left out; [`fold_polarized`](Self::fold_polarized) folds them too.
    pub fn fold<const C: usize>(
        &self,
        eye: &Observer<C, N, Power, G>,
    ) -> Result<Observer<C, N, Power, G>, PolarizationError> {
        self.unpolarized()?;
        Ok(self.fold_polarized(eye))
    }

    /// Folds the whole scene into an observer as [`fold`](Self::fold) does, with weights for Stokes vectors
    /// where parts polarize light.
    ///
    /// The light of the lamp is unpolarized.
    ///
    /// # Cost
    /// On a Cortex-M4F three channels of 31 bands take 8,290 bytes of stack at opt-level 3 and 8,310 at "s"
    /// if a part polarizes, for Stokes vectors of four numbers.
    #[must_use]
    pub fn fold_polarized<const C: usize>(&self, eye: &Observer<C, N, Power, G>) -> Observer<C, N, Power, G> {
        let mut eye = Eye::Plain(*eye);
        for step in self.steps().rev() {
            eye = match &step.part {
                Part::Filter(factors) => eye.through(factors),
                Part::Surface(factors) => Eye::Plain(eye.unpolarized().looking_at(factors)),
                Part::Effect(matter) if step.left_out => {
                    Eye::Plain(eye.unpolarized().looking_at(&matter.without_effect()))
                }
                Part::Effect(matter) => Eye::Plain(eye.unpolarized().looking_at_matter(*matter)),
                part if step.left_out => eye.through(&part.without_effect()),
                Part::Polarizing { mueller, .. } => Eye::Stokes(eye.polarized().behind(mueller)),
            };
        }
        eye.unpolarized()
    }

    /// Returns an error if one number for each bin does not describe all that happens.
    pub(super) fn unpolarized(&self) -> Result<(), PolarizationError> {
        let polarizes = self.steps().position(|step| !step.left_out && step.part.polarizes());
        polarizes.map_or(Ok(()), |part| Err(PolarizationError { part }))
    }
}
