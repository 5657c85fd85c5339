//! How the refractive index of glasses depends on wavelength.

use crate::grid::Grid;
use crate::math::sqrt;
use crate::spectrum::{RefractiveIndex, Spectrum};

/// A formula for the refractive index of a transparent medium.
pub trait Glass {
    /// The refractive index at `nm` (in air, as makers measure it); `None` where the formula gives none,
    /// beside a resonance, and for no wavelength.
    fn index(&self, nm: f32) -> Option<f32>;

    /// The index at the center of each bin; `None` if one of them has none.
    fn indices<const N: usize, G: Grid>(&self) -> Option<Spectrum<RefractiveIndex, N, G>> {
        let mut indices = Spectrum::from_bins([0.0; N]);
        for (k, index) in indices.values_mut().iter_mut().enumerate() {
            *index = self.index(Spectrum::<RefractiveIndex, N, G>::center_nm(k))?;
        }
        Some(indices)
    }

    /// Abbe's number (n_d - 1) / (n_F - n_C): large for a glass that disperses little; `None` for one that
    /// does not disperse or has no index at one of these lines.
    ///
    /// # Accuracy
    /// 1e-5 relative for glasses of numbers up to 70: the difference of two indices in f32.
    ///
    /// ```
    /// # use nanospectra::matter::{Glass, N_BK7};
    /// assert!(N_BK7.abbe_number().is_some_and(|v| (v - 64.17).abs() < 0.01)); // the maker's data sheet
    /// ```
    fn abbe_number(&self) -> Option<f32> {
        // The helium line d, hydrogen's F and C.
        let [d, f, c] = [587.5618, 486.1327, 656.2725].map(|nm| self.index(nm));
        let number = (d? - 1.0) / (f? - c?);
        number.is_finite().then_some(number)
    }
}

/// Sellmeier's formula: n^2 = 1 + sum of `b` l^2 / (l^2 - `c`), with l in um and `c` in um^2.
///
/// Outside the range that a glass quotes an index is only what the formula gives: at a resonance anything
/// above 0.
///
/// # Accuracy
/// 1.2e-7 relative within the quoted ranges from 380 to 1000 nm; towards a resonance it loses all digits.
///
/// ```
/// # use nanospectra::matter::{Glass, N_BK7};
/// assert!(N_BK7.index(587.5618).is_some_and(|n| (n - 1.516_80).abs() < 1e-5));
/// assert_eq!(N_BK7.index(75.0), None); // beside its first resonance, in the far ultraviolet
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sellmeier {
    /// The strengths of three resonances.
    pub b: [f32; 3],
    /// The squares of their wavelengths, um^2.
    pub c: [f32; 3],
}

/// Schott's borosilicate crown glass N-BK7: n_d 1.51680, Abbe's number 64.17.
///
/// # Reference
/// Schott, optical glass data sheets; 310 to 2325 nm.
pub const N_BK7: Sellmeier = Sellmeier {
    b: [1.039_612_12, 0.231_792_344, 1.010_469_45],
    c: [0.006_000_698_67, 0.020_017_914_4, 103.560_653],
};

/// Schott's dense flint glass N-SF11: n_d 1.78472, Abbe's number 25.68.
///
/// # Reference
/// Schott, optical glass data sheets; 370 to 2500 nm.
pub const N_SF11: Sellmeier = Sellmeier {
    b: [1.737_596_95, 0.313_747_346, 1.898_781_01],
    c: [0.013_188_707, 0.062_306_814_2, 155.236_29],
};

/// Fused silica: n_d 1.45846, Abbe's number 67.8.
///
/// # Reference
/// I. H. Malitson, J. Opt. Soc. Am. 55 (1965); 210 to 3710 nm.
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

/// Cauchy's formula: n = a + b / l^2 + c / l^4, with l in um: for the visible range.
///
/// ```
/// # use nanospectra::matter::{Cauchy, Glass};
/// let crown = Cauchy { a: 1.5046, b: 0.0042, c: 0.0 };
/// assert!(crown.index(589.3).is_some_and(|n| (n - 1.51669).abs() < 1e-5));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cauchy {
    /// The index towards long waves.
    pub a: f32,
    /// um^2.
    pub b: f32,
    /// um^4.
    pub c: f32,
}

impl Glass for Cauchy {
    fn index(&self, nm: f32) -> Option<f32> {
        let inverse = 1e6 / (nm * nm);
        let index = self.a + inverse * (self.b + inverse * self.c);
        if nm > 0.0 && (index <= 0.0 || !index.is_finite()) || nm <= 0.0 { None } else { Some(index) }
    }
}
