//! Ohno's method as it is printed, with squares and their differences, in f32 and on a table of any step.

use model::cct::planckian_uv;

/// Ohno's correction for the curvature of the locus, for steps of 1 %. It grows with the square of the step.
const CORRECTION: f32 = 9e-5;

/// A table of temperature, u and v, in equal steps of the logarithm of the temperature.
pub struct Printed {
    rows: Vec<[f32; 3]>,
    correction: f32,
}

impl Printed {
    /// Makes the table from 1000 K to 100 000 K, in steps of so many percent.
    pub fn new(percent: f64) -> Self {
        let ratio = 1.0 + percent / 100.0;
        let steps = (100f64.ln() / ratio.ln()).ceil() as i32 + 1;
        let row = |k: i32| {
            let kelvin = 1000.0 * ratio.powi(k);
            let [u, v] = planckian_uv(kelvin);
            [kelvin as f32, u as f32, v as f32]
        };
        Printed { rows: (-1..=steps).map(row).collect(), correction: CORRECTION * (percent * percent) as f32 }
    }

    pub fn bytes(&self) -> usize {
        size_of_val(self.rows.as_slice())
    }

    /// Returns the temperature in K, or `None` beyond the ends of the table.
    ///
    /// # Reference
    /// Y. Ohno, "Practical use and calculation of CCT and Duv", Leukos 10 (2014), equations 6 to 14.
    pub fn cct_k(&self, [u, v]: [f32; 2]) -> Option<f32> {
        let distance = |row: &[f32; 3]| ((u - row[1]) * (u - row[1]) + (v - row[2]) * (v - row[2])).sqrt();
        let nearest = self.rows.iter().enumerate().min_by(|a, b| distance(a.1).total_cmp(&distance(b.1)))?.0;
        let [before, here, after] = self.rows.get(nearest.checked_sub(1)?..)?.first_chunk::<3>()?;
        let [d0, d1, d2] = [before, here, after].map(distance);
        let ([t0, u0, v0], [t1, ..], [t2, u2, v2]) = (*before, *here, *after);
        let base = ((u2 - u0) * (u2 - u0) + (v2 - v0) * (v2 - v0)).sqrt();
        let x = (d0 * d0 - d2 * d2 + base * base) / (2.0 * base);
        let duv = (d0 * d0 - x * x).max(0.0).sqrt();
        if duv < 0.002 {
            return Some((t0 + (t2 - t0) * x / base) * (1.0 - self.correction));
        }
        let all = (t2 - t1) * (t0 - t2) * (t1 - t0);
        let a = (t0 * (d2 - d1) + t1 * (d0 - d2) + t2 * (d1 - d0)) / all;
        let b = -(t0 * t0 * (d2 - d1) + t1 * t1 * (d0 - d2) + t2 * t2 * (d1 - d0)) / all;
        Some(-b / (2.0 * a))
    }
}
