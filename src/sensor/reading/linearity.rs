//! Read-outs that are not linear: what they report falls short of the light as it grows.
//!
//! A path and an observer are linear, so both fold; a read-out is not, and never does. It is applied to what
//! the observer sees, channel by channel, and undone on what a chip reports before anything else is.

use crate::math::const_for;

/// A counter that misses what arrives while it is busy with an event before (non-paralysable dead time):
/// photon counters, and chips that turn light into a frequency.
///
/// ```
/// use nanospectra::sensor::DeadTime;
/// // 50 ns: of a million photons a second one in 21 is missed.
/// let counter = DeadTime::new(50e-9);
/// let counted = counter.counted(1e6);
/// assert!((counted - 1e6 / 1.05).abs() < 1.0);
/// assert!((counter.arrived(counted).unwrap() - 1e6).abs() < 1.0);
/// // 20 million a second is all that it can count.
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
    /// A counter that is busy for so many seconds after each event; a negative time counts as zero. NaN stays
    /// NaN.
    #[must_use]
    pub const fn new(seconds: f32) -> Self {
        DeadTime { seconds: if seconds < 0.0 { 0.0 } else { seconds } }
    }

    /// Events counted per second of `arriving` ones, zero or more; below one in every dead time. NaN stays
    /// NaN.
    ///
    /// # Accuracy
    /// 2 units of 2^-24.
    #[must_use]
    #[inline]
    pub const fn counted(&self, arriving: f32) -> f32 {
        let busy = self.seconds * arriving;
        // So many that the counter is always busy; and infinity over infinity is no number.
        if busy == f32::INFINITY || arriving == f32::INFINITY {
            return 1.0 / self.seconds;
        }
        arriving / (1.0 + busy)
    }

    /// Events that arrived per second, of `counted` ones; `None` from one count in every dead time on, where
    /// any number may have arrived. NaN stays NaN.
    ///
    /// # Accuracy
    /// There and back 2 units in the last place while a sixth of the time is dead at most, 4 up to half of
    /// it; close to the pole a rounding of what is counted is one over the live share of the time larger in
    /// what arrived.
    #[must_use]
    #[inline]
    pub const fn arrived(&self, counted: f32) -> Option<f32> {
        // (Zero times infinity is no time: an ideal counter counts them all.)
        let dead = if self.seconds == 0.0 { 0.0 } else { self.seconds * counted };
        let live = 1.0 - dead;
        if live <= 0.0 { None } else { Some(counted / live) }
    }
}

/// A response that is not linear: what is read of a signal `x` of full scale 1 is `x + c2 x^2 + c3 x^3 ..`,
/// rising throughout. Photodiodes near saturation, amplifiers, converters.
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
    /// From the coefficients of x^2, x^3 ..; `None` if one is not finite or if the response does not rise
    /// everywhere in 0..=1.
    ///
    /// That is judged at 257 places between which the slope must not be able to reach zero by its own bound
    /// on how it changes; so a response whose slope comes within some thousandths of zero may be refused too.
    #[must_use]
    pub const fn new(coefficients: [f32; K]) -> Option<Self> {
        let bend = Nonlinearity { coefficients };
        // How fast the slope can change at most: sum of k (k - 1) |c_k|.
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

    /// The reading of `signal`, which is 0..=1.
    #[must_use]
    #[inline]
    pub const fn read(&self, signal: f32) -> f32 {
        self.value_and_slope(signal).0
    }

    /// The signal, 0..=1, of what is read; `None` outside what full scale and zero read. NaN stays NaN.
    ///
    /// # Accuracy
    /// There and back 2 units in the last place of full scale over the slope of the response.
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
            // Out of the bracket, or NaN: half way is always nearer.
            let next = if next < low || next > high { 0.5 * (low + high) } else { next };
            if next == signal {
                break;
            }
            signal = next;
            step += 1;
        }
        Some(signal)
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
