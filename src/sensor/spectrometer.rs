//! Mini-spectrometers: from the counts of pixels to the bins of a spectrum.

use crate::grid::Grid;
use crate::sensor::Count;
use crate::spectrum::{PerBin, Spectrum};
use core::fmt;
use core::ops::Range;

/// The wavelengths of the `P` pixels of one spectrometer, which follow a polynomial with `K` coefficients
/// from its certificate.
///
/// A C12880MA comes with six coefficients, of fifth order, in nm. [`new`](Self::new) takes them, and
/// [`rebinned`](Self::rebinned) puts counts into the bins of a spectrum.
///
/// # Example
///
/// ```
/// use nanospectra::sensor::{FirstPixel, PixelWavelengths};
/// // The coefficients of one C12880MA, whose certificate counts pixels from 1.
/// static UNIT: PixelWavelengths<288> = nanospectra::const_unwrap!(PixelWavelengths::new(
///     [3.102_449e2, 2.683_674, -1.121_367e-3, -6.962_632e-6, 8.478_353e-9, 5.208_724e-12],
///     FirstPixel::One,
/// ));
/// assert!((UNIT.nm(0) - 312.93).abs() < 0.01);
/// ```
///
/// # Accuracy
/// 2.5e-4 nm for any fifth order over 288 pixels that ends below 1100 nm, and 1.5e-4 for a C12880MA: Horner's
/// rule in f32 (searched in `tests/sensor/worst_readings.rs`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelWavelengths<const P: usize, const K: usize = 6> {
    coefficients: [f32; K],
    first: FirstPixel,
}

/// Says which number the certificate of a spectrometer gives to its first pixel. The wrong choice shifts the
/// wavelengths of a C12880MA by 2.7 nm.
///
/// See the [example](PixelWavelengths#example) of a unit whose pixels count from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum FirstPixel {
    /// The first pixel has the number 0.
    Zero,
    /// The first pixel has the number 1, as on the certificates of Hamamatsu.
    One,
}

/// The counts of all pixels, put into the bins of a grid.
///
/// [`PixelWavelengths::rebinned`] returns it and has an example.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rebinned<const N: usize, G> {
    /// The counts that fell into each bin.
    pub counts: Spectrum<PerBin, N, G>,
    /// The counts that fell outside the grid.
    pub outside: f32,
}

impl<const P: usize, const K: usize> PixelWavelengths<P, K> {
    /// Makes the scale from the coefficients in the certificate of one unit, the constant one first. See the
    /// [example](#example).
    ///
    /// The wavelength of pixel p is `coefficients[0]` + `coefficients[1]` p + `coefficients[2]` p^2 and so
    /// on, in nm.
    ///
    /// # Errors
    /// [`PixelWavelengthsError`] with the first pixel whose upper edge is not above its lower one, as after a
    /// mistyped coefficient, a lost exponent, a reversed order, or with NaN.
    pub const fn new(coefficients: [f32; K], first: FirstPixel) -> Result<Self, PixelWavelengthsError> {
        let unit = PixelWavelengths { coefficients, first };
        let mut pixel = 0;
        while pixel < P {
            let (low, high) = (unit.edge_nm(pixel), unit.edge_nm(pixel + 1));
            if !(low < high && low.is_finite() && high.is_finite()) {
                return Err(PixelWavelengthsError { pixel });
            }
            pixel += 1;
        }
        Ok(unit)
    }

    /// Distributes counts over the bins of a grid, each pixel in proportion to how much of it lies in a bin.
    ///
    /// Subtract dark counts first ([`above_dark_pixels`]). A pixel has already summed up the light on its
    /// width, so counts are split and added up and never multiplied by a step; [`density`](Spectrum::density)
    /// then divides by the width of the bins. To get power, multiply by the `Factor` 1 over the responsivity
    /// of the spectrometer.
    ///
    /// ```
    /// # use nanospectra::{Bins, sensor::{FirstPixel, PixelWavelengths}};
    /// let unit = PixelWavelengths::<100, 2>::new([400.0, 3.0], FirstPixel::Zero)?; // 398.5 to 698.5 nm
    /// let rebinned = unit.rebinned::<30, Bins<400, 700>>(&[6.0; 100]);
    /// assert!((rebinned.counts.values()[7] - 20.0).abs() < 1e-3 && (rebinned.outside - 3.0).abs() < 1e-3);
    /// assert!((rebinned.counts.density().values()[7] - 2.0).abs() < 1e-4); // per nm
    /// # Ok::<(), nanospectra::sensor::PixelWavelengthsError>(())
    /// ```
    ///
    /// # Accuracy
    /// `counts` and `outside` together are the counts within 1e-6 of their sizes. An edge is off by as much as
    /// the wavelength of a pixel: 2.5e-4 nm at worst, and 1.5e-4 nm for a C12880MA.
    #[must_use]
    pub fn rebinned<const N: usize, G: Grid>(&self, counts: &[f32; P]) -> Rebinned<N, G> {
        let mut bins = Spectrum::<PerBin, N, G>::flat(0.0);
        let mut outside = 0.0;
        // The first bin that ends above the pixel's lower edge.
        let mut first = 0;
        let mut high = self.edge_nm(0);
        for (pixel, count) in counts.iter().enumerate() {
            let low = high;
            high = self.edge_nm(pixel + 1);
            while first < N && Spectrum::<PerBin, N, G>::edge_nm(first + 1) <= low {
                first += 1;
            }
            let per_nm = count / (high - low);
            let start = Spectrum::<PerBin, N, G>::edge_nm(0);
            // The part that no bin takes is left over.
            let (mut left, mut from) = (*count, low.max(start));
            for (bin, value) in bins.values_mut().iter_mut().enumerate().skip(first) {
                if from >= high {
                    break;
                }
                let edge = Spectrum::<PerBin, N, G>::edge_nm(bin + 1);
                // The last piece of a pixel is its rest, so that no count is lost to rounding.
                let rest = high <= edge && low >= start;
                let share = if rest { left } else { (high.min(edge) - from) * per_nm };
                *value += share;
                left -= share;
                from = edge;
            }
            outside += left;
        }
        Rebinned { counts: bins, outside }
    }

    /// Returns the center of pixel `pixel` in nm, where pixels always count from 0. See the
    /// [example](#example).
    #[must_use]
    pub const fn nm(&self, pixel: usize) -> f32 {
        self.at(pixel as f32)
    }

    /// Returns the lower edge of pixel `pixel` in nm; `pixel` = `P` gives the upper end of the last one.
    ///
    /// It is the polynomial half a pixel before, at `pixel` - 1/2 in the numbers from 0. Where the polynomial
    /// bends, that is not exactly half way between the centers of two pixels.
    ///
    /// ```
    /// # use nanospectra::sensor::{FirstPixel, PixelWavelengths};
    /// let unit = PixelWavelengths::<100, 2>::new([400.0, 3.0], FirstPixel::Zero)?; // 400 nm, 403 nm ..
    /// assert_eq!((unit.nm(1), unit.edge_nm(1), unit.edge_nm(100)), (403.0, 401.5, 698.5));
    /// // A scale that bends: 400, 403 and 408 nm, with edges at 401.25 and 405.25.
    /// let bent = PixelWavelengths::<3, 3>::new([400.0, 2.0, 1.0], FirstPixel::Zero)?;
    /// assert_eq!((bent.nm(0), bent.nm(1), bent.edge_nm(1)), (400.0, 403.0, 401.25));
    /// # Ok::<(), nanospectra::sensor::PixelWavelengthsError>(())
    /// ```
    #[must_use]
    pub const fn edge_nm(&self, pixel: usize) -> f32 {
        self.at(pixel as f32 - 0.5)
    }

    const fn at(&self, pixel: f32) -> f32 {
        let p = match self.first {
            FirstPixel::Zero => pixel,
            FirstPixel::One => pixel + 1.0,
        };
        let (mut nm, mut k) = (0.0, K);
        while k > 0 {
            k -= 1;
            nm = nm * p + self.coefficients[k];
        }
        nm
    }
}

/// Subtracts the mean of the masked pixels, which lie in the dark beside the others, from every count.
///
/// `None` if the range is empty or goes beyond the last pixel. The same number is subtracted from every
/// pixel; a dark level that differs from pixel to pixel needs a dark frame
/// ([`Exposure::basic_counts_above`](crate::sensor::Exposure::basic_counts_above)).
///
/// ```
/// # use nanospectra::sensor::above_dark_pixels;
/// let counts: [u16; 6] = [10, 12, 11, 511, 1011, 211];
/// assert_eq!(above_dark_pixels(&counts, 0..3), Some([-1.0, 1.0, 0.0, 500.0, 1000.0, 200.0]));
/// assert_eq!(above_dark_pixels(&counts, 4..9), None);
/// ```
#[must_use]
pub fn above_dark_pixels<T: Count, const P: usize>(
    counts: &[T; P],
    masked: Range<usize>,
) -> Option<[f32; P]> {
    let dark = counts.get(masked).filter(|dark| !dark.is_empty())?;
    // The mean of deviations from the first pixel is exact for equal counts, and rounds little for others.
    let reference = dark.first()?.to_f32();
    let deviations = dark.iter().fold(0.0, |sum, count| sum + (count.to_f32() - reference));
    let level = reference + deviations / dark.len() as f32;
    Some(counts.map(|count| count.to_f32() - level))
}

/// Why a polynomial was refused, which is that its wavelengths do not rise from pixel to pixel.
///
/// ```
/// # use nanospectra::sensor::{FirstPixel, PixelWavelengths, PixelWavelengthsError};
/// // A mistyped exponent, -3.23e-2 for -3.23e-4: the wavelengths fall from pixel 42 on.
/// let unit = PixelWavelengths::<288, 3>::new([310.0, 2.68, -3.23e-2], FirstPixel::Zero);
/// assert_eq!(unit, Err(PixelWavelengthsError { pixel: 42 }));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PixelWavelengthsError {
    /// The first pixel, counted from 0, that does not end above its start.
    pub pixel: usize,
}

impl PixelWavelengthsError {
    /// Returns the reason without its numbers, for [`const_unwrap!`](crate::const_unwrap).
    #[must_use]
    pub const fn message(&self) -> &'static str {
        "the wavelengths of pixels do not rise: check the coefficients, their exponents and their order"
    }
}

impl fmt::Display for PixelWavelengthsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} (pixel {})", self.message(), self.pixel)
    }
}

impl core::error::Error for PixelWavelengthsError {}
