//! The shares of light that a film reflects, transmits and absorbs.

use crate::geometry::gauss_legendre::nodes_and_weights;
use crate::grid::Grid;
use crate::spectrum::{Factor, Spectrum};

static GAUSS: [(f32, f32); 3] = nodes_and_weights();

/// The shares of the incident power that a film or a slab reflects, transmits and absorbs; they sum to 1.
///
/// They are returned for s and p polarized light by [`ThinFilm::at`](crate::matter::ThinFilm::at) and
/// [`Stack::at`](crate::matter::Stack::at); [`mean`](Self::mean) makes one of both.
///
/// # Example
///
/// ```
/// # #[cfg(feature = "libm")] {
/// use nanospectra::matter::{PowerShares, ThinFilm};
/// // A quarter of a wave of MgF2 on a lens, for light at normal incidence.
/// let coating = ThinFilm::new([1.0, 1.38, 1.52], 550.0 / (4.0 * 1.38));
/// let shares = PowerShares::mean(coating.at(550.0, 1.0));
/// assert!((shares.reflected - 0.0126).abs() < 1e-5);
/// assert!((shares.transmitted - 0.9874).abs() < 1e-5);
/// assert_eq!(shares.absorbed, 0.0);
/// # }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PowerShares {
    /// The share of the power that is reflected, 0..=1. See the [example](#example).
    pub reflected: f32,
    /// The share of the power that is transmitted into the last medium, 0..=1. It is a share of power, so the
    /// ratio of the indices and cosines is included. See the [example](#example).
    pub transmitted: f32,
    /// The share of the power that the layers absorb, 0..=1. See the [example](#example).
    pub absorbed: f32,
}

impl PowerShares {
    pub(super) const MIRROR: Self = PowerShares { reflected: 1.0, transmitted: 0.0, absorbed: 0.0 };
    /// The shares where there is no film: all light goes on.
    pub(super) const NOTHING: Self = PowerShares { reflected: 0.0, transmitted: 1.0, absorbed: 0.0 };
    /// The shares of something that is not a film.
    pub(super) const NAN: Self =
        PowerShares { reflected: f32::NAN, transmitted: f32::NAN, absorbed: f32::NAN };

    /// Returns the mean of both polarizations, which holds for unpolarized light. See the
    /// [example](#example).
    #[must_use]
    pub fn mean([s, p]: [Self; 2]) -> Self {
        s.plus(p).times(0.5)
    }

    /// Clamps all shares to 0..=1, beyond which rounding may have gone.
    pub(super) fn held(self) -> Self {
        let PowerShares { reflected, transmitted, absorbed } = self;
        let held = |share: f32| share.clamp(0.0, 1.0);
        PowerShares { reflected: held(reflected), transmitted: held(transmitted), absorbed: held(absorbed) }
    }

    pub(super) fn plus(self, other: Self) -> Self {
        PowerShares {
            reflected: self.reflected + other.reflected,
            transmitted: self.transmitted + other.transmitted,
            absorbed: self.absorbed + other.absorbed,
        }
    }

    pub(super) fn times(self, k: f32) -> Self {
        PowerShares {
            reflected: self.reflected * k,
            transmitted: self.transmitted * k,
            absorbed: self.absorbed * k,
        }
    }

    /// The mean over a range of wavelengths, in `panels` equal pieces of three Gauss points each.
    pub(super) fn averaged(
        low_nm: f32,
        high_nm: f32,
        panels: u32,
        mut at: impl FnMut(f32) -> [Self; 2],
    ) -> [Self; 2] {
        const ZERO: PowerShares = PowerShares { reflected: 0.0, transmitted: 0.0, absorbed: 0.0 };
        let width = (high_nm - low_nm) / panels as f32;
        let [mut s, mut p] = [ZERO; 2];
        for panel in 0..panels {
            for (place, weight) in &GAUSS {
                let nm = low_nm + (panel as f32 + place) * width;
                let [at_s, at_p] = at(nm);
                (s, p) = (s.plus(at_s.times(*weight)), p.plus(at_p.times(*weight)));
            }
        }
        let mean = |sum: Self| sum.times(1.0 / panels as f32).held();
        [mean(s), mean(p)]
    }
}

/// A pair of spectra, for s and p polarized light, from a function of the two edges of each bin.
pub(super) fn bins<const N: usize, G: Grid>(
    mut between: impl FnMut(f32, f32) -> [f32; 2],
) -> [Spectrum<Factor, N, G>; 2] {
    let (mut s, mut p) = ([0.0; N], [0.0; N]);
    for (k, (s, p)) in s.iter_mut().zip(&mut p).enumerate() {
        let [low_nm, high_nm] = [k, k + 1].map(Spectrum::<Factor, N, G>::edge_nm);
        [*s, *p] = between(low_nm, high_nm);
    }
    [Spectrum::from_bins(s), Spectrum::from_bins(p)]
}
