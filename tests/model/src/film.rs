//! Layers in f64: the characteristic matrix as the textbook has it, and means over a range by many points.

use std::f64::consts::PI;
use std::ops::{Add, Div, Mul, Sub};

#[derive(Clone, Copy, Debug)]
pub struct C(pub f64, pub f64);

impl Add for C {
    type Output = C;
    fn add(self, o: C) -> C {
        C(self.0 + o.0, self.1 + o.1)
    }
}

impl Sub for C {
    type Output = C;
    fn sub(self, o: C) -> C {
        C(self.0 - o.0, self.1 - o.1)
    }
}

impl Mul for C {
    type Output = C;
    fn mul(self, o: C) -> C {
        C(self.0 * o.0 - self.1 * o.1, self.0 * o.1 + self.1 * o.0)
    }
}

impl Div for C {
    type Output = C;
    fn div(self, o: C) -> C {
        let d = o.norm();
        C((self.0 * o.0 + self.1 * o.1) / d, (self.1 * o.0 - self.0 * o.1) / d)
    }
}

impl C {
    fn norm(self) -> f64 {
        self.0 * self.0 + self.1 * self.1
    }

    fn sqrt(self) -> C {
        let size = self.norm().sqrt();
        C((0.5 * (size + self.0)).max(0.0).sqrt(), (0.5 * (size - self.0)).max(0.0).sqrt())
    }

    fn cos(self) -> C {
        C(self.0.cos() * self.1.cosh(), -self.0.sin() * self.1.sinh())
    }

    fn sin(self) -> C {
        C(self.0.sin() * self.1.cosh(), self.0.cos() * self.1.sinh())
    }
}

/// R and T for s and p; layers are (index, thickness in nm) from the side of the light.
pub fn stack(n0: f64, layers: &[(C, f64)], substrate: C, nm: f64, cos: f64) -> [[f64; 2]; 2] {
    let sine2 = n0 * n0 * (1.0 - cos * cos);
    // n cos(theta), the fading wave where nothing travels
    let tilted = |n: C| (n * n - C(sine2, 0.0)).sqrt();
    [false, true].map(|p| {
        let admittance = |n: C| if p { n * n / tilted(n) } else { tilted(n) };
        let (mut electric, mut magnetic) = (C(1.0, 0.0), admittance(substrate));
        for &(n, d) in layers.iter().rev() {
            let phase = tilted(n) * C(2.0 * PI * d / nm, 0.0);
            let (c, s, y) = (phase.cos(), phase.sin(), admittance(n));
            let minus_i = C(0.0, -1.0);
            (electric, magnetic) =
                (c * electric + minus_i * s / y * magnetic, minus_i * s * y * electric + c * magnetic);
        }
        let y0 = admittance(C(n0, 0.0));
        let all = (y0 * electric + magnetic).norm();
        let reflected = (y0 * electric - magnetic).norm() / all;
        [reflected, 4.0 * y0.0 * admittance(substrate).0 / all]
    })
}

/// R of one lossless layer for s and p, from the sines: also for films of a thousandth of a nanometer.
pub fn airy([n0, n1, n2]: [f64; 3], d: f64, nm: f64, cos: f64) -> [f64; 2] {
    let across = n0 * n0 * (1.0 - cos) * (1.0 + cos);
    let [g0, g1, g2] = [n0, n1, n2].map(|n| (n * n - across).sqrt());
    let sine2 = (PI * (2.0 * g1 * d / nm).fract()).sin().powi(2);
    let amplitude = |a: f64, b: f64| (a - b) / (a + b);
    let s = [amplitude(g0, g1), amplitude(g1, g2)];
    let p = [amplitude(g0 / (n0 * n0), g1 / (n1 * n1)), amplitude(g1 / (n1 * n1), g2 / (n2 * n2))];
    [s, p].map(|[r01, r12]| {
        let four = 4.0 * r01 * r12 * sine2;
        ((r01 + r12).powi(2) - four) / ((1.0 + r01 * r12).powi(2) - four)
    })
}

/// The mean of a function between two wavelengths, by `points` midpoints.
pub fn mean<const K: usize>(low: f64, high: f64, points: usize, f: impl Fn(f64) -> [f64; K]) -> [f64; K] {
    let mut sum = [0.0; K];
    for i in 0..points {
        let nm = low + (high - low) * (i as f64 + 0.5) / points as f64;
        for (sum, value) in sum.iter_mut().zip(f(nm)) {
            *sum += value / points as f64;
        }
    }
    sum
}
