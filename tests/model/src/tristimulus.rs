//! X, Y, Z as plain sums over wavelength.

use super::interpolation::{Interpolation, Outside, Samples};
use super::tables::Observer;

/// How samples become a sum: the methods of golden 01.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    SpragueZero,
    SpragueConst,
    LinearZero,
    /// The samples as they are, at their own wavelengths from 360 to 830 nm.
    NativeSum,
}

impl Method {
    pub fn named(name: &str) -> Method {
        match name {
            "sprague_zero" => Method::SpragueZero,
            "sprague_const" => Method::SpragueConst,
            "linear_zero" => Method::LinearZero,
            "native_sum" => Method::NativeSum,
            _ => panic!("no method called {name}"),
        }
    }
}

/// XYZ with Y = 100 of a light, and the factor k = 100 / sum(S ybar) that made it so.
pub fn xyz_of_light(light: &Samples, observer: Observer, method: Method) -> ([f64; 3], f64) {
    let raw = match method {
        Method::SpragueZero => {
            let light = light.on_cie_grid(Interpolation::Sprague, Outside::Zero);
            observer.on_cie_grid().map(|row| dot(&light, &row))
        }
        Method::SpragueConst => {
            let light = light.on_cie_grid(Interpolation::Sprague, Outside::Hold);
            observer.on_cie_grid().map(|row| dot(&light, &row))
        }
        Method::LinearZero => {
            let light = light.on_cie_grid(Interpolation::Linear, Outside::Zero);
            observer.on_cie_grid().map(|row| dot(&light, &row))
        }
        Method::NativeSum => observer.published().map(|row| {
            let value = |nm| row.at(nm, Interpolation::Linear, Outside::Zero);
            light.points().iter().map(|&(nm, power)| power * value(nm)).sum()
        }),
    };
    let k = 100.0 / raw[1];
    (raw.map(|sum| k * sum), k)
}

/// XYZ of a surface under a light, the perfect white having Y = 100; all on the same nodes.
pub fn xyz_of_surface(surface: &[f64], light: &[f64], cmf: &[Vec<f64>; 3]) -> [f64; 3] {
    let k = 100.0 / dot(light, &cmf[1]);
    let reflected: Vec<f64> = surface.iter().zip(light).map(|(r, s)| r * s).collect();
    [0, 1, 2].map(|c| k * dot(&reflected, &cmf[c]))
}

pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len(), "a sum over two different grids");
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}
