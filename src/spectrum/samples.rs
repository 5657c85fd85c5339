//! Spectra from measured samples, (wavelength in nm, value), at any spacing.

use crate::grid::Grid;
use crate::spectrum::interpolate::{Interpolation, Place};
use crate::spectrum::{Outside, Quantity, Spectrum};
use core::fmt;

/// Says why samples are not a spectrum, and names the first sample at fault by its index, counted from 0.
///
/// # Example
/// ```
/// use nanospectra::{Light, SamplesError};
///
/// let unsorted = [(400.0, 1.0), (500.0, 2.0), (450.0, 2.0)];
/// let error = Light::<16>::from_samples(&unsorted).err();
/// assert_eq!(error, Some(SamplesError::NotIncreasing { index: 2 }));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SamplesError {
    /// There are fewer samples than the interpolation needs: 2, or 6 for Sprague's.
    TooFew {
        /// How many samples the interpolation needs at least.
        needed: usize,
    },
    /// A wavelength or value is NaN or infinite.
    NotFinite {
        /// The index of the first sample that is not finite.
        index: usize,
    },
    /// A wavelength is not above the one before it, so the samples are unsorted or one stands twice. See the
    /// [example](SamplesError#example).
    NotIncreasing {
        /// The index of the first sample whose wavelength is not above the one before it.
        index: usize,
    },
    /// The spacing changes, and Sprague's interpolation needs the same spacing throughout.
    NotRegular {
        /// The index of the first sample that is more than 1 % of a step off the regular spacing.
        index: usize,
    },
}

impl fmt::Display for SamplesError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFew { needed } => write!(f, "fewer than {needed} samples"),
            Self::NotFinite { index } => write!(f, "sample {index} is not a finite number"),
            Self::NotIncreasing { index } => {
                write!(f, "the wavelength of sample {index} is not above the one before it")
            }
            Self::NotRegular { index } => {
                write!(f, "sample {index} is off the regular spacing that Sprague interpolation needs")
            }
        }
    }
}

impl core::error::Error for SamplesError {}

impl<Q: Quantity, const N: usize, G: Grid> Spectrum<Q, N, G> {
    /// Makes a spectrum from measured samples: joins them by straight lines and averages these over each bin.
    ///
    /// `samples` are pairs of (wavelength in nm, value), in increasing order, at any spacing. The integral
    /// over each bin is exact, whether a bin has hundreds of samples or ten bins have one. Beyond the first
    /// and the last sample a light is zero, and a factor keeps its end values ([`Quantity::OUTSIDE`]). See
    /// the [example](Spectrum#example).
    ///
    /// # Accuracy
    /// A constant comes out as exactly that constant, at every `N`. Other spectra are within 2e-6 of the
    /// largest sample, and 7e-5 of it divided by the width of a bin in nm, because the ends of the bins are
    /// rounded to f32 (`tests/spectrum/worst_spectra.rs`).
    ///
    /// # Errors
    /// [`SamplesError`] if there are fewer than two samples, a number is not finite, or the wavelengths do
    /// not increase. Nothing is sorted or dropped.
    pub fn from_samples(samples: &[(f32, f32)]) -> Result<Self, SamplesError> {
        Self::from_samples_outside(samples, Q::OUTSIDE)
    }

    /// Makes a spectrum from samples as [`from_samples`](Self::from_samples) does, where `outside` says what
    /// lies beyond the first and the last sample.
    ///
    /// ```
    /// # use nanospectra::{Bins, Light, Outside};
    /// let two = [(500.0, 1.0), (600.0, 1.0)];
    /// let held = Light::<3, Bins<400, 700>>::from_samples_outside(&two, Outside::Hold)?;
    /// assert_eq!(held, Light::flat(1.0));
    /// assert_eq!(Light::<3, Bins<400, 700>>::from_samples(&two)?.values(), &[0.0, 1.0, 0.0]);
    /// # Ok::<(), nanospectra::SamplesError>(())
    /// ```
    ///
    /// # Errors
    /// [`SamplesError`], as for [`from_samples`](Self::from_samples).
    pub fn from_samples_outside(samples: &[(f32, f32)], outside: Outside) -> Result<Self, SamplesError> {
        check(samples)?;
        let mut lines = Lines { samples, outside, next: 0 };
        let mut averages = [0.0; N];
        for (k, average) in averages.iter_mut().enumerate() {
            *average = lines.average(Self::edge_nm(k), Self::edge_nm(k + 1));
        }
        Ok(Self::from_bins(averages))
    }

    /// Returns the value at the center of each bin, interpolated between measured samples.
    ///
    /// On the [`Fine`](crate::Fine) grid this is the CIE's rule for measured samples, which is to interpolate
    /// to 1 nm and then to sum. For wide bins use [`from_samples`](Self::from_samples), because the values at
    /// their centers miss what lies between. Beyond the first and the last sample a light is zero, and a
    /// factor keeps its end values ([`Quantity::OUTSIDE`]).
    ///
    /// ```
    /// # use nanospectra::{Fine, Interpolation, Power};
    /// let lamp = [(380.0, 0.0), (480.0, 1.0), (780.0, 1.0)];
    /// let fine = Fine::<Power>::interpolated(&lamp, Interpolation::Linear)?;
    /// assert_eq!(fine.values()[405 - 360], 0.25);
    /// # Ok::<(), nanospectra::SamplesError>(())
    /// ```
    ///
    /// # Errors
    /// [`SamplesError`], as for [`from_samples`](Self::from_samples). Sprague's interpolation also needs six
    /// samples at one spacing.
    pub fn interpolated(samples: &[(f32, f32)], by: Interpolation) -> Result<Self, SamplesError> {
        Self::interpolated_outside(samples, by, Q::OUTSIDE)
    }

    /// Interpolates samples as [`interpolated`](Self::interpolated) does, where `outside` says what lies
    /// beyond the first and the last sample. See the [example](Self::from_samples_outside) of
    /// `from_samples_outside`.
    ///
    /// # Errors
    /// [`SamplesError`], as for [`interpolated`](Self::interpolated).
    pub fn interpolated_outside(
        samples: &[(f32, f32)],
        by: Interpolation,
        outside: Outside,
    ) -> Result<Self, SamplesError> {
        check(samples)?;
        let mut values = [0.0; N];
        match by {
            Interpolation::Linear => {
                let mut lines = Lines { samples, outside, next: 0 };
                for (k, value) in values.iter_mut().enumerate() {
                    *value = lines.at(Self::center_nm(k));
                }
            }
            Interpolation::Sprague => {
                let step = regular_step(samples)?;
                let (first, last) = ends(samples);
                let scale = scale(first.0, last.0);
                for (k, value) in values.iter_mut().enumerate() {
                    let nm = Self::center_nm(k);
                    *value = if nm < first.0 {
                        outside.beyond(first.1)
                    } else if nm > last.0 {
                        outside.beyond(last.1)
                    } else {
                        let distance = scale * nm - scale * first.0;
                        regular(samples, &Place::of(distance, step, samples.len(), by))
                    };
                }
            }
        }
        Ok(Self::from_bins(values))
    }
}

fn check(samples: &[(f32, f32)]) -> Result<(), SamplesError> {
    if samples.len() < 2 {
        return Err(SamplesError::TooFew { needed: 2 });
    }
    let mut before = f32::NEG_INFINITY;
    for (index, (nm, value)) in samples.iter().enumerate() {
        if !nm.is_finite() || !value.is_finite() {
            return Err(SamplesError::NotFinite { index });
        }
        if *nm <= before {
            return Err(SamplesError::NotIncreasing { index });
        }
        before = *nm;
    }
    Ok(())
}

/// The first and the last sample; `check` has made sure that there are two.
fn ends(samples: &[(f32, f32)]) -> ((f32, f32), (f32, f32)) {
    match samples {
        [first, .., last] => (*first, *last),
        _ => ((0.0, 0.0), (0.0, 0.0)),
    }
}

/// The factor by which wavelengths are multiplied before they are subtracted, so that no difference between
/// `first` and `last` overflows. It is 1 for all but absurd samples, and then changes no bit.
fn scale(first: f32, last: f32) -> f32 {
    if last - first <= 1e38 { 1.0 } else { 0.25 }
}

/// The distance between two samples, times [`scale`].
fn regular_step(samples: &[(f32, f32)]) -> Result<f32, SamplesError> {
    if samples.len() < 6 {
        return Err(SamplesError::TooFew { needed: 6 });
    }
    let (first, last) = ends(samples);
    let scale = scale(first.0, last.0);
    let step = (scale * last.0 - scale * first.0) / (samples.len() - 1) as f32;
    for (index, (nm, _)) in samples.iter().enumerate() {
        if (scale * nm - (scale * first.0 + index as f32 * step)).abs() > 0.01 * step {
            return Err(SamplesError::NotRegular { index });
        }
    }
    Ok(step)
}

/// The value at a place among regular samples.
fn regular(samples: &[(f32, f32)], place: &Place) -> f32 {
    let reference = samples.get(place.reference).map_or(0.0, |s| s.1);
    let near = samples.iter().skip(place.start).zip(&place.weights);
    reference + near.map(|(sample, weight)| weight * (sample.1 - reference)).sum::<f32>()
}

/// The straight lines that join the samples, read from short to long wavelengths.
struct Lines<'a> {
    samples: &'a [(f32, f32)],
    outside: Outside,
    /// The index of the first sample above the wavelength that was asked for last.
    next: usize,
}

impl Lines<'_> {
    /// The value at `nm`, which must not be below the wavelength that was asked for before.
    fn at(&mut self, nm: f32) -> f32 {
        while self.samples.get(self.next).is_some_and(|s| s.0 <= nm) {
            self.next += 1;
        }
        self.mean(nm, nm)
    }

    /// The mean over `from..to`, which lie on the straight line that ends at `next`. (The value at the middle
    /// wavelength would be the same, but that wavelength would be rounded by up to 1.5e-5 nm, which counts
    /// where samples are 0.05 nm apart.)
    fn mean(&self, from: f32, to: f32) -> f32 {
        let below = self.next.checked_sub(1).and_then(|i| self.samples.get(i));
        match (below, self.samples.get(self.next)) {
            (Some(a), Some(b)) => {
                let scale = scale(a.0, b.0);
                let start = scale * a.0;
                let middle = ((scale * from - start) + (scale * to - start)) * 0.5;
                a.1 + (b.1 - a.1) * (middle / (scale * b.0 - start))
            }
            // The very last sample itself still lies inside.
            (Some(a), None) if a.0 == to => a.1,
            (Some(end), None) | (None, Some(end)) => self.outside.beyond(end.1),
            (None, None) => 0.0,
        }
    }

    /// The average over `low..high`. Deviations from the first piece are summed, so that a constant stays
    /// exactly constant, and rounding errors are relative to the part that varies.
    fn average(&mut self, low: f32, high: f32) -> f32 {
        let (mut from, mut first, mut sum) = (low, None, 0.0);
        while from < high {
            // This moves `next` above `from`. The piece ends at that sample, or with the bin.
            self.at(from);
            let to = self.samples.get(self.next).map_or(high, |s| s.0.min(high));
            let mean = self.mean(from, to);
            let reference = *first.get_or_insert(mean);
            sum += (to - from) * (mean - reference);
            from = to;
        }
        first.unwrap_or(0.0) + sum / (high - low)
    }
}
