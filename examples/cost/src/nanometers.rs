//! The lamps and the samples every nanometer: sums of 471 terms, for what has nothing to do with the number
//! of bins.

use crate::xyz::lamps::{self, Class};
use model::fine::Curve;
use model::interpolation::{Interpolation, Outside};
use model::lab::lab;
use model::tables::samples;
use std::sync::OnceLock;

/// At 360, 361, .. 830 nm.
pub const NODES: usize = 471;

pub fn nm(k: usize) -> f64 {
    360.0 + k as f64
}

pub struct World {
    pub lights: Vec<Light>,
    /// The 99 color evaluation samples.
    pub ces: Vec<Vec<f64>>,
}

pub struct Light {
    pub name: String,
    pub class: Class,
    pub power: Vec<f64>,
}

/// Read once.
pub fn world() -> &'static World {
    static WORLD: OnceLock<World> = OnceLock::new();
    WORLD.get_or_init(|| World {
        lights: lamps::all()
            .into_iter()
            .map(|lamp| Light {
                power: shared_out(&Curve::new(lamp.points, Outside::Zero)),
                name: lamp.name,
                class: lamp.class,
            })
            .collect(),
        ces: (1..=99)
            .map(|k| {
                samples("samples/cie224_ces99_1nm.csv", &format!("CES{k:02}"))
                    .on_cie_grid(Interpolation::Linear, Outside::Hold)
            })
            .collect(),
    })
}

impl World {
    /// A light by its name.
    pub fn light(&self, name: &str) -> &Light {
        self.lights.iter().find(|light| light.name == name).unwrap_or_else(|| panic!("no lamp {name}"))
    }
}

/// Read every 0.1 nm, each reading shared by the two nodes beside it: a line narrower than a nanometer loses
/// nothing, wherever it lies.
fn shared_out(light: &Curve) -> Vec<f64> {
    let mut power = vec![0.0; NODES];
    for step in 0..=10 * (NODES - 1) {
        let (node, tenth) = (step / 10, (step % 10) as f64 / 10.0);
        let value = 0.1 * light.at(nm(0) + step as f64 / 10.0);
        power[node] += (1.0 - tenth) * value;
        if let Some(next) = power.get_mut(node + 1) {
            *next += tenth * value;
        }
    }
    power
}

/// A light in front of an eye: what makes XYZ of reflectances.
pub struct Lit {
    rows: [Vec<f64>; 3],
    pub white: [f64; 3],
}

impl Lit {
    /// By color-matching functions, times `scale`.
    pub fn new(cmf: &[Vec<f64>; 3], power: &[f64], scale: f64) -> Self {
        let rows = cmf.each_ref().map(|row| -> Vec<f64> {
            row.iter().zip(power).map(|(weight, power)| scale * weight * power).collect()
        });
        let white = rows.each_ref().map(|row| row.iter().sum());
        Lit { rows, white }
    }

    /// XYZ of a reflectance.
    pub fn sees(&self, surface: &[f64]) -> [f64; 3] {
        self.rows.each_ref().map(|row| row.iter().zip(surface).map(|(weight, share)| weight * share).sum())
    }

    /// Lab of a reflectance with the light as white.
    pub fn lab(&self, surface: &[f64]) -> [f64; 3] {
        lab(self.sees(surface), self.white)
    }
}

/// The factor that gives a light Y = 100.
pub fn for_y_100(cmf: &[Vec<f64>; 3], power: &[f64]) -> f64 {
    100.0 / cmf[1].iter().zip(power).map(|(weight, power)| weight * power).sum::<f64>()
}
