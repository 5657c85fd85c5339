//! The part of a spectrum that an observer sees, and the part that it does not see.

#[cfg(feature = "libm")]
use crate::color::Xyz;
use crate::color::matrix::{Matrix64, inverse64};
#[cfg(feature = "libm")]
use crate::grid::Bands;
use crate::grid::{Bins, Grid};
use crate::math::const_for;
use crate::observer::Observer;
use crate::spectrum::{Factor, Quantity, Spectrum};

/// Cohen's matrix R of an observer with three channels, which splits a spectrum into a part that the observer
/// sees and a part that it does not see.
///
/// The two parts are called the [fundamental](Self::fundamental) and the [metameric black](Self::black). Two
/// spectra are metamers if their fundamentals are the same: a metameric black can be added in any amount.
///
/// # Example
/// ```
/// use nanospectra::{Light, Observer, Power, Curve, light, observer::CIE_1931, upsample::CohenR};
/// use nanospectra::Nodes;
/// type Lamp = Light<81, Nodes<380, 780>>;
/// static EYE: Observer<3, 81, Power, Nodes<380, 780>> = CIE_1931.fold(Curve::Step);
/// static R: CohenR<81, Power, Nodes<380, 780>> = CohenR::new(&EYE);
/// let (lamp, smooth): (Lamp, Lamp) = (light::FL11, R.fundamental(&light::FL11));
/// let ([x, y, z], same) = (EYE.sees(&lamp), EYE.sees(&smooth));
/// assert!((same[0] / x - 1.0).abs() < 1e-5 && (same[1] / y - 1.0).abs() < 1e-5);
/// let [_, unseen, _] = EYE.sees(&R.black(&lamp));
/// assert!(unseen.abs() < 1e-5 * y);
/// # let _ = z;
/// ```
///
/// # Accuracy
/// Of the metameric black the observer sees in each channel at most 1e-6 of the largest of the three numbers
/// that it sees of the spectrum (searched in `tests/upsample/worst_reflectances.rs`).
///
/// # Reference
/// J. B. Cohen, W. E. Kappauf, "Metameric color stimuli, fundamental metamers, and Wyszecki's metameric
/// blacks", Am. J. Psychology 95 (1982).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CohenR<const N: usize, Q = Factor, G = Bins<380, 730>> {
    eye: Observer<3, N, Q, G>,
    /// An observer whose readings are the amounts of the rows of `eye` in the fundamental.
    dual: Observer<3, N, Q, G>,
}

impl<const N: usize, Q: Quantity, G: Grid> CohenR<N, Q, G> {
    /// Computes the matrix R of this observer, in f64; for `const` use. See the [example](#example).
    ///
    /// The three rows of the observer have to be independent, which takes three bands at least; otherwise the
    /// result has no meaning.
    ///
    /// # Cost
    /// On a Cortex-M4F 31 bands take 1,600 bytes of stack at opt-level 3 and at "s".
    #[must_use]
    pub const fn new(eye: &Observer<3, N, Q, G>) -> Self {
        let rows = eye.weights();
        let mut gram: Matrix64 = [[0.0; 3]; 3];
        const_for!(0..3, |i| {
            const_for!(0..3, |j| {
                const_for!(0..N, |n| gram[i][j] += rows[i][n] as f64 * rows[j][n] as f64);
            });
        });
        let inverse = inverse64(&gram);
        let mut dual = [[0.0; N]; 3];
        const_for!(0..3, |i| {
            const_for!(0..N, |n| {
                let (x, y, z) = (rows[0][n] as f64, rows[1][n] as f64, rows[2][n] as f64);
                dual[i][n] = (inverse[i][0] * x + inverse[i][1] * y + inverse[i][2] * z) as f32;
            });
        });
        CohenR { eye: *eye, dual: Observer::from_weights(dual) }
    }

    /// Returns the part of a spectrum that the observer sees, which is the metamer with the smallest sum of
    /// squares.
    ///
    /// It may be below zero at some wavelengths. See the [example](#example).
    #[must_use]
    pub fn fundamental(&self, spectrum: &Spectrum<Q, N, G>) -> Spectrum<Q, N, G> {
        let [a, b, c] = self.dual.sees(spectrum);
        let [x, y, z] = self.eye.weights();
        let mut values = [0.0; N];
        for (value, (x, (y, z))) in values.iter_mut().zip(x.iter().zip(y.iter().zip(z))) {
            *value = a * x + b * y + c * z;
        }
        Spectrum::from_bins(values)
    }

    /// Returns the part of a spectrum that the observer does not see. See the [example](#example).
    #[must_use]
    pub fn black(&self, spectrum: &Spectrum<Q, N, G>) -> Spectrum<Q, N, G> {
        *spectrum - self.fundamental(spectrum)
    }
}

#[cfg(feature = "libm")]
impl<const N: usize, G: Bands> Observer<3, N, Factor, G> {
    /// Returns the color difference CIEDE2000 between two surfaces, as this observer sees them under the
    /// light that is folded into it.
    ///
    /// It says how much two surfaces that match under one lamp differ under another one. For such surfaces it
    /// is the special metamerism index of CIE 15 for a change of illuminant (for which CIE 15 takes CIE 1976
    /// differences unless another formula is stated). The result is NaN if the light is not visible.
    #[must_use]
    pub fn delta_e(&self, one: &Spectrum<Factor, N, G>, other: &Spectrum<Factor, N, G>) -> f32 {
        let white = Xyz::from(self.sees(&Spectrum::flat(1.0)));
        Xyz::from(self.sees(one)).delta_e(Xyz::from(self.sees(other)), white)
    }
}
