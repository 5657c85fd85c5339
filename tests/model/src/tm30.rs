//! ANSI/IES TM-30-18, whose Rf is CIE 224:2017.

use super::appearance::{AVERAGE, Viewing, cam02_ucs};
use super::cct::{Cct, cct};
use super::chromaticity::uv1960;
use super::cri::Mode;
use super::daylight;
use super::interpolation::{Interpolation, Outside, Samples};
use super::planck::{C2_CIE, relative};
use super::tables::{Observer, samples};
use super::tristimulus::{dot, xyz_of_surface};

#[derive(Clone, Debug)]
pub struct Tm30 {
    pub cct: Cct,
    pub rf: f64,
    pub rg: f64,
    /// Fidelity of each of the 99 samples.
    pub rf_ces: Vec<f64>,
    /// Local fidelity, chroma shift and hue shift of the 16 hue bins; shifts are fractions.
    pub rfh: [f64; 16],
    pub rcs: [f64; 16],
    pub rhs: [f64; 16],
    /// Samples per hue bin.
    pub in_bin: [usize; 16],
    /// How near any reference hue comes to an edge between bins; bins are unstable below 0.05.
    pub nearest_edge_deg: f64,
}

/// Which observer's Y the Planckian and the daylight half are brought to before they are mixed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mix {
    Cie1931,
    Cie1964,
}

/// Wavelengths, observers and samples: costly to read, so made once for many lights.
pub struct Method {
    pub nm: Vec<f64>,
    cmf_1931: [Vec<f64>; 3],
    cmf_1964: [Vec<f64>; 3],
    samples: Vec<Vec<f64>>,
}

impl Method {
    /// 380 to 780 nm, every 1 or every 5 nm; the 5 nm samples are every fifth of the 1 nm ones.
    pub fn new(mode: Mode) -> Method {
        let step = if mode == Mode::OneNm { 1 } else { 5 };
        let nm: Vec<f64> = (380..=780).step_by(step).map(f64::from).collect();
        let on = |samples: &Samples| -> Vec<f64> {
            nm.iter().map(|&nm| samples.at(nm, Interpolation::Linear, Outside::Zero)).collect()
        };
        let file = "samples/cie224_ces99_1nm.csv";
        let color_samples = (1..=99).map(|k| on(&samples(file, &format!("CES{k:02}")))).collect();
        Method {
            cmf_1931: Observer::Cie1931.published().map(|row| on(&row)),
            cmf_1964: Observer::Cie1964.published().map(|row| on(&row)),
            samples: color_samples,
            nm,
        }
    }

    pub fn of(&self, light: &Samples) -> Tm30 {
        self.with_mix(light, Mix::Cie1931)
    }

    pub fn with_mix(&self, light: &Samples, mix: Mix) -> Tm30 {
        let on_grid: Vec<f64> =
            self.nm.iter().map(|&nm| light.at(nm, Interpolation::Sprague, Outside::Zero)).collect();
        self.of_values(&on_grid, mix)
    }

    /// A light given at this method's own wavelengths.
    pub fn of_values(&self, light: &[f64], mix: Mix) -> Tm30 {
        let cct = cct(uv1960([0, 1, 2].map(|c| dot(light, &self.cmf_1931[c]))));
        let reference = self.reference(cct.cct_k, mix);
        compare(&self.seen_under(light), &self.seen_under(&reference), cct)
    }

    /// Planck up to 4000 K, daylight from 5000 K, a linear mix at equal Y between.
    fn reference(&self, kelvin: f64, mix: Mix) -> Vec<f64> {
        let y_bar = match mix {
            Mix::Cie1931 => &self.cmf_1931[1],
            Mix::Cie1964 => &self.cmf_1964[1],
        };
        let at_unit_y = |light: Vec<f64>| -> Vec<f64> {
            let y = dot(&light, y_bar);
            light.iter().map(|power| power / y).collect()
        };
        let planck = || at_unit_y(self.nm.iter().map(|&nm| relative(nm, kelvin, C2_CIE)).collect());
        let daylight = || {
            let table = daylight::spectrum(daylight::factors(kelvin));
            let at = |&nm: &f64| table.at(nm, Interpolation::Linear, Outside::Zero);
            at_unit_y(self.nm.iter().map(at).collect())
        };
        if kelvin <= 4000.0 {
            planck()
        } else if kelvin >= 5000.0 {
            daylight()
        } else {
            let share = (kelvin - 4000.0) / 1000.0;
            let mixed = |(p, d): (&f64, &f64)| (1.0 - share) * p + share * d;
            planck().iter().zip(&daylight()).map(mixed).collect()
        }
    }

    fn seen_under(&self, light: &[f64]) -> Vec<[f64; 3]> {
        let k = 100.0 / dot(light, &self.cmf_1964[1]);
        let white = [0, 1, 2].map(|c| k * dot(light, &self.cmf_1964[c]));
        let viewing = Viewing { white, la: 100.0, yb: 20.0, d: 1.0, surround: AVERAGE };
        self.samples
            .iter()
            .map(|sample| cam02_ucs(xyz_of_surface(sample, light, &self.cmf_1964), viewing))
            .collect()
    }
}

fn compare(test: &[[f64; 3]], reference: &[[f64; 3]], cct: Cct) -> Tm30 {
    let difference =
        |i: usize| -> f64 { (0..3).map(|c| (test[i][c] - reference[i][c]).powi(2)).sum::<f64>().sqrt() };
    let all: Vec<f64> = (0..test.len()).map(difference).collect();

    let mut bins: [Vec<usize>; 16] = Default::default();
    let mut nearest_edge_deg = f64::INFINITY;
    for (i, [_, a, b]) in reference.iter().enumerate() {
        let hue = b.atan2(*a).to_degrees().rem_euclid(360.0);
        bins[(hue / 22.5) as usize].push(i);
        let beyond = hue.rem_euclid(22.5);
        nearest_edge_deg = nearest_edge_deg.min(beyond).min(22.5 - beyond);
    }
    let mean_of = |bin: &[usize], colors: &[[f64; 3]]| -> [f64; 2] {
        [1, 2].map(|c| bin.iter().map(|&i| colors[i][c]).sum::<f64>() / bin.len() as f64)
    };
    let corners_test = bins.each_ref().map(|bin| mean_of(bin, test));
    let corners_reference = bins.each_ref().map(|bin| mean_of(bin, reference));

    let (mut rfh, mut rcs, mut rhs) = ([0.0; 16], [0.0; 16], [0.0; 16]);
    for j in 0..16 {
        let of_bin: Vec<f64> = bins[j].iter().map(|&i| all[i]).collect();
        rfh[j] = fidelity(mean(&of_bin));
        let ([at, bt], [ar, br]) = (corners_test[j], corners_reference[j]);
        let chroma = ar.hypot(br);
        let (sin, cos) = (22.5 * (j as f64 + 0.5)).to_radians().sin_cos();
        rcs[j] = ((at - ar) * cos + (bt - br) * sin) / chroma;
        rhs[j] = (-(at - ar) * sin + (bt - br) * cos) / chroma;
    }
    Tm30 {
        cct,
        rf: fidelity(mean(&all)),
        rg: 100.0 * area(&corners_test) / area(&corners_reference),
        rf_ces: all.iter().map(|&difference| fidelity(difference)).collect(),
        rfh,
        rcs,
        rhs,
        in_bin: bins.map(|bin| bin.len()),
        nearest_edge_deg,
    }
}

/// 100 - 6.73 dE', bent so that it stays above zero.
fn fidelity(difference: f64) -> f64 {
    10.0 * ((100.0 - 6.73 * difference) / 10.0).exp().ln_1p()
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Area of a polygon by the shoelace formula.
fn area(corners: &[[f64; 2]; 16]) -> f64 {
    let cross = |j: usize| {
        let ([a1, b1], [a2, b2]) = (corners[j], corners[(j + 1) % 16]);
        a1 * b2 - a2 * b1
    };
    0.5 * (0..16).map(cross).sum::<f64>()
}
