//! Readouts that are not linear: what they report falls short of the light as it grows.
//!
//! A path and an observer are linear, so both can be folded into one matrix. A readout that is not linear
//! cannot be. It is applied to what the observer sees, channel by channel, and it is undone on what a chip
//! reports before any other step.

use crate::math::const_for;

/// A counter that misses every event that arrives while it is still busy with the one before (non-paralyzable
/// dead time).
///
/// Photon counters are like that, and so are chips that turn light into a frequency.
/// [`arrived`](Self::arrived) corrects what was counted, and [`counted`](Self::counted) simulates it.
///
/// # Example
///
/// ```
/// use nanospectra::sensor::DeadTime;
/// // With 50 ns, one in 21 of a million photons a second is missed.
/// let counter = DeadTime::new(50e-9);
/// let counted = counter.counted(1e6);
/// assert!((counted - 1e6 / 1.05).abs() < 1.0);
/// assert!((counter.arrived(counted).unwrap() - 1e6).abs() < 1.0);
/// // 20 million a second is the limit of this counter, at which any number may have arrived.
/// assert_eq!(counter.arrived(20e6), None);
/// ```
///
/// # Reference
/// G. F. Knoll, "Radiation Detection and Measurement", chapter 4, VII.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DeadTime {
    seconds: f32,
}

impl DeadTime {
    /// Makes a counter that is busy for so many seconds after each event. See the [example](#example).
    ///
    /// A negative time counts as zero. NaN stays NaN.
    #[must_use]
    pub const fn new(seconds: f32) -> Self {
        DeadTime { seconds: if seconds < 0.0 { 0.0 } else { seconds } }
    }

    /// Computes how many events arrived per second when `counted` ones were counted. See the
    /// [example](#example).
    ///
    /// `None` from one count in every dead time on, where any number may have arrived. NaN stays NaN.
    ///
    /// # Accuracy
    /// There and back 2 units in the last place while a sixth of the time is dead at most, 4 up to half of
    /// it. Close to the limit, a rounding error of what is counted grows in what arrived: it is divided by
    /// the share of the time in which the counter is not busy.
    #[must_use]
    #[inline]
    pub const fn arrived(&self, counted: f32) -> Option<f32> {
        // (Zero times infinity is NaN, but an ideal counter has no dead time and counts them all.)
        let dead = if self.seconds == 0.0 { 0.0 } else { self.seconds * counted };
        let live = 1.0 - dead;
        if live <= 0.0 { None } else { Some(counted / live) }
    }

    /// Computes how many events are counted per second when `arriving` ones arrive. See the
    /// [example](#example).
    ///
    /// `arriving` is zero or more. The result is below one event in every dead time. NaN stays NaN.
    ///
    /// # Accuracy
    /// 3 units of 2^-24.
    #[must_use]
    #[inline]
    pub const fn counted(&self, arriving: f32) -> f32 {
        let busy = self.seconds * arriving;
        // So many arrive that the counter is always busy. (Infinity over infinity would be NaN.)
        if busy == f32::INFINITY || arriving == f32::INFINITY {
            return 1.0 / self.seconds;
        }
        arriving / (1.0 + busy)
    }
}

/// A polynomial response, as of photodiodes near saturation, amplifiers and converters, that bends away from
/// a straight line.
///
/// What is read of a signal `x` of full scale 1 is `x + c2 x^2 + c3 x^3 ..`, and rises throughout.
/// [`signal`](Self::signal) corrects what was read, and [`read`](Self::read) simulates it.
///
/// # Example
///
/// ```
/// use nanospectra::sensor::Nonlinearity;
/// // Reads 2 % too little at full scale.
/// let bend = Nonlinearity::new([-0.02]).unwrap();
/// assert!((bend.read(0.5) - 0.495).abs() < 1e-7);
/// assert!((bend.signal(0.495).unwrap() - 0.5).abs() < 1e-7);
/// assert_eq!(bend.signal(1.01), None); // above full scale
/// assert_eq!(Nonlinearity::new([-0.6]), None); // would fall before full scale
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nonlinearity<const K: usize> {
    coefficients: [f32; K],
}

/// The bracket halves each time that Newton's step leaves it, and 24 halvings are all the digits there are.
const STEPS: usize = 32;

impl<const K: usize> Nonlinearity<K> {
    /// Takes the coefficients of x^2, x^3 and so on. See the [example](#example).
    ///
    /// `None` if one of them is not finite or if the response does not rise everywhere in 0..=1. The slope is
    /// looked at in 257 places, and a bound on how fast it changes tells whether it could reach zero between
    /// two of them. Therefore a response whose slope comes within some thousandths of zero may be refused
    /// too.
    #[must_use]
    pub const fn new(coefficients: [f32; K]) -> Option<Self> {
        let bend = Nonlinearity { coefficients };
        // An upper bound of how fast the slope changes: the sum of k (k - 1) |c_k|.
        let mut change = 0.0;
        const_for!(0..K, |k| {
            let power = (k + 2) as f32;
            change += power * (power - 1.0) * coefficients[k].abs();
        });
        if !change.is_finite() {
            return None;
        }
        let mut place = 0;
        while place <= 256 {
            let (_, slope) = bend.value_and_slope(place as f32 / 256.0);
            if slope <= change / 512.0 {
                return None;
            }
            place += 1;
        }
        Some(bend)
    }

    /// Computes the signal, 0..=1, of what was read. See the [example](#example).
    ///
    /// `None` below the reading of zero and above that of full scale. NaN stays NaN.
    ///
    /// # Accuracy
    /// There and back 2^-23 times the sum of the sizes of all coefficients, 1 + |c2| + |c3| and so on, over
    /// the slope of the response where that is below 1 (searched in `tests/sensor/worst_readings.rs`).
    ///
    /// # Cost
    /// Newton's steps within a bracket: three to five for what sensors have, never more than 32.
    #[must_use]
    pub const fn signal(&self, read: f32) -> Option<f32> {
        let (mut low, mut high) = (0.0, 1.0);
        if read < 0.0 || read > self.read(1.0) {
            return None;
        }
        let mut signal = if read > 1.0 { 1.0 } else { read };
        let mut step = 0;
        while step < STEPS {
            let (value, slope) = self.value_and_slope(signal);
            if value < read {
                low = signal;
            } else {
                high = signal;
            }
            let next = signal - (value - read) / slope;
            // If Newton's step leaves the bracket or is NaN, its middle is nearer.
            let next = if next < low || next > high { 0.5 * (low + high) } else { next };
            if next == signal {
                break;
            }
            signal = next;
            step += 1;
        }
        Some(signal)
    }

    /// Computes what is read of a `signal` within 0..=1. See the [example](#example).
    #[must_use]
    #[inline]
    pub const fn read(&self, signal: f32) -> f32 {
        self.value_and_slope(signal).0
    }

    const fn value_and_slope(&self, x: f32) -> (f32, f32) {
        let (mut value, mut slope) = (0.0, 0.0);
        let mut k = K;
        while k > 0 {
            k -= 1;
            let power = (k + 2) as f32;
            slope = slope * x + power * self.coefficients[k];
            value = value * x + self.coefficients[k];
        }
        (x + value * x * x, 1.0 + slope * x)
    }
}
