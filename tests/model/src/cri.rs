//! CIE 13.3-1995 color rendering indices, unrounded.

use super::cct::{Cct, cct};
use super::chromaticity::uv1960;
use super::daylight;
use super::interpolation::{Interpolation, Outside, Samples};
use super::planck::{C2_CIE, relative};
use super::tables::{Observer, test_color_samples};
use super::tristimulus::{dot, xyz_of_surface};

/// The two ways of summing in goldens 03.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mode {
    /// Source and samples Sprague-interpolated to 1 nm, the source zero outside its table.
    OneNm,
    /// The published 5 nm tables, summed from 380 to 780 nm.
    FiveNm,
}

impl Mode {
    pub fn named(name: &str) -> Mode {
        match name {
            "1nm" => Mode::OneNm,
            "5nm" => Mode::FiveNm,
            _ => panic!("no mode called {name}"),
        }
    }
}

#[derive(Clone, Debug)]
pub struct Cri {
    pub cct: Cct,
    /// Distance of source and reference in the CIE 1960 diagram; the method wants 5.4e-3 or less.
    pub dc: f64,
    pub ra: f64,
    /// R1 to R15.
    pub r: [f64; 15],
}

/// Wavelengths, observer and samples of one mode: costly to read, so made once for many lights.
pub struct Method {
    nm: Vec<f64>,
    cmf: [Vec<f64>; 3],
    samples: Vec<Vec<f64>>,
}

impl Method {
    pub fn new(mode: Mode) -> Method {
        let nm = match mode {
            Mode::OneNm => (360..=830).map(f64::from).collect::<Vec<_>>(),
            Mode::FiveNm => (76..=156).map(|i| 5.0 * f64::from(i)).collect(),
        };
        let on = |samples: &Samples, between, outside| -> Vec<f64> {
            nm.iter().map(|&nm| samples.at(nm, between, outside)).collect()
        };
        let cmf = Observer::Cie1931.published().map(|row| on(&row, Interpolation::Linear, Outside::Zero));
        let samples = test_color_samples()
            .iter()
            .map(|sample| on(sample, Interpolation::Sprague, Outside::Hold))
            .collect();
        Method { nm, cmf, samples }
    }

    /// Indices of a table of samples.
    pub fn of(&self, light: &Samples) -> Cri {
        let on_grid: Vec<f64> =
            self.nm.iter().map(|&nm| light.at(nm, Interpolation::Sprague, Outside::Zero)).collect();
        self.of_values(&on_grid)
    }

    /// Indices of a light given at this method's own wavelengths.
    pub fn of_values(&self, light: &[f64]) -> Cri {
        self.against(light, daylight::factors)
    }

    /// The same with daylight's M1 and M2 rounded to three decimals.
    pub fn of_rounded(&self, light: &Samples) -> Cri {
        let on_grid: Vec<f64> =
            self.nm.iter().map(|&nm| light.at(nm, Interpolation::Sprague, Outside::Zero)).collect();
        self.against(&on_grid, daylight::rounded_factors)
    }

    /// Planck below 5000 K, CIE daylight from there on.
    fn reference(&self, kelvin: f64, factors: fn(f64) -> [f64; 2]) -> Vec<f64> {
        if kelvin < 5000.0 {
            self.nm.iter().map(|&nm| relative(nm, kelvin, C2_CIE)).collect()
        } else {
            let daylight = daylight::spectrum(factors(kelvin));
            let at = |nm: f64| daylight.at(nm, Interpolation::Linear, Outside::Zero);
            self.nm.iter().map(|&nm| at(nm)).collect()
        }
    }

    fn against(&self, light: &[f64], factors: fn(f64) -> [f64; 2]) -> Cri {
        let white = |light: &[f64]| uv1960([0, 1, 2].map(|c| dot(light, &self.cmf[c])));
        let white_test = white(light);
        let cct = cct(white_test);
        let reference = self.reference(cct.cct_k, factors);
        let white_reference = white(&reference);

        let mut r = [0.0; 15];
        for (index, sample) in r.iter_mut().zip(&self.samples) {
            let xyz_test = xyz_of_surface(sample, light, &self.cmf);
            let xyz_reference = xyz_of_surface(sample, &reference, &self.cmf);
            let adapted = adapt(uv1960(xyz_test), white_test, white_reference);
            // the adapted source has the reference's own chromaticity
            let one = uvw(adapted, xyz_test[1], white_reference);
            let two = uvw(uv1960(xyz_reference), xyz_reference[1], white_reference);
            let difference = (0..3).map(|c| (one[c] - two[c]).powi(2)).sum::<f64>().sqrt();
            *index = 100.0 - 4.6 * difference;
        }
        Cri {
            cct,
            dc: (white_test[0] - white_reference[0]).hypot(white_test[1] - white_reference[1]),
            ra: r[..8].iter().sum::<f64>() / 8.0,
            r,
        }
    }
}

/// The von Kries step of CIE 13.3 in its c and d coordinates.
fn adapt(sample: [f64; 2], from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    let cd = |[u, v]: [f64; 2]| [(4.0 - u - 10.0 * v) / v, (1.708 * v + 0.404 - 1.481 * u) / v];
    let ([c, d], [ct, dt], [cr, dr]) = (cd(sample), cd(from), cd(to));
    let (c, d) = (cr / ct * c, dr / dt * d);
    let bottom = 16.518 + 1.481 * c - d;
    [(10.872 + 0.404 * c - 4.0 * d) / bottom, 5.520 / bottom]
}

/// CIE 1964 W*, U*, V* with Y = 100 for white.
fn uvw([u, v]: [f64; 2], y: f64, white: [f64; 2]) -> [f64; 3] {
    let w = 25.0 * y.cbrt() - 17.0;
    [w, 13.0 * w * (u - white[0]), 13.0 * w * (v - white[1])]
}
