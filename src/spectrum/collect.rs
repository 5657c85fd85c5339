//! Samples that arrive one by one, over a serial line say, into fixed memory.

use core::fmt;

/// Up to `CAP` samples of a spectrum, checked as they come in. Needs the feature `heapless`.
///
/// ```
/// # use nanospectra::{Light, Samples};
/// let mut samples = Samples::<512>::new();
/// for (nm, value) in [(380.0, 0.1), (555.0, 1.0), (780.0, 0.2)] {
///     samples.push(nm, value)?;
/// }
/// let light = Light::<16>::from_samples(samples.as_slice());
/// # assert!(light.is_ok());
/// # Ok::<(), nanospectra::PushError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Samples<const CAP: usize>(heapless::Vec<(f32, f32), CAP>);

/// Why a sample was refused; the samples before it are kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum PushError {
    /// There is no room for another sample.
    Full,
    /// The wavelength or the value is NaN or infinite.
    NotFinite,
    /// The wavelength is not above the one before it.
    NotIncreasing,
}

impl fmt::Display for PushError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Full => "no room for another sample",
            Self::NotFinite => "the sample is not a finite number",
            Self::NotIncreasing => "the wavelength is not above the one before it",
        })
    }
}

impl core::error::Error for PushError {}

impl<const CAP: usize> Samples<CAP> {
    /// No samples yet.
    #[must_use]
    pub const fn new() -> Self {
        Samples(heapless::Vec::new())
    }

    /// Adds the next sample, at a longer wavelength than the one before.
    ///
    /// # Errors
    /// [`PushError`]; the sample is then not taken, and nothing else changes.
    pub fn push(&mut self, nm: f32, value: f32) -> Result<(), PushError> {
        if !nm.is_finite() || !value.is_finite() {
            return Err(PushError::NotFinite);
        }
        if self.0.last().is_some_and(|before| nm <= before.0) {
            return Err(PushError::NotIncreasing);
        }
        self.0.push((nm, value)).map_err(|_| PushError::Full)
    }

    /// What has arrived, for [`Spectrum::from_samples`](crate::Spectrum::from_samples).
    #[must_use]
    pub fn as_slice(&self) -> &[(f32, f32)] {
        &self.0
    }

    /// Forgets all samples.
    pub fn clear(&mut self) {
        self.0.clear();
    }
}
