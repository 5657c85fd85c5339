//! Formulas for the refractive index of glasses, which depends on wavelength.

use crate::grid::Grid;
use crate::math::sqrt;
use crate::spectrum::{RefractiveIndex, Spectrum};

/// A formula that gives the refractive index of a transparent medium at each wavelength.
///
/// [`Sellmeier`] and [`Cauchy`] are such formulas, and [`N_BK7`], [`N_SF11`] and [`FUSED_SILICA`] glasses by
/// Sellmeier's. Call [`indices`](Self::indices) for the index in each bin of a spectrum, which
/// [`Dielectric`](crate::matter::Dielectric) takes.
///
/// # Example
///
/// ```
/// use nanospectra::matter::{FUSED_SILICA, Glass};
/// use nanospectra::{Nodes, RefractiveIndex, Spectrum};
/// // n_d of fused silica by Malitson's paper.
/// assert!(FUSED_SILICA.index(587.5618).is_some_and(|n| (n - 1.458_46).abs() < 1e-5));
/// // The indices at 400, 410, .. 700 nm fall with the wavelength.
/// let indices: Option<Spectrum<RefractiveIndex, 31, Nodes<400, 700>>> = FUSED_SILICA.indices();
/// assert!(indices.is_some_and(|n| n[0] > n[15] && n[15] > n[30]));
/// ```
pub trait Glass {
    /// Computes the refractive index at the wavelength `nm`, relative to air, as makers of glass measure it.
    ///
    /// The result is `None` where the formula gives no index, beside a resonance, and where `nm` is not above
    /// 0. See the [example](Glass#example).
    fn index(&self, nm: f32) -> Option<f32>;

    /// Computes the index at the center of each bin, or `None` if there is none in one of them. See the
    /// [example](Glass#example).
    fn indices<const N: usize, G: Grid>(&self) -> Option<Spectrum<RefractiveIndex, N, G>> {
        let mut indices = Spectrum::from_bins([0.0; N]);
        for (k, index) in indices.values_mut().iter_mut().enumerate() {
            *index = self.index(Spectrum::<RefractiveIndex, N, G>::center_nm(k))?;
        }
        Some(indices)
    }

    /// Computes Abbe's number (n_d - 1) / (n_F - n_C), which is large for a glass that disperses little.
    ///
    /// The result is `None` for a glass that does not disperse, or that has no index at one of these lines.
    ///
    /// # Accuracy
    /// 1e-5 relative for glasses of numbers up to 70, because of the difference of two indices in f32.
    ///
    /// # Example
    ///
    /// ```
    /// # use nanospectra::matter::{Glass, N_BK7};
    /// assert!(N_BK7.abbe_number().is_some_and(|v| (v - 64.17).abs() < 0.01)); // the maker's data sheet
    /// ```
    fn abbe_number(&self) -> Option<f32> {
        // The helium line d, and the hydrogen lines F and C.
        let [d, f, c] = [587.5618, 486.1327, 656.2725].map(|nm| self.index(nm));
        let number = (d? - 1.0) / (f? - c?);
        number.is_finite().then_some(number)
    }
}

/// Sellmeier's formula for the refractive index, which holds over a wide range of wavelengths.
///
/// n^2 = 1 + sum of `b` l^2 / (l^2 - `c`), where l is the wavelength in um and `c` is in um^2. Makers publish
/// the six coefficients of their glasses. Outside the range for which they are quoted the index means
/// nothing, and close to a resonance it can be any number above 0.
///
/// # Accuracy
/// 1.2e-7 relative within the quoted ranges from 380 to 1000 nm. Close to a resonance all digits are lost.
///
/// # Example
///
/// ```
/// # use nanospectra::matter::{Glass, N_BK7};
/// assert!(N_BK7.index(587.5618).is_some_and(|n| (n - 1.516_80).abs() < 1e-5));
/// assert_eq!(N_BK7.index(75.0), None); // beside its first resonance, in the far ultraviolet
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sellmeier {
    /// The strengths of the three resonances that the formula sums, without unit.
    pub b: [f32; 3],
    /// The squares of the wavelengths at which these resonances lie, in um^2.
    pub c: [f32; 3],
}

/// Schott's borosilicate crown glass N-BK7, which has n_d 1.51680 and Abbe's number 64.17.
///
/// See the [example](Sellmeier#example).
///
/// # Reference
/// Schott, optical glass data sheets; valid from 310 to 2325 nm.
pub const N_BK7: Sellmeier = Sellmeier {
    b: [1.039_612_12, 0.231_792_344, 1.010_469_45],
    c: [0.006_000_698_67, 0.020_017_914_4, 103.560_653],
};

/// Schott's dense flint glass N-SF11, which has n_d 1.78472 and Abbe's number 25.68.
///
/// # Reference
/// Schott, optical glass data sheets; valid from 370 to 2500 nm.
pub const N_SF11: Sellmeier = Sellmeier {
    b: [1.737_596_95, 0.313_747_346, 1.898_781_01],
    c: [0.013_188_707, 0.062_306_814_2, 155.236_29],
};

/// Fused silica (quartz glass), which has n_d 1.45846 and Abbe's number 67.8.
///
/// See the [example](Glass#example).
///
/// # Reference
/// I. H. Malitson, J. Opt. Soc. Am. 55 (1965); valid from 210 to 3710 nm.
pub const FUSED_SILICA: Sellmeier =
    Sellmeier { b: [0.696_166_3, 0.407_942_6, 0.897_479_4], c: [0.004_679_148_2, 0.013_512_063, 97.934_003] };

impl Glass for Sellmeier {
    fn index(&self, nm: f32) -> Option<f32> {
        if nm.is_nan() {
            return Some(nm);
        }
        let um2 = (nm * 1e-3) * (nm * 1e-3);
        let terms = self.b.iter().zip(&self.c).map(|(b, c)| b * (um2 / (um2 - c)));
        let square = 1.0 + terms.sum::<f32>();
        (nm > 0.0 && square > 0.0 && square < f32::INFINITY).then(|| sqrt(square))
    }
}

/// Cauchy's formula for the refractive index, which is meant for the visible range.
///
/// n = a + b / l^2 + c / l^4, where l is the wavelength in um.
///
/// # Example
///
/// ```
/// # use nanospectra::matter::{Cauchy, Glass};
/// let crown = Cauchy { a: 1.5046, b: 0.0042, c: 0.0 };
/// assert!(crown.index(589.3).is_some_and(|n| (n - 1.51669).abs() < 1e-5));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cauchy {
    /// The index that the formula approaches at long wavelengths. See the [example](#example).
    pub a: f32,
    /// The coefficient of 1 / l^2, which describes the dispersion, in um^2. See the [example](#example).
    pub b: f32,
    /// The coefficient of 1 / l^4, which is often left at 0, in um^4. See the [example](#example).
    pub c: f32,
}

impl Glass for Cauchy {
    fn index(&self, nm: f32) -> Option<f32> {
        let inverse = 1e6 / (nm * nm);
        let index = self.a + inverse * (self.b + inverse * self.c);
        if nm > 0.0 && (index <= 0.0 || !index.is_finite()) || nm <= 0.0 { None } else { Some(index) }
    }
}
