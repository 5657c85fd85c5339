//! Fixed memory for samples that arrive one by one, for example over a serial line.

use core::fmt;

/// Collects up to `CAP` samples of a spectrum in fixed memory, and checks each of them as it arrives.
///
/// Call [`push`](Self::push) for each sample, then give [`as_slice`](Self::as_slice) to
/// [`Spectrum::from_samples`](crate::Spectrum::from_samples). This type needs the feature `heapless`.
///
/// # Example
/// ```
/// # use nanospectra::{Light, Samples};
/// let mut samples = Samples::<512>::new();
/// for (nm, value) in [(380.0, 0.1), (555.0, 1.0), (780.0, 0.2)] {
///     samples.push(nm, value)?;
/// }
/// let light = Light::<16>::from_samples(samples.as_slice())?;
/// // The straight lines rise to 1 at 555 nm, the middle of the grid.
/// assert!(light.peak() > 0.9 && light.peak() < 1.0);
///
/// samples.clear();
/// assert!(samples.as_slice().is_empty());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Samples<const CAP: usize>(heapless::Vec<(f32, f32), CAP>);

/// Says why [`Samples::push`] refused a sample. The samples before it are kept.
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
            Self::Full => "there is no room for another sample",
            Self::NotFinite => "the sample is not a finite number",
            Self::NotIncreasing => "the wavelength is not above the one before it",
        })
    }
}

impl core::error::Error for PushError {}

impl<const CAP: usize> Samples<CAP> {
    /// Returns an empty collection, which has room for `CAP` samples. See the [example](Samples#example).
    #[must_use]
    pub const fn new() -> Self {
        Samples(heapless::Vec::new())
    }

    /// Adds the next sample, which must have a longer wavelength (`nm`) than the one before. See the
    /// [example](Samples#example).
    ///
    /// # Errors
    /// [`PushError`] if there is no room, a number is NaN or infinite, or the wavelength does not increase.
    /// The sample is then not added, and nothing else changes.
    pub fn push(&mut self, nm: f32, value: f32) -> Result<(), PushError> {
        if !nm.is_finite() || !value.is_finite() {
            return Err(PushError::NotFinite);
        }
        if self.0.last().is_some_and(|before| nm <= before.0) {
            return Err(PushError::NotIncreasing);
        }
        self.0.push((nm, value)).map_err(|_| PushError::Full)
    }

    /// Returns the samples that have arrived, for
    /// [`Spectrum::from_samples`](crate::Spectrum::from_samples). See the [example](Samples#example).
    #[must_use]
    pub fn as_slice(&self) -> &[(f32, f32)] {
        &self.0
    }

    /// Removes all samples, so that the next spectrum can arrive. See the [example](Samples#example).
    pub fn clear(&mut self) {
        self.0.clear();
    }
}
