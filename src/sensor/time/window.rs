//! A window over the last readings, in fixed memory.

// (HistoryBuf says the same in fewer words, but its indexing leaves a panic in the program.)
use heapless::Deque;

/// The last `CAP` readings of one quantity: lux, a channel, a color temperature. Needs the feature
/// `heapless`.
///
/// ```
/// # use nanospectra::sensor::{Flicker, Window};
/// let mut lux = Window::<5>::new();
/// for reading in [7.0, 300.0, 302.0, 9000.0, 298.0, 301.0] {
///     lux.push(reading);
/// }
/// assert_eq!(lux.median(), Some(301.0)); // the 7 is forgotten, the 9000 does not count for much
/// assert!(Flicker::of(lux.iter(), 1000.0, 250.0).is_some());
/// ```
#[derive(Clone, Debug, Default)]
pub struct Window<const CAP: usize>(Deque<f32, CAP>);

impl<const CAP: usize> Window<CAP> {
    /// A window without readings.
    #[must_use]
    pub const fn new() -> Self {
        Window(Deque::new())
    }

    /// Adds a reading; when the window is full the oldest is forgotten.
    pub fn push(&mut self, reading: f32) {
        if self.0.is_full() {
            self.0.pop_front();
        }
        // There is room now: a window of no readings does not compile.
        let _ = self.0.push_back(reading);
    }

    /// Forgets all readings: after a change of exposure, say.
    pub fn clear(&mut self) {
        self.0.clear();
    }

    /// The number of readings, 0..=`CAP`.
    #[must_use]
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether a further reading makes the oldest one forgotten.
    #[must_use]
    pub fn is_full(&self) -> bool {
        self.0.is_full()
    }

    /// The newest reading.
    #[must_use]
    pub fn last(&self) -> Option<f32> {
        self.0.back().copied()
    }

    /// The readings, oldest first: for [`Flicker::of`](crate::sensor::Flicker::of) and
    /// [`mean_over_periods`](crate::sensor::mean_over_periods).
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = &f32> + Clone {
        let (older, newer) = self.0.as_slices();
        older.iter().chain(newer)
    }

    /// The mean of the readings; `None` without any. NaN stays NaN.
    #[must_use]
    pub fn mean(&self) -> Option<f32> {
        if self.is_empty() {
            return None;
        }
        // About one of them: large readings that hardly differ keep their digits.
        let about = self.last()?;
        Some(about + self.iter().map(|reading| reading - about).sum::<f32>() / self.len() as f32)
    }

    /// The median of the readings, which is the mean of the middle two of an even number. `None` without any,
    /// NaN if there is one.
    ///
    /// # Cost
    /// `CAP` times `CAP` comparisons; no memory, nothing is sorted.
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

    /// The reading that would stand at this place if they were sorted.
    fn ranked(&self, place: usize) -> Option<f32> {
        self.iter().copied().find(|reading| {
            let below = self.iter().filter(|other| *other < reading).count();
            let same = self.iter().filter(|other| *other == reading).count();
            below <= place && place < below + same
        })
    }
}
