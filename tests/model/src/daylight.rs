//! CIE daylight of a correlated color temperature, CIE 15.

use super::interpolation::{Interpolation, Outside, Samples};
use super::tables::samples;

/// Chromaticity of the D series; `kelvin` is the nominal CCT, 4000 to 25 000.
pub fn xy(kelvin: f64) -> [f64; 2] {
    let t = kelvin;
    let x = if t <= 7000.0 {
        -4.6070e9 / t.powi(3) + 2.9678e6 / t.powi(2) + 0.09911e3 / t + 0.244063
    } else {
        -2.0064e9 / t.powi(3) + 1.9018e6 / t.powi(2) + 0.24748e3 / t + 0.237040
    };
    [x, -3.0 * x * x + 2.870 * x - 0.275]
}

/// M1 and M2, not rounded.
pub fn factors(kelvin: f64) -> [f64; 2] {
    let [x, y] = xy(kelvin);
    let m = 0.0241 + 0.2562 * x - 0.7341 * y;
    [(-1.3515 - 1.7703 * x + 5.9114 * y) / m, (0.0300 - 31.4424 * x + 30.0717 * y) / m]
}

/// M1 and M2 rounded to three decimals, as CIE 15 computes its tables.
pub fn rounded_factors(kelvin: f64) -> [f64; 2] {
    factors(kelvin).map(|m| (m * 1000.0).round() / 1000.0)
}

/// S0 + M1 S1 + M2 S2 every 5 nm from 300 to 830 nm.
pub fn spectrum([m1, m2]: [f64; 2]) -> Samples {
    let [s0, s1, s2] =
        ["S0", "S1", "S2"].map(|name| samples("illuminants/daylight_components_5nm.csv", name));
    let values = (0..s0.values.len()).map(|i| s0.values[i] + m1 * s1.values[i] + m2 * s2.values[i]).collect();
    Samples::new(s0.first, s0.step, values)
}

/// Daylight at 360, 361, ..., 830 nm: the 5 nm table joined by straight lines, as CIE 15 says.
pub fn on_cie_grid(factors: [f64; 2]) -> Vec<f64> {
    spectrum(factors).on_cie_grid(Interpolation::Linear, Outside::Zero)
}
