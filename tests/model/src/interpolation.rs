//! Regular samples and what lies between and beside them.

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Interpolation {
    Linear,
    Sprague,
}

/// What lies outside the data: nothing (lights), or the end values (reflectances).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outside {
    Zero,
    Hold,
}

/// Values at `first`, `first + step`, ... in nm.
#[derive(Clone, Debug, PartialEq)]
pub struct Samples {
    pub first: f64,
    pub step: f64,
    pub values: Vec<f64>,
}

impl Samples {
    pub fn new(first: f64, step: f64, values: Vec<f64>) -> Samples {
        assert!(step > 0.0 && !values.is_empty());
        Samples { first, step, values }
    }

    pub fn nm(&self, index: usize) -> f64 {
        self.first + self.step * index as f64
    }

    pub fn last(&self) -> f64 {
        self.nm(self.values.len() - 1)
    }

    /// (nm, value) pairs, the form in which a measurement file has them.
    pub fn points(&self) -> Vec<(f64, f64)> {
        self.values.iter().enumerate().map(|(i, &v)| (self.nm(i), v)).collect()
    }

    pub fn at(&self, nm: f64, between: Interpolation, outside: Outside) -> f64 {
        let beyond = |end: f64| if outside == Outside::Hold { end } else { 0.0 };
        if nm < self.first {
            return beyond(self.values[0]);
        }
        if nm > self.last() {
            return beyond(self.values[self.values.len() - 1]);
        }
        let position = (nm - self.first) / self.step;
        let index = position.floor() as usize;
        let t = position - index as f64;
        if t == 0.0 {
            return self.values[index];
        }
        match between {
            Interpolation::Linear => self.values[index] * (1.0 - t) + self.values[index + 1] * t,
            Interpolation::Sprague => self.sprague(index, t),
        }
    }

    /// Point values at 360, 361, ..., 830 nm: the grid of the CIE tables.
    pub fn on_cie_grid(&self, between: Interpolation, outside: Outside) -> Vec<f64> {
        (360..=830).map(|nm| self.at(f64::from(nm), between, outside)).collect()
    }

    /// Sprague's quintic through the six neighbors, CIE 167:2005.
    fn sprague(&self, index: usize, t: f64) -> f64 {
        let at = |offset: isize| self.extended(index as isize + offset);
        let (a, b, c, d, e, f) = (at(-2), at(-1), at(0), at(1), at(2), at(3));
        let a1 = (2.0 * a - 16.0 * b + 16.0 * d - 2.0 * e) / 24.0;
        let a2 = (-a + 16.0 * b - 30.0 * c + 16.0 * d - e) / 24.0;
        let a3 = (-9.0 * a + 39.0 * b - 70.0 * c + 66.0 * d - 33.0 * e + 7.0 * f) / 24.0;
        let a4 = (13.0 * a - 64.0 * b + 126.0 * c - 124.0 * d + 61.0 * e - 12.0 * f) / 24.0;
        let a5 = (-5.0 * a + 25.0 * b - 50.0 * c + 50.0 * d - 25.0 * e + 5.0 * f) / 24.0;
        c + t * (a1 + t * (a2 + t * (a3 + t * (a4 + t * a5))))
    }

    /// The samples with the two boundary points CIE 167 adds at each end.
    fn extended(&self, index: isize) -> f64 {
        const OUTER: [f64; 6] = [884.0, -1960.0, 3033.0, -2648.0, 1080.0, -180.0];
        const INNER: [f64; 6] = [508.0, -540.0, 488.0, -367.0, 144.0, -24.0];
        let count = self.values.len() as isize;
        assert!(count >= 6, "Sprague needs six samples");
        let from_first = |k: usize| self.values[k];
        let from_last = |k: usize| self.values[self.values.len() - 1 - k];
        let sum = |weights: [f64; 6], value: &dyn Fn(usize) -> f64| -> f64 {
            (0..6).map(|k| weights[k] * value(k)).sum::<f64>() / 209.0
        };
        match index {
            -2 => sum(OUTER, &from_first),
            -1 => sum(INNER, &from_first),
            i if i == count => sum(INNER, &from_last),
            i if i == count + 1 => sum(OUTER, &from_last),
            i => self.values[i as usize],
        }
    }
}
