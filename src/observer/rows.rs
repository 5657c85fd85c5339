//! The type of all observers: `C` rows of `N` weights, one row for each number that an observer reports.

use crate::grid::{Bands, Bins, Grid, Layout, Nodes, by_fields};
use crate::math::const_for;
use crate::observer::Stimulus;
use crate::spectrum::{Factor, Power, Quantity, Spectrum};
use crate::sum;
use core::marker::PhantomData;

/// An eye, a set of cones or a sensor: it looks at a spectrum of `N` numbers and reports `C` numbers, such as
/// X, Y and Z or the counts of `C` channels.
///
/// Call [`sees`](Self::sees) with a spectrum to get these numbers. The CIE's standard observers are statics
/// of [`observer`](crate::observer), such as [`CIE_1931`](crate::observer::CIE_1931); a sensor is made by
/// [`from_rows`](Self::from_rows) from its responsivities.
///
/// # Example
/// ```
/// use nanospectra::{Curve, Observer, Reflectance, light::FL11, observer::CIE_1931};
///
/// // X, Y and Z of a lamp, from its spectrum at every nanometer.
/// let [x, y, z] = CIE_1931.sees(&FL11.fine());
/// // CIE 15 has x = 0.3805, y = 0.3769, from sums at 5 nm. Straight lines to 1 nm put y at 0.3771.
/// assert!((x / (x + y + z) - 0.3805).abs() < 5e-5 && (y / (x + y + z) - 0.3771).abs() < 5e-5);
///
/// // An observer of surfaces under that lamp, which reads 16 numbers of each. The compiler makes it.
/// static EYE: Observer<3, 16> = CIE_1931
///     .under(&FL11.fine())
///     .fold(Curve::Spline)
///     .with_white_y(100.0);
///
/// // White paper has the color of the lamp, and Y = 100.
/// let [x16, y16, z16] = EYE.sees(&Reflectance::flat(1.0));
/// assert!((y16 - 100.0).abs() < 1e-4);
/// assert!((x16 / (x16 + y16 + z16) - x / (x + y + z)).abs() < 1e-6);
/// ```
///
/// # Observers of observers
/// What an observer reports is linear in the light, so an observer behind a filter or in front of a surface
/// is an observer too. [`through`](Self::through), [`looking_at`](Self::looking_at), [`under`](Self::under)
/// and [`mixed`](Self::mixed) return such observers, and [`fold`](Self::fold) reduces one from 1 nm to a few
/// bins. All of them are `const fn`: in a `static` the compiler does this work, the program keeps `C * N * 4`
/// bytes, and the 1 nm tables stay out of its image.
///
/// `Q` is the quantity that the observer reads: light ([`Power`]), or, once a light is included by `under`,
/// the reflectance of what that light falls on ([`Factor`]).
#[repr(transparent)]
pub struct Observer<const C: usize, const N: usize, Q = Factor, G = Bins<380, 730>>(
    pub(crate) [[f32; N]; C],
    PhantomData<(Q, G)>,
);

/// An observer that reads spectra at 1 nm on the CIE's own grid, 360..=830 nm. See the
/// [example](Observer#example).
pub type FineObserver<const C: usize, Q = Power> = Observer<C, 471, Q, Nodes<360, 830>>;

by_fields!([const C: usize, const N: usize, Q, G] Observer<C, N, Q, G>, "Observer": 0);

impl<const C: usize, const N: usize, Q, G> Observer<C, N, Q, G> {
    /// Returns what this observer reports of a spectrum, or of light on its way along a [path](crate::path).
    ///
    /// For each channel it is the sum of weight times value over all bins. Pass a spectrum by reference. See
    /// the [example](Observer#example).
    ///
    /// # Accuracy
    /// Within 4 units of 2^-24 of the sum of the terms' absolute values, in up to 471 bins; the result has
    /// the same bits on every target.
    ///
    /// # Cost
    /// `C * N` multiplications and additions. 16 bands to XYZ take 162 instructions on a Cortex-M4F (253 at
    /// opt-level "s").
    #[must_use]
    #[inline]
    pub fn sees<S: Stimulus<Q, N, G>>(&self, stimulus: S) -> [f32; C] {
        stimulus.read(|spectrum| sum::rows(&self.0, &spectrum.0))
    }

    /// Writes what this observer reports of each of many spectra to `reports`.
    ///
    /// The results have the same bits as those of [`sees`](Self::sees). As many spectra are read as the
    /// shorter of the two slices has.
    ///
    /// ```
    /// use nanospectra::{Light, observer::CIE_1931};
    ///
    /// let lamps = [nanospectra::light::A.fine(), nanospectra::light::D65.fine()];
    /// let mut reports = [[0.0; 3]; 2];
    /// CIE_1931.sees_each(&lamps, &mut reports);
    /// assert_eq!(reports[1], CIE_1931.sees(&lamps[1]));
    /// ```
    pub fn sees_each(&self, spectra: &[Spectrum<Q, N, G>], reports: &mut [[f32; C]]) {
        sum::each(&self.0, spectra, |spectrum| &spectrum.0, reports);
    }

    /// Returns this observer behind a filter, a window or a diffuser, whose transmittance is `filter`.
    ///
    /// ```
    /// use nanospectra::{Light, Observer, Power, Reflectance};
    ///
    /// let meter = Observer::<1, 16, Power>::from_weights([[1.0; 16]]);
    /// let glass = Reflectance::flat(0.5);
    /// let lamp = Light::flat(2.0);
    /// assert_eq!(meter.through(&glass).sees(&lamp), [16.0]); // 16 bins of 2, half of it
    /// ```
    #[must_use]
    pub const fn through(&self, filter: &Spectrum<Factor, N, G>) -> Self {
        self.times(&filter.0)
    }

    /// Returns this observer turned to a surface of reflectance `surface`. It then reads the light that falls
    /// on the surface.
    ///
    /// ```
    /// use nanospectra::{Light, Observer, Power, Reflectance};
    ///
    /// let meter = Observer::<1, 16, Power>::from_weights([[1.0; 16]]);
    /// let (paper, lamp) = (Reflectance::flat(0.75), Light::flat(2.0));
    /// // Seeing the light that leaves the paper is the same as turning to the paper and seeing the lamp.
    /// assert_eq!(meter.sees(&(lamp * paper)), meter.looking_at(&paper).sees(&lamp));
    /// ```
    #[must_use]
    pub const fn looking_at(&self, surface: &Spectrum<Factor, N, G>) -> Self {
        self.through(surface)
    }

    /// Makes an observer from weights in bands that are known to be valid.
    pub(crate) const fn unchecked(weights: [[f32; N]; C]) -> Self {
        Observer(weights, PhantomData)
    }

    const fn times<R>(&self, factors: &[f32; N]) -> Observer<C, N, R, G> {
        let mut observer = Observer::unchecked(self.0);
        const_for!(0..C, |c| {
            const_for!(0..N, |n| observer.0[c][n] *= factors[n]);
        });
        observer
    }
}

impl<const C: usize, const N: usize, G> Observer<C, N, Power, G> {
    /// Returns this observer in a room lit by `light`. It then reads reflectances.
    ///
    /// Only an observer that reads power can be put under a light, so no light is applied twice. See the
    /// [example](Observer#example).
    #[must_use]
    pub const fn under(&self, light: &Spectrum<Power, N, G>) -> Observer<C, N, Factor, G> {
        self.times(&light.0)
    }
}

impl<const N: usize, Q: Quantity, G: Bands> Observer<3, N, Q, G> {
    /// Returns this XYZ observer scaled so that the constant spectrum 1 has Y = `y`.
    ///
    /// After [`under`](Observer::under) that spectrum is the perfect white surface, and for `y` = 100 the
    /// factor is k = 100 / sum(S y-bar) of CIE 15. An observer whose Y row sums to zero or less, because
    /// there is no visible light, is returned as it is. It computes in f64 and is meant for constants. See
    /// the [example](Observer#example).
    #[must_use]
    pub const fn with_white_y(&self, y: f64) -> Self {
        let white = self.row_sums()[1];
        if white > 0.0 { self.scaled(y / white) } else { *self }
    }
}

impl<const C: usize, const N: usize, Q: Quantity, G: Grid> Observer<C, N, Q, G> {
    /// Makes an observer from responsivities: what each channel reports for each nanometer of power 1, at the
    /// bins of the grid.
    ///
    /// On a 1 nm grid the rows are a table as published; an eight-channel sensor that is tabulated from 300
    /// to 1000 nm is an `Observer<8, 701, Power, Nodes<300, 1000>>`. On a wider grid they are averages over
    /// the bins. This function multiplies them by the width of the bins.
    ///
    /// ```
    /// use nanospectra::{Bins, Light, Observer, Power};
    ///
    /// // Two channels: one sees all of 400..=700 nm, the other its upper third.
    /// type Grid = Bins<400, 700>;
    /// let sensor = Observer::<2, 3, Power, Grid>::from_rows([[1.0, 1.0, 1.0], [0.0, 0.0, 0.5]]);
    /// // A light of 2 W/nm.
    /// assert_eq!(sensor.sees(&Light::flat(2.0)), [600.0, 100.0]);
    /// ```
    #[must_use]
    pub const fn from_rows(rows: [[f32; N]; C]) -> Self {
        let mut weights = rows;
        const_for!(0..C, |c| {
            const_for!(0..N, |k| weights[c][k] = rows[c][k] * Layout::<G, N>::STEP);
        });
        Self::from_weights(weights)
    }
}

impl<const C: usize, const N: usize, Q: Quantity, G: Bands> Observer<C, N, Q, G> {
    /// Makes an observer from weights as they are: the response of each channel to each bin of value 1.
    ///
    /// The width of the bins is not multiplied in; see [`from_rows`](Self::from_rows) for responsivities and
    /// the [example](Self::through) of `through`.
    #[must_use]
    pub const fn from_weights(weights: [[f32; N]; C]) -> Self {
        let () = Layout::<G, N>::CHECKED;
        Observer(weights, PhantomData)
    }

    /// Returns the weights of this observer: the response of each channel to each bin of value 1.
    #[must_use]
    pub const fn weights(&self) -> &[[f32; N]; C] {
        &self.0
    }

    /// Multiplies every weight by `k`, for example by [`KM`](crate::observer::KM) to get lm from W.
    ///
    /// This computes in f64 and is meant for constants, as [`mixed`](Self::mixed) and
    /// [`with_white_y`](Observer::with_white_y) are. See the [example](crate::observer::KM#example) of `KM`.
    #[must_use]
    pub const fn scaled(&self, k: f64) -> Self {
        let mut weights = self.0;
        const_for!(0..C, |c| {
            const_for!(0..N, |n| weights[c][n] = (weights[c][n] as f64 * k) as f32);
        });
        Self::from_weights(weights)
    }

    /// Returns an observer whose channels are mixtures of the channels of this one.
    ///
    /// Row `d` of `matrix` says how much of each old channel goes into the new channel `d`. This includes
    /// cross-talk, a conversion from XYZ to RGB or from counts to XYZ in the weights, where it costs nothing.
    /// It computes in f64 and is meant for constants.
    ///
    /// ```
    /// use nanospectra::{Light, Observer, Power};
    ///
    /// let two = Observer::<2, 4, Power>::from_weights([[1.0; 4], [0.5; 4]]);
    /// let sum_and_difference = two.mixed(&[[1.0, 1.0], [1.0, -1.0]]);
    /// assert_eq!(sum_and_difference.sees(&Light::flat(1.0)), [6.0, 2.0]);
    /// ```
    #[must_use]
    pub const fn mixed<const D: usize>(&self, matrix: &[[f32; C]; D]) -> Observer<D, N, Q, G> {
        let mut weights = [[0.0; N]; D];
        const_for!(0..D, |d| {
            const_for!(0..N, |n| {
                let mut sum = 0.0;
                const_for!(0..C, |c| sum += matrix[d][c] as f64 * self.0[c][n] as f64);
                weights[d][n] = sum as f32;
            });
        });
        Observer::from_weights(weights)
    }

    /// Returns the sum of each row, which is what this observer reports of the constant spectrum 1.
    ///
    /// This computes in f64 and is meant for constants.
    #[must_use]
    pub const fn row_sums(&self) -> [f64; C] {
        let mut sums = [0.0; C];
        const_for!(0..C, |c| {
            const_for!(0..N, |n| sums[c] += self.0[c][n] as f64);
        });
        sums
    }
}
