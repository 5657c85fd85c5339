//! How the constants of `tables/upsample` are made: from the CIE 1931 functions and D65, and nothing else.

pub mod basis;
#[cfg(feature = "libm")]
pub mod reach;
pub mod responses;
pub mod start;

use model::tables::{Observer, function};

/// The color-matching functions at 360..=830 nm.
pub fn functions() -> [Vec<f64>; 3] {
    Observer::Cie1931.on_cie_grid()
}

pub fn d65() -> Vec<f64> {
    function("illuminants/D65_1nm.csv", "D65")
}

/// The eye under D65 on 380, 385, .. 780 nm, scaled to Y = 1 for white: each nanometer counts in the bin it
/// lies in, what is outside in the end bins.
pub fn eye() -> [Vec<f64>; 3] {
    let light = d65();
    let functions = functions();
    let white: f64 = functions[1].iter().zip(&light).map(|(y, s)| y * s).sum();
    functions.map(|row| {
        let mut bins = vec![0.0; 81];
        for (k, (weight, power)) in row.iter().zip(&light).enumerate() {
            let nm = 360.0 + k as f64;
            bins[((nm - 377.5) / 5.0).floor().clamp(0.0, 80.0) as usize] += weight * power / white;
        }
        bins
    })
}

/// XYZ of a white surface.
pub fn white(eye: &[Vec<f64>; 3]) -> [f64; 3] {
    eye.each_ref().map(|row| row.iter().sum())
}
