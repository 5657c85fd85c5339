//! How often a number took which values, in fixed memory: a histogram with classes that widen with the value.

/// The number of classes, a power of two.
const CLASSES: u32 = 512;

/// By how many bits the number of a class is shorter than an `f32`, which leaves 32 classes for each factor
/// of 2.
const SHIFT: u32 = 18;

/// Counts values that are zero or more, in classes that are 1.6 to 3.1 % wide.
///
/// There are classes from the largest value down to 2^-16 of it. Values below are counted together.
#[derive(Clone, Debug)]
pub(super) struct Classes {
    /// The class of the largest value. Its count stands at this number modulo [`CLASSES`], and those of lower
    /// classes before it.
    highest: u32,
    counts: [u16; CLASSES as usize],
    below: u32,
    /// Every how many values one is counted, and how many are left out until then.
    every: u32,
    left: u32,
    least: f32,
    largest: f32,
}

impl Classes {
    pub(super) const fn new() -> Self {
        let counts = [0; CLASSES as usize];
        let (least, largest) = (f32::INFINITY, 0.0);
        Classes { highest: CLASSES - 1, counts, below: 0, every: 1, left: 0, least, largest }
    }

    pub(super) fn count(&mut self, value: f32) {
        if self.left > 0 {
            self.left -= 1;
            return;
        }
        self.left = self.every - 1;
        self.least = self.least.min(value);
        self.largest = self.largest.max(value);
        let class = value.to_bits() >> SHIFT;
        while self.highest < class {
            self.highest += 1;
            let lowest = core::mem::take(self.slot(self.highest));
            self.below = self.below.saturating_add(lowest.into());
        }
        if self.highest - class >= CLASSES {
            self.below = self.below.saturating_add(1);
            return;
        }
        let count = self.slot(class);
        *count += 1;
        if *count == u16::MAX {
            self.halve();
        }
    }

    fn slot(&mut self, class: u32) -> &mut u16 {
        &mut self.counts[(class % CLASSES) as usize]
    }

    /// Halves all counts, and from now on counts half as many values. What is odd goes to the next class
    /// below, so that no sum from the top changes by more than a half.
    fn halve(&mut self) {
        let mut odd = 0;
        for back in 0..CLASSES {
            let count = self.slot(self.highest - back);
            let sum = u32::from(*count) + odd;
            *count = (sum / 2) as u16;
            odd = sum % 2;
        }
        self.below = self.below.saturating_add(odd) / 2;
        self.every = self.every.saturating_mul(2);
        self.left = self.every - 1;
    }

    /// Returns the value that this share of all values exceeds, or 0 if there are none.
    ///
    /// The values of a class are taken to be spread evenly over it.
    pub(super) fn exceeded_by(&self, share: f32) -> f32 {
        let all: u32 = self.counts.iter().copied().map(u32::from).sum();
        let mut above = share * (all as f32 + self.below as f32);
        for back in 0..CLASSES {
            let class = self.highest - back;
            let count = f32::from(self.counts[(class % CLASSES) as usize]);
            if above < count {
                let [low, high] = [class, class + 1].map(|class| f32::from_bits(class << SHIFT));
                return self.within(low, high, above / count);
            }
            above -= count;
        }
        let high = f32::from_bits((self.highest + 1 - CLASSES) << SHIFT);
        if self.below == 0 { self.least } else { self.within(0.0, high, above / self.below as f32) }
    }

    /// Returns the value between these two that a share of the values between them exceeds.
    fn within(&self, low: f32, high: f32, share: f32) -> f32 {
        let (low, high) = (low.max(self.least), high.min(self.largest));
        high - share * (high - low)
    }
}
