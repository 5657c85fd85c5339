//! An observer: C rows of N weights, one for each number it reports.

use crate::grid::{Bands, Bins, Grid, Layout, Nodes, by_fields};
use crate::math::const_for;
use crate::observer::Stimulus;
use crate::spectrum::{Factor, Power, Quantity, Spectrum};
use crate::sum;
use core::marker::PhantomData;

/// Anything that looks at a spectrum and reports `C` numbers: an eye (X, Y, Z), a set of cones,
/// a sensor with `C` channels.
///
/// A sensor looking at a surface is a sensor: [`through`](Self::through),
/// [`looking_at`](Self::looking_at) and [`under`](Self::under) give observers again, in `const
/// fn`, and [`fold`](Self::fold) brings the result from 1 nm to a few bins. What a program keeps is the
/// small result, `C * N * 4` bytes; the 1 nm tables stay out of its image.
///
/// `Q` is what it reads: light ([`Power`]), or, once a light is folded in with `under`, the
/// reflectance of what that light falls on ([`Factor`]).
///
/// ```
/// use nanospectra::{Curve, Observer, Reflectance, light::FL11, observer::CIE_1931};
///
/// static EYE: Observer<3, 16> = CIE_1931
///     .under(&FL11.fine())
///     .fold(Curve::Spline)
///     .with_white_y(100.0);
///
/// let [x, y, z] = EYE.sees(&Reflectance::flat(1.0));
/// // White paper under FL11 is the lamp itself: x = 0.3805, y = 0.3769 in CIE 15, which sums at
/// // 5 nm; straight lines to 1 nm put y at 0.3771.
/// assert!((x / (x + y + z) - 0.3805).abs() < 5e-5 && (y / (x + y + z) - 0.3771).abs() < 5e-5);
/// ```
#[repr(transparent)]
pub struct Observer<const C: usize, const N: usize, Q = Factor, G = Bins<380, 730>>(
    pub(crate) [[f32; N]; C],
    PhantomData<(Q, G)>,
);

/// An observer on the CIE's own grid, 360..=830 nm in steps of 1 nm.
pub type FineObserver<const C: usize, Q = Power> = Observer<C, 471, Q, Nodes<360, 830>>;

by_fields!([const C: usize, const N: usize, Q, G] Observer<C, N, Q, G>, "Observer": 0);

impl<const C: usize, const N: usize, Q: Quantity, G: Grid> Observer<C, N, Q, G> {
    /// From responsivities at the bins of the grid: what each channel reports for each nanometer
    /// of power 1.
    ///
    /// On a 1 nm grid the rows are a table as published (a sensor's own range is
    /// `Observer<8, 701, Power, Nodes<300, 1000>>`); on a wider grid they are averages over the bins, and
    /// the width of the bins is multiplied in here.
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
    /// From weights as they are: the response of each channel to each bin of value 1.
    #[must_use]
    pub const fn from_weights(weights: [[f32; N]; C]) -> Self {
        let () = Layout::<G, N>::CHECKED;
        Observer(weights, PhantomData)
    }

    /// The weights: the response of each channel to each bin of value 1.
    #[must_use]
    pub const fn weights(&self) -> &[[f32; N]; C] {
        &self.0
    }

    /// Every weight times `k`: from W to lm with [`KM`](crate::observer::KM), to another unit. Computes in
    /// f64: for `const` use, as [`mixed`](Self::mixed) and [`with_white_y`](Observer::with_white_y).
    #[must_use]
    pub const fn scaled(&self, k: f64) -> Self {
        let mut weights = self.0;
        const_for!(0..C, |c| {
            const_for!(0..N, |n| weights[c][n] = (weights[c][n] as f64 * k) as f32);
        });
        Self::from_weights(weights)
    }

    /// New channels as mixtures of these: row `d` of `matrix` says how much of each old channel
    /// goes into new channel `d`. Cross-talk, XYZ to RGB, counts to XYZ all fold in this way.
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

    /// The sum of each row, in f64: what a constant spectrum of value 1 reads. For `const` use.
    #[must_use]
    pub const fn row_sums(&self) -> [f64; C] {
        let mut sums = [0.0; C];
        const_for!(0..C, |c| {
            const_for!(0..N, |n| sums[c] += self.0[c][n] as f64);
        });
        sums
    }
}

impl<const C: usize, const N: usize, Q, G> Observer<C, N, Q, G> {
    /// What this observer reports of a spectrum, or of light on its way along a [path](crate::path): for each
    /// channel the sum of weight times value.
    ///
    /// # Accuracy
    /// 4 units of 2^-24 of the sum of the terms' sizes, in up to 471 bins, and the same bits on every target.
    ///
    /// # Cost
    /// `C * N` multiplications and additions; 16 bands to XYZ are 162 instructions on a Cortex-M4F (253 at
    /// opt-level "s").
    #[must_use]
    #[inline]
    pub fn sees<S: Stimulus<Q, N, G>>(&self, stimulus: S) -> [f32; C] {
        stimulus.read(|spectrum| sum::rows(&self.0, &spectrum.0))
    }

    /// What it reports of each spectrum of a batch; the same bits as [`sees`](Self::sees) one by one.
    ///
    /// The shorter of the two slices says how many.
    pub fn sees_each(&self, spectra: &[Spectrum<Q, N, G>], reports: &mut [[f32; C]]) {
        sum::each(&self.0, spectra, |spectrum| &spectrum.0, reports);
    }

    /// This observer behind a filter, a window, a diffuser: a transmittance in its path.
    #[must_use]
    pub const fn through(&self, filter: &Spectrum<Factor, N, G>) -> Self {
        Self::unchecked(self.times(&filter.0))
    }

    /// This observer turned to a surface: it then reads the light that falls there.
    #[must_use]
    pub const fn looking_at(&self, surface: &Spectrum<Factor, N, G>) -> Self {
        self.through(surface)
    }

    /// From weights on a grid that is known to be one, or that is none.
    pub(crate) const fn unchecked(weights: [[f32; N]; C]) -> Self {
        Observer(weights, PhantomData)
    }

    const fn times(&self, factors: &[f32; N]) -> [[f32; N]; C] {
        let mut weights = self.0;
        const_for!(0..C, |c| {
            const_for!(0..N, |n| weights[c][n] *= factors[n]);
        });
        weights
    }
}

impl<const C: usize, const N: usize, G> Observer<C, N, Power, G> {
    /// This observer in a room lit by `light`: it then reads reflectances.
    ///
    /// Only what reads power can be put under a light, so no light is applied twice.
    #[must_use]
    pub const fn under(&self, light: &Spectrum<Power, N, G>) -> Observer<C, N, Factor, G> {
        Observer::unchecked(self.times(&light.0))
    }
}

impl<const N: usize, Q: Quantity, G: Bands> Observer<3, N, Q, G> {
    /// An XYZ observer scaled so that the constant spectrum 1 has Y = `y`. After
    /// [`under`](Observer::under) that is the perfect white: k = 100 / sum(S y-bar) in CIE 15,
    /// for `y` = 100.
    ///
    /// An observer whose Y row sums to zero or less (no visible light) is returned as it is.
    #[must_use]
    pub const fn with_white_y(&self, y: f64) -> Self {
        let white = self.row_sums()[1];
        if white > 0.0 { self.scaled(y / white) } else { *self }
    }
}
