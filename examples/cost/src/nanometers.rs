//! The lamps and the samples at every nanometer, for studies in which the number of bins plays no part. XYZ
//! is a sum of 471 terms here.

use crate::xyz::lamps::{self, Class};
use model::fine::Curve;
use model::interpolation::{Interpolation, Outside};
use model::lab::lab;
use model::tables::samples;
use std::sync::OnceLock;

/// The number of nodes: 360, 361, .. 830 nm.
pub const NODES: usize = 471;

/// The wavelength of a node.
pub fn nm(k: usize) -> f64 {
    360.0 + k as f64
}

/// All lamps and samples.
pub struct World {
    pub lights: Vec<Light>,
    /// The 99 color evaluation samples.
    pub ces: Vec<Vec<f64>>,
}

/// A lamp with its power at each node.
pub struct Light {
    pub name: String,
    pub class: Class,
    pub power: Vec<f64>,
}

/// Returns the lamps and samples, which are read once.
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
    /// Finds a light by its name.
    pub fn light(&self, name: &str) -> &Light {
        self.lights.iter().find(|light| light.name == name).unwrap_or_else(|| panic!("no lamp {name}"))
    }
}

/// Samples a light every 0.1 nm and divides each sample between the two nodes beside it, so that a line
/// narrower than a nanometer keeps its power wherever it lies.
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

/// An eye in a certain light, which sees reflectances as XYZ.
pub struct Lit {
    rows: [Vec<f64>; 3],
    pub white: [f64; 3],
}

impl Lit {
    /// Multiplies color-matching functions by a light and by `scale`.
    pub fn new(cmf: &[Vec<f64>; 3], power: &[f64], scale: f64) -> Self {
        let rows = cmf.each_ref().map(|row| -> Vec<f64> {
            row.iter().zip(power).map(|(weight, power)| scale * weight * power).collect()
        });
        let white = rows.each_ref().map(|row| row.iter().sum());
        Lit { rows, white }
    }

    /// Returns XYZ of a reflectance.
    pub fn sees(&self, surface: &[f64]) -> [f64; 3] {
        self.rows.each_ref().map(|row| row.iter().zip(surface).map(|(weight, share)| weight * share).sum())
    }

    /// Returns Lab of a reflectance, with the light as white.
    pub fn lab(&self, surface: &[f64]) -> [f64; 3] {
        lab(self.sees(surface), self.white)
    }
}

/// Returns the factor by which a light has Y = 100.
pub fn for_y_100(cmf: &[Vec<f64>; 3], power: &[f64]) -> f64 {
    100.0 / cmf[1].iter().zip(power).map(|(weight, power)| weight * power).sum::<f64>()
}
