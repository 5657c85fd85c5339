//! The type of all spectra: `N` numbers, the quantity that they mean, and the grid on which they lie.

use crate::grid::{Bands, Bins, Grid, Layout, Nodes};
use crate::spectrum::{Factor, PerBin, Power};
use core::marker::PhantomData;

/// A spectrum of `N` numbers, each of which is the *average* of the quantity `Q` over one of the `N` equal
/// bins that the grid `G` is divided into.
///
/// Make one from measurements by [`from_samples`](Self::from_samples), from numbers that already belong to
/// the bins by [`from_bins`](Self::from_bins), or take a table of [`light`](crate::light) or
/// [`matter`](crate::matter). Then an [`Observer`](crate::Observer) turns it into XYZ or into the counts of a
/// sensor. [`Light`] and [`Reflectance`] are the usual short names of this type, and [`Fine`] that of its 1
/// nm form.
///
/// # Example
/// ```
/// # use nanospectra::Light;
/// let lamp = [(400.0, 1.0), (500.0, 3.0), (700.0, 1.0)]; // nm, power for each nm
/// let light = Light::<16>::from_samples(&lamp)?;
/// // The area under the three points: 100 * 2 + 200 * 2.
/// assert!((light.power() - 600.0).abs() < 1e-3);
/// # Ok::<(), nanospectra::SamplesError>(())
/// ```
///
/// # Averages, not points
/// Because the numbers are averages, the power of a light is their sum times the width of a bin, a constant
/// stays exactly that constant, and a laser line keeps its power at every `N`. Point samples would lose what
/// lies between them: 31 points over 400..700 nm are up to 7 CIEDE2000 off under fluorescent lamps. On a 1 nm
/// grid of whole nanometers, as CIE tables have, the numbers are the table's point values. Only spectra of
/// [`PerBin`] hold totals.
///
/// A spectrum takes `N * 4` bytes. It is `Copy`, but pass it by reference.
///
/// # Operators
/// Operators work bin by bin, on values and on references, and have assigning forms. Spectra of one kind can
/// be added, subtracted, negated and summed; they can be multiplied and divided by numbers and by spectra of
/// factors; a light divided by a light is a spectrum of factors. Division by zero gives infinity or NaN, as
/// in f32 (the quantities of [`radiometry`](crate::radiometry) stay finite). `spectrum[k]` is the value of
/// bin `k` and panics beyond the last bin.
///
/// ```
/// # use nanospectra::{Light, Reflectance};
/// let (lamp, glass) = (Light::<16>::flat(2.0), Reflectance::<16>::flat(0.5));
/// let mut both = &lamp + 0.5 * lamp - lamp / 4.0; // 2 + 1 - 0.5
/// both *= &glass;
/// assert_eq!((both, both / lamp, both[15]), (glass * Light::flat(2.5), Reflectance::flat(0.625), 1.25));
/// assert_eq!([lamp, -both].iter().sum::<Light<16>>(), Light::flat(0.75));
/// ```
#[repr(transparent)]
pub struct Spectrum<Q, const N: usize, G = Bins<380, 730>>(pub(crate) [f32; N], PhantomData<(Q, G)>);

/// A spectrum of light, which holds power for each nanometer. See the [example](Spectrum#example).
pub type Light<const N: usize, G = Bins<380, 730>> = Spectrum<Power, N, G>;

/// A spectrum of matter that reflects or transmits light, which holds factors of 0..=1 for passive matter.
/// See the [example](Spectrum#operators) of operators.
pub type Reflectance<const N: usize, G = Bins<380, 730>> = Spectrum<Factor, N, G>;

/// A spectrum that holds point values at 360, 361, .. 830 nm, the grid on which the CIE's sums are defined.
/// See the [example](Spectrum::fine) of `fine`.
pub type Fine<Q> = Spectrum<Q, 471, Nodes<360, 830>>;

impl<Q, const N: usize, G> Clone for Spectrum<Q, N, G> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<Q, const N: usize, G> Copy for Spectrum<Q, N, G> {}

impl<Q, const N: usize, G> PartialEq for Spectrum<Q, N, G> {
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0
    }
}

impl<Q, const N: usize, G> core::fmt::Debug for Spectrum<Q, N, G> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_tuple("Spectrum").field(&self.0).finish()
    }
}

#[cfg(feature = "defmt")]
impl<Q, const N: usize, G> defmt::Format for Spectrum<Q, N, G> {
    fn format(&self, fmt: defmt::Formatter<'_>) {
        defmt::write!(fmt, "Spectrum({})", self.0.as_slice());
    }
}

impl<Q, const N: usize, G> Spectrum<Q, N, G> {
    /// Makes a spectrum in bands that are known to be `N`.
    #[inline]
    pub(crate) const fn unchecked(values: [f32; N]) -> Self {
        Spectrum(values, PhantomData)
    }
}

impl<Q, const N: usize, G: Bands> Spectrum<Q, N, G> {
    /// Makes a spectrum from numbers that already belong to its bands: averages over the bins, such as pixels
    /// of an instrument or a table on this very grid, or red, green and blue.
    ///
    /// The grid is not inferred from the numbers, so write it down, as in `Light::<16>::from_bins(..)`.
    ///
    /// ```
    /// # use nanospectra::{Bins, Light};
    /// let light = Light::<3, Bins<400, 700>>::from_bins([1.0, 2.0, 3.0]);
    /// assert_eq!(light.iter().last(), Some((650.0, 3.0)));
    /// ```
    #[must_use]
    #[inline]
    pub const fn from_bins(values: [f32; N]) -> Self {
        let () = Layout::<G, N>::CHECKED;
        Spectrum(values, PhantomData)
    }

    /// Returns a spectrum that has the same value in every bin, such as an equal-energy light or a gray
    /// filter.
    ///
    /// ```
    /// # use nanospectra::Reflectance;
    /// assert_eq!(Reflectance::<16>::flat(0.5).values(), &[0.5; 16]);
    /// ```
    #[must_use]
    #[inline]
    pub const fn flat(value: f32) -> Self {
        Self::from_bins([value; N])
    }

    /// Returns the value of each bin. See the [example](Self::flat) of `flat`.
    #[must_use]
    #[inline]
    pub const fn values(&self) -> &[f32; N] {
        &self.0
    }

    /// Returns the value of each bin, to be written to.
    #[must_use]
    #[inline]
    pub const fn values_mut(&mut self) -> &mut [f32; N] {
        &mut self.0
    }

    /// Returns the largest value of all bins, or NaN if one of them is NaN.
    ///
    /// ```
    /// # use nanospectra::{Bins, Light};
    /// assert_eq!(Light::<3, Bins<400, 700>>::from_bins([1.0, 4.0, 2.0]).peak(), 4.0);
    /// ```
    #[must_use]
    pub fn peak(&self) -> f32 {
        self.0.iter().fold(f32::NEG_INFINITY, |peak, v| if *v <= peak || peak.is_nan() { peak } else { *v })
    }
}

impl<Q, const N: usize, G: Grid> Spectrum<Q, N, G> {
    /// How wide each bin is, in nm. See the [example](crate::Bins#example).
    pub const WIDTH_NM: f32 = Layout::<G, N>::STEP;
}

/// Functions of wavelengths. (Each has its own bound `G: Grid`, so that the compiler can say why red, green
/// and blue have none of them.)
impl<Q, const N: usize, G: Bands> Spectrum<Q, N, G> {
    /// Makes a spectrum from a function of the wavelength in nm, read at the center of each bin.
    ///
    /// This suits grids of 1 nm; for wider bins use [`averaged`](Self::averaged).
    ///
    /// ```
    /// # use nanospectra::{Fine, Power};
    /// let ramp = Fine::<Power>::at_centers(|nm| nm / 830.0);
    /// assert_eq!(ramp.values()[470], 1.0);
    /// ```
    #[must_use]
    pub fn at_centers(mut value: impl FnMut(f32) -> f32) -> Self
    where
        G: Grid,
    {
        let mut values = [0.0; N];
        for (k, v) in values.iter_mut().enumerate() {
            *v = value(Self::center_nm(k));
        }
        Self::from_bins(values)
    }

    /// Makes a spectrum from a smooth function of the wavelength in nm, averaged over each bin.
    ///
    /// Three Gauss points in each bin make the average exact for polynomials up to the fifth degree. 16 bins
    /// of a black body are good to 3e-7 at 2856 K and to 5e-6 at 1000 K.
    ///
    /// ```
    /// # use nanospectra::{Bins, Light};
    /// let parabola = Light::<1, Bins<400, 700>>::averaged(|nm| nm * nm);
    /// // (700^3 - 400^3) / 3 / 300
    /// assert!((parabola.values()[0] - 310_000.0).abs() < 1.0);
    /// ```
    #[must_use]
    pub fn averaged(mut value: impl FnMut(f32) -> f32) -> Self
    where
        G: Grid,
    {
        // The outer points lie sqrt(3/5) of half a bin from the center; the weights are 5/18, 4/9 and 5/18.
        let outer = 0.387_298_33 * Self::WIDTH_NM;
        Self::at_centers(|nm| {
            let middle = value(nm);
            let sides = (value(nm - outer) - middle) + (value(nm + outer) - middle);
            middle + sides * (5.0 / 18.0)
        })
    }

    /// Returns the lower edge of bin `k` in nm, or the upper end of the grid for `k = N`. See the
    /// [example](crate::Bins#example).
    #[must_use]
    pub const fn edge_nm(k: usize) -> f32
    where
        G: Grid,
    {
        Layout::<G, N>::edge(k)
    }

    /// Returns the center of bin `k`, in nm. See the [example](crate::Bins#example).
    #[must_use]
    pub const fn center_nm(k: usize) -> f32
    where
        G: Grid,
    {
        Layout::<G, N>::center(k)
    }

    /// Returns this spectrum with zero in all bins whose centers lie outside `from_nm..=to_nm`.
    ///
    /// ```
    /// # use nanospectra::{Bins, Light};
    /// let light = Light::<3, Bins<400, 700>>::flat(1.0); // centers at 450, 550 and 650 nm
    /// assert_eq!(light.within(500.0, 600.0).values(), &[0.0, 1.0, 0.0]);
    /// ```
    #[must_use]
    pub const fn within(&self, from_nm: f32, to_nm: f32) -> Self
    where
        G: Grid,
    {
        let mut values = self.0;
        let mut k = 0;
        while k < N {
            let nm = Self::center_nm(k);
            if nm < from_nm || nm > to_nm {
                values[k] = 0.0;
            }
            k += 1;
        }
        Self::from_bins(values)
    }

    /// Returns an iterator over pairs of (center of the bin in nm, value).
    ///
    /// ```
    /// # use nanospectra::{Bins, Light};
    /// let light = Light::<3, Bins<400, 700>>::flat(0.5);
    /// assert!(light.iter().eq([(450.0, 0.5), (550.0, 0.5), (650.0, 0.5)]));
    /// ```
    pub fn iter(&self) -> impl ExactSizeIterator<Item = (f32, f32)> + '_
    where
        G: Grid,
    {
        self.0.iter().enumerate().map(|(k, value)| (Self::center_nm(k), *value))
    }
}

impl<const N: usize, G: Bands> Spectrum<Power, N, G> {
    /// Returns all the power on the grid, which is the sum of the bins times their width.
    ///
    /// It is in W for a spectrum in W/nm. See the [example](Spectrum#example).
    ///
    /// # Accuracy
    /// 4 units of 2^-24, relative, for positive values.
    #[must_use]
    pub fn power(&self) -> f32
    where
        G: Grid,
    {
        crate::sum::sum(&self.0) * Self::WIDTH_NM
    }
}

impl<const N: usize, G: Grid> Spectrum<PerBin, N, G> {
    /// Returns the sum of what all bins hold. See the [example](Self::density) of `density`.
    ///
    /// # Accuracy
    /// 4 units of 2^-24, relative, for positive values.
    #[must_use]
    pub fn total(&self) -> f32 {
        crate::sum::sum(&self.0)
    }

    /// Converts totals to a density: divides what each bin holds by its width, which gives power for each
    /// nanometer.
    ///
    /// ```
    /// # use nanospectra::{Bins, PerBin, Spectrum};
    /// // 60 counts in each of 30 bins 10 nm wide.
    /// let counts = Spectrum::<PerBin, 30, Bins<400, 700>>::from_bins([60.0; 30]);
    /// assert_eq!((counts.total(), counts.density().values()[0]), (1800.0, 6.0));
    /// assert_eq!(counts.density().power(), 1800.0);
    /// ```
    #[must_use]
    pub const fn density(&self) -> Light<N, G> {
        let mut values = self.0;
        let mut k = 0;
        while k < N {
            values[k] /= Self::WIDTH_NM;
            k += 1;
        }
        Spectrum::from_bins(values)
    }
}
