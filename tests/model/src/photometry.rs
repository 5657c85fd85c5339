//! From watts to lumens, to the five photoreceptors and to photons; all per watt of radiant flux
//! from 360 to 830 nm, summed at 1 nm.

use super::interpolation::{Interpolation, Outside};
use super::planck::{C, H};
use super::tables::{ALPHA_OPIC, Observer, alpha_opic, function, source};
use super::tristimulus::dot;

/// lm/W at 540 THz, exact: K_cd / V(555.17 nm).
pub const KM: f64 = 683.002;
/// lm'/W for scotopic vision.
pub const KM_SCOTOPIC: f64 = 1700.06;
const AVOGADRO: f64 = 6.022_140_76e23;

/// A light at 360, 361, ..., 830 nm, scaled to one watt, with the functions to weigh it by.
pub struct Photometry {
    watt: Vec<f64>,
    /// sum of the light as it came
    pub total: f64,
}

impl Photometry {
    pub fn of(light_on_cie_grid: &[f64]) -> Photometry {
        let total: f64 = light_on_cie_grid.iter().sum();
        Photometry { watt: light_on_cie_grid.iter().map(|power| power / total).collect(), total }
    }

    /// Share of the power weighed by V(lambda).
    pub fn v_fraction(&self) -> f64 {
        dot(&self.watt, &function("cmf/v_photopic_1nm.csv", "V"))
    }

    /// Luminous efficacy of radiation, lm/W.
    pub fn ler(&self) -> f64 {
        KM * self.v_fraction()
    }

    /// sum S V'.
    pub fn scotopic_fraction(&self) -> f64 {
        dot(&self.watt, &function("cmf/v_scotopic_1nm.csv", "V_prime"))
    }

    /// sum S ybar of the 1964 observer.
    pub fn v10_fraction(&self) -> f64 {
        dot(&self.watt, &Observer::Cie1964.on_cie_grid()[1])
    }

    /// sum S V_F; V_F(lambda) is ybar of the 2015 2 degree observer.
    pub fn vf_fraction(&self) -> f64 {
        dot(&self.watt, &Observer::Cie2015Deg2.on_cie_grid()[1])
    }

    pub fn scotopic_to_photopic(&self) -> f64 {
        KM_SCOTOPIC * self.scotopic_fraction() / self.ler()
    }

    /// Alpha-opic efficacies of luminous radiation in the order of `ALPHA_OPIC`, W/lm. The alpha-
    /// opic functions end at 380 and 780 nm, so the lumens are counted there too.
    pub fn alpha_opic_elr(&self) -> [f64; 5] {
        let mut v = function("cmf/v_photopic_1nm.csv", "V");
        for (nm, value) in (360..=830).zip(&mut v) {
            if !(380..=780).contains(&nm) {
                *value = 0.0;
            }
        }
        let lumens = KM * dot(&self.watt, &v);
        ALPHA_OPIC.map(|column| dot(&self.watt, &alpha_opic(column)) / lumens)
    }

    /// Alpha-opic daylight (D65) efficacy ratios; the last is the melanopic DER.
    pub fn alpha_opic_der(&self) -> [f64; 5] {
        let (own, daylight) = (self.alpha_opic_elr(), d65_elr());
        [0, 1, 2, 3, 4].map(|i| own[i] / daylight[i])
    }

    /// Photons in micromoles per joule: the integral of straight lines between whole nanometers.
    pub fn photons(&self, from_nm: u16, to_nm: u16) -> f64 {
        let ends = self.photon_sum(from_nm, from_nm) + self.photon_sum(to_nm, to_nm);
        self.photon_sum(from_nm, to_nm) - ends / 2.0
    }

    /// Sum of the photons at whole nanometers, both ends included, as the goldens have it.
    pub fn photon_sum(&self, from_nm: u16, to_nm: u16) -> f64 {
        self.within(from_nm, to_nm).map(|(nm, power)| power * nm * 1e-9 / (H * C * AVOGADRO) * 1e6).sum()
    }

    /// Watts in a band, both ends included.
    pub fn band(&self, from_nm: u16, to_nm: u16) -> f64 {
        self.within(from_nm, to_nm).map(|(_, power)| power).sum()
    }

    fn within(&self, from_nm: u16, to_nm: u16) -> impl Iterator<Item = (f64, f64)> {
        let all = (360..=830).zip(&self.watt);
        all.filter(move |(nm, _)| (from_nm..=to_nm).contains(nm)).map(|(nm, power)| (f64::from(nm), *power))
    }
}

/// Alpha-opic efficacies of D65, W/lm.
pub fn d65_elr() -> [f64; 5] {
    let d65 = source("D65").on_cie_grid(Interpolation::Linear, Outside::Zero);
    Photometry::of(&d65).alpha_opic_elr()
}
