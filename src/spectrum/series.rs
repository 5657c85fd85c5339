//! The one type: N numbers, what they mean, and where they lie.

use crate::grid::{Bands, Bins, Grid, Layout, Nodes};
use crate::spectrum::{Factor, PerBin, Power};
use core::marker::PhantomData;

/// A spectrum: `N` equal bins that tile the grid `G`, each holding the *average* of the quantity
/// `Q` over its bin. (Only [`PerBin`] means totals.)
///
/// With averages power is the plain sum times the bin width, a constant stays exactly that
/// constant, and a laser line keeps its power at every `N`. (Point samples are the trap: 31
/// points over 400..700 nm are up to 7 CIEDE2000 off under fluorescent lamps.) On a 1 nm grid of
/// whole nanometers, as CIE tables are, the numbers are the table's point values.
///
/// `N * 4` bytes, nothing else; `Copy`, but pass it by reference.
///
/// # Operators
/// Bin by bin, by value, by reference and assigning: `+ -`, times and over numbers and factors, unary minus,
/// sums; a light over a light is a factor. Over zero a value becomes infinite, and zero NaN, as in f32 (the
/// quantities of [`radiometry`](crate::radiometry) stay finite). `spectrum[k]` is bin `k`, and panics beyond
/// the last.
///
/// ```
/// # use nanospectra::{Light, Reflectance};
/// let (lamp, glass) = (Light::<16>::flat(2.0), Reflectance::<16>::flat(0.5));
/// let mut both = &lamp + 0.5 * lamp - lamp / 4.0; // 2 + 1 - 0.5
/// both *= &glass;
/// assert_eq!((both, both / lamp, both[15]), (glass * Light::flat(2.5), Reflectance::flat(0.625), 1.25));
/// assert_eq!([lamp, -both].iter().sum::<Light<16>>(), Light::flat(0.75));
/// ```
///
/// ```
/// # use nanospectra::Light;
/// let lamp = [(400.0, 1.0), (500.0, 3.0), (700.0, 1.0)];
/// let light = Light::<16>::from_samples(&lamp)?;
/// // The area under the three points: 100 * 2 + 200 * 2.
/// assert!((light.power() - 600.0).abs() < 1e-3);
/// # Ok::<(), nanospectra::SamplesError>(())
/// ```
#[repr(transparent)]
pub struct Spectrum<Q, const N: usize, G = Bins<380, 730>>(pub(crate) [f32; N], PhantomData<(Q, G)>);

/// Power of light for each nanometer.
pub type Light<const N: usize, G = Bins<380, 730>> = Spectrum<Power, N, G>;

/// Reflectance, transmittance: a share 0..=1 of the light.
pub type Reflectance<const N: usize, G = Bins<380, 730>> = Spectrum<Factor, N, G>;

/// Point values at 360, 361, .. 830 nm: the grid on which CIE sums are defined.
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
    /// In bands that are known to be `N`.
    #[inline]
    pub(crate) const fn unchecked(values: [f32; N]) -> Self {
        Spectrum(values, PhantomData)
    }
}

impl<Q, const N: usize, G: Bands> Spectrum<Q, N, G> {
    /// From numbers that are already averages over the bins (pixels of an instrument, a table on this very
    /// grid), or red, green and blue.
    ///
    /// The grid is not inferred from the numbers: write `Light::<16>::from_bins(..)`.
    #[must_use]
    #[inline]
    pub const fn from_bins(values: [f32; N]) -> Self {
        let () = Layout::<G, N>::CHECKED;
        Spectrum(values, PhantomData)
    }

    /// The same value in every bin: an equal-energy light, a gray filter.
    #[must_use]
    #[inline]
    pub const fn flat(value: f32) -> Self {
        Self::from_bins([value; N])
    }

    /// The value of each bin.
    #[must_use]
    #[inline]
    pub const fn values(&self) -> &[f32; N] {
        &self.0
    }

    /// The value of each bin, to write to.
    #[must_use]
    #[inline]
    pub const fn values_mut(&mut self) -> &mut [f32; N] {
        &mut self.0
    }

    /// The largest value; NaN if there is one.
    #[must_use]
    pub fn peak(&self) -> f32 {
        self.0.iter().fold(f32::NEG_INFINITY, |peak, v| if *v <= peak || peak.is_nan() { peak } else { *v })
    }
}

impl<Q, const N: usize, G: Grid> Spectrum<Q, N, G> {
    /// Width of a bin, in nm.
    pub const WIDTH_NM: f32 = Layout::<G, N>::STEP;
}

/// What means wavelengths. (The bound is each function's own, so that red, green and blue are told why not.)
impl<Q, const N: usize, G: Bands> Spectrum<Q, N, G> {
    /// From a function of the wavelength in nm, read at the center of each bin: for 1 nm grids.
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

    /// From a smooth function of the wavelength in nm, averaged over each bin by three Gauss
    /// points: exact for quintics. 16 bins of a black body are good to 3e-7 at 2856 K, 5e-6 at 1000 K.
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
        // The outer points lie sqrt(3/5) of half a bin from the center; weights 5/18, 4/9, 5/18.
        let outer = 0.387_298_33 * Self::WIDTH_NM;
        Self::at_centers(|nm| {
            let middle = value(nm);
            let sides = (value(nm - outer) - middle) + (value(nm + outer) - middle);
            middle + sides * (5.0 / 18.0)
        })
    }

    /// The lower edge of bin `k` (or the upper end, for `k = N`), in nm.
    #[must_use]
    pub const fn edge_nm(k: usize) -> f32
    where
        G: Grid,
    {
        Layout::<G, N>::edge(k)
    }

    /// The center of bin `k`, in nm.
    #[must_use]
    pub const fn center_nm(k: usize) -> f32
    where
        G: Grid,
    {
        Layout::<G, N>::center(k)
    }

    /// This spectrum where the centers of its bins lie in `from_nm..=to_nm`, zero elsewhere.
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

    /// Pairs of (center of the bin in nm, value).
    pub fn iter(&self) -> impl ExactSizeIterator<Item = (f32, f32)> + '_
    where
        G: Grid,
    {
        self.0.iter().enumerate().map(|(k, value)| (Self::center_nm(k), *value))
    }
}

impl<const N: usize, G: Bands> Spectrum<Power, N, G> {
    /// All the power on the grid: the sum of the bins times their width. In W for W/nm.
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
    /// What all bins hold together.
    ///
    /// # Accuracy
    /// 4 units of 2^-24, relative, for positive values.
    #[must_use]
    pub fn total(&self) -> f32 {
        crate::sum::sum(&self.0)
    }

    /// For each nanometer: what a bin holds over its width.
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
