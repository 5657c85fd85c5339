//! Where light goes at a film: back, through, or into heat.

use crate::geometry::gauss_legendre::nodes_and_weights;
use crate::grid::Grid;
use crate::spectrum::{Factor, Spectrum};

static GAUSS: [(f32, f32); 3] = nodes_and_weights();

/// What becomes of light that meets a film, as shares of its power: they sum to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PowerShares {
    /// Reflectance, 0..=1.
    pub reflected: f32,
    /// Transmittance into the last medium, 0..=1; power, so the ratio of indices and cosines is in it.
    pub transmitted: f32,
    /// What the layers absorb, 0..=1.
    pub absorbed: f32,
}

impl PowerShares {
    pub(super) const MIRROR: Self = PowerShares { reflected: 1.0, transmitted: 0.0, absorbed: 0.0 };
    /// All goes on: there is nothing in the way.
    pub(super) const NOTHING: Self = PowerShares { reflected: 0.0, transmitted: 1.0, absorbed: 0.0 };
    /// Of what is no film.
    pub(super) const NAN: Self =
        PowerShares { reflected: f32::NAN, transmitted: f32::NAN, absorbed: f32::NAN };

    /// The mean of both polarizations: unpolarized light.
    #[must_use]
    pub fn mean([s, p]: [Self; 2]) -> Self {
        s.plus(p).times(0.5)
    }

    /// Rounding may have gone beyond what a share can be.
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

/// A pair of spectra, of s and p polarized light, from what lies between the edges of each bin.
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
