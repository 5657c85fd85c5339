//! A window over the last readings, in fixed memory.

// (`HistoryBuf` would need fewer words, but its indexing leaves a panic in the program.)
use heapless::Deque;

/// Keeps the last `CAP` readings of one quantity, such as lux, a channel or a color temperature, in fixed
/// memory.
///
/// [`push`](Self::push) adds a reading. [`median`](Self::median) is what to show of a light that is disturbed
/// now and then, [`mean`](Self::mean) of one that is noisy. Needs the feature `heapless`.
///
/// # Example
///
/// ```
/// use nanospectra::sensor::{Flicker, Window};
///
/// let mut lux = Window::<5>::new();
/// for reading in [7.0, 300.0, 302.0, 9000.0, 298.0, 301.0] {
///     lux.push(reading);
/// }
/// assert_eq!((lux.len(), lux.is_full(), lux.last()), (5, true, Some(301.0)));
/// assert_eq!(lux.median(), Some(301.0)); // the 7 is forgotten, and one reading of 9000 does not matter
/// assert_eq!(lux.mean(), Some(2040.2)); // but for the mean it does
/// assert!(Flicker::of(lux.iter(), 1000.0, 250.0).is_some());
/// lux.clear();
/// assert!(lux.is_empty() && lux.median().is_none());
/// ```
#[derive(Clone, Debug, Default)]
pub struct Window<const CAP: usize>(Deque<f32, CAP>);

impl<const CAP: usize> Window<CAP> {
    /// Makes a window that does not hold any reading yet. See the [example](#example).
    #[must_use]
    pub const fn new() -> Self {
        Window(Deque::new())
    }

    /// Adds a reading and, when the window is full, forgets the oldest. See the [example](#example).
    pub fn push(&mut self, reading: f32) {
        if self.0.is_full() {
            self.0.pop_front();
        }
        // There is room now, because a window of no readings does not compile.
        let _ = self.0.push_back(reading);
    }

    /// Computes the median of the readings, which is the mean of the middle two of an even number. See the
    /// [example](#example).
    ///
    /// `None` without any reading, NaN if one of them is NaN.
    ///
    /// # Cost
    /// `CAP` times `CAP` comparisons; nothing is copied or sorted.
    #[must_use]
    pub fn median(&self) -> Option<f32> {
        if self.iter().any(|reading| reading.is_nan()) {
            return Some(f32::NAN);
        }
        let upper = self.ranked(self.len() / 2)?;
        if self.len() % 2 == 1 {
            return Some(upper);
        }
        let lower = self.ranked(self.len() / 2 - 1)?;
        Some(lower + 0.5 * (upper - lower))
    }

    /// Computes the mean of the readings, or `None` without any. See the [example](#example).
    ///
    /// NaN stays NaN.
    #[must_use]
    pub fn mean(&self) -> Option<f32> {
        if self.is_empty() {
            return None;
        }
        // Deviations from one of them are added, so that large readings that hardly differ keep their digits.
        let about = self.last()?;
        Some(about + self.iter().map(|reading| reading - about).sum::<f32>() / self.len() as f32)
    }

    /// Returns the newest reading, or `None` without any. See the [example](#example).
    #[must_use]
    pub fn last(&self) -> Option<f32> {
        self.0.back().copied()
    }

    /// Returns the readings, the oldest first, as [`Flicker::of`](crate::sensor::Flicker::of) and
    /// [`mean_over_periods`](crate::sensor::mean_over_periods) take them. See the [example](#example).
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = &f32> + Clone {
        let (older, newer) = self.0.as_slices();
        older.iter().chain(newer)
    }

    /// Returns the number of readings, 0..=`CAP`. See the [example](#example).
    #[must_use]
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Returns whether the window holds no reading. See the [example](#example).
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Returns whether one more reading would push out the oldest. See the [example](#example).
    #[must_use]
    pub fn is_full(&self) -> bool {
        self.0.is_full()
    }

    /// Removes all readings, for instance after a change of exposure. See the [example](#example).
    pub fn clear(&mut self) {
        self.0.clear();
    }

    /// The reading that would stand at this place if all were sorted.
    fn ranked(&self, place: usize) -> Option<f32> {
        self.iter().copied().find(|reading| {
            let below = self.iter().filter(|other| *other < reading).count();
            let same = self.iter().filter(|other| *other == reading).count();
            below <= place && place < below + same
        })
    }
}
