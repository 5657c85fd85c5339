//! The largest error of a sweep, against what is allowed.

/// Collects errors and remembers the worst.
pub struct Worst {
    what: &'static str,
    error: f64,
    place: String,
    count: usize,
}

impl Worst {
    pub fn of(what: &'static str) -> Worst {
        Worst { what, error: 0.0, place: String::new(), count: 0 }
    }

    /// The distance of `got` from `expected`.
    pub fn add(&mut self, place: &str, got: f32, expected: f64) {
        self.error_of(place, (f64::from(got) - expected).abs());
    }

    #[allow(dead_code, reason = "not every test has triples")]
    pub fn add_all(&mut self, place: &str, got: [f32; 3], expected: [f64; 3]) {
        got.into_iter().zip(expected).for_each(|(got, expected)| self.add(place, got, expected));
    }

    /// The distance relative to the size of `expected`.
    #[allow(dead_code, reason = "not every test asks for it")]
    pub fn add_relative(&mut self, place: &str, got: f32, expected: f64) {
        self.error_of(place, (f64::from(got) - expected).abs() / expected.abs());
    }

    fn error_of(&mut self, place: &str, error: f64) {
        self.count += 1;
        // NaN is the worst of all, and stays
        if error.is_nan() || error > self.error {
            self.error = error;
            self.place = place.to_string();
        }
    }

    /// Fails beyond `allowed`, and where `allowed` is more than twice what is needed.
    pub fn within(self, allowed: f64) {
        let Worst { what, error, place, count } = self;
        println!("{what}: {count} numbers, worst {error:.2e} at {place}, allowed {allowed:.1e}");
        assert!(count > 0, "{what}: nothing compared");
        assert!(error <= allowed, "{what}: {error:e} at {place}, allowed {allowed:e}");
        assert!(allowed <= 2.0 * error, "{what}: {allowed:e} allowed, {error:e} needed");
    }
}
