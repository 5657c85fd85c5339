//! Looks for the worst input of a function, as an adversary would: from random starts it climbs uphill, by
//! large steps at first and by single units in the last place at the end.
//!
//! A test begins at [`starts`] of 30 places. With `NANOSPECTRA_SEARCH=400` it begins at 400, and finds more.

/// The inputs that one argument may have.
#[derive(Clone, Copy, Debug)]
pub enum Range {
    /// Numbers of which all are equally likely.
    Even(f32, f32),
    /// Numbers above zero whose logarithms are equally likely.
    Sizes(f32, f32),
}

impl Range {
    fn ends(self) -> (f32, f32) {
        match self {
            Range::Even(low, high) | Range::Sizes(low, high) => (low, high),
        }
    }

    /// The number at a share of the way from the lower end to the upper one.
    fn at(self, share: f64) -> f32 {
        let (low, high) = self.ends();
        let (a, b) = (f64::from(low), f64::from(high));
        let x = match self {
            Range::Even(..) => a + share * (b - a),
            Range::Sizes(..) => a * (b / a).powf(share),
        };
        (x as f32).clamp(low, high)
    }

    fn share(self, x: f32) -> f64 {
        let (low, high) = self.ends();
        let (a, b, x) = (f64::from(low), f64::from(high), f64::from(x));
        match self {
            Range::Even(..) => (x - a) / (b - a),
            Range::Sizes(..) => (x / a).ln() / (b / a).ln(),
        }
    }
}

/// The worst that was found, and the input at which it was.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Worst<const D: usize> {
    pub error: f64,
    pub at: [f32; D],
}

impl<const D: usize> Worst<D> {
    /// Fails if the error is above the bound, and also if the bound is more than twice the error.
    pub fn is_what_is_promised(self, what: &str, bound: f64) {
        println!("{what}: {:.3e} of {bound:.3e}, at {:?}", self.error, self.at);
        assert!(self.error <= bound, "{what}: {:.3e} is above {bound:.3e}, at {:?}", self.error, self.at);
        assert!(2.0 * self.error >= bound, "{what}: {bound:.3e} is more than twice {:.3e}", self.error);
    }
}

/// Numbers that are the same in every run.
struct Random(u64);

impl Random {
    fn share(&mut self) -> f64 {
        // (Marsaglia's xorshift64*.)
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 11) as f64 / 9_007_199_254_740_992.0
    }
}

/// How many starts a search has.
pub fn starts() -> usize {
    std::env::var("NANOSPECTRA_SEARCH").ok().and_then(|starts| starts.parse().ok()).unwrap_or(30)
}

/// Looks for the largest `error` of inputs in `ranges`, from [`starts`] with so many steps each.
///
/// A quarter of the coordinates of a start lie at the ends of their range. An error that is NaN counts as
/// infinite; return a negative one for inputs that do not count.
pub fn worst<const D: usize>(
    seed: u64,
    steps: usize,
    ranges: [Range; D],
    error: impl Fn([f32; D]) -> f64,
) -> Worst<D> {
    let error = |at| match error(at) {
        error if error.is_nan() => f64::INFINITY,
        error => error,
    };
    let mut random = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
    let mut worst = Worst { error: f64::NEG_INFINITY, at: ranges.map(|range| range.at(0.5)) };
    for _ in 0..starts() {
        let at = ranges.map(|range| match (random.share() * 8.0) as u32 {
            0 => range.at(0.0),
            1 => range.at(1.0),
            _ => range.at(random.share()),
        });
        let mut here = Worst { error: error(at), at };
        for step in 0..steps {
            // From a fifth of the range down to units in the last place.
            let size = 0.2 * 10f64.powf(-8.0 * random.share().min(step as f64 / steps as f64 + 0.3));
            let only = (random.share() * (D + 1) as f64) as usize;
            let mut at = here.at;
            for (k, (x, range)) in at.iter_mut().zip(ranges).enumerate() {
                if only < D && k != only {
                    continue;
                }
                let moved = range.at((range.share(*x) + size * (2.0 * random.share() - 1.0)).clamp(0.0, 1.0));
                let (low, high) = range.ends();
                *x = match moved {
                    same if same == *x && random.share() < 0.5 => x.next_up().min(high),
                    same if same == *x => x.next_down().max(low),
                    other => other,
                };
            }
            let error = error(at);
            if error >= here.error {
                here = Worst { error, at };
            }
        }
        if here.error > worst.error {
            worst = here;
        }
    }
    worst
}

/// The relative error, in units of 2^-24.
pub fn units(got: f32, exact: f64) -> f64 {
    ((f64::from(got) - exact) / exact).abs() * 16_777_216.0
}
