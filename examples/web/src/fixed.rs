//! Memory at fixed addresses, which JavaScript reads and writes as well.

use core::cell::UnsafeCell;

/// Memory for one module, which has one thread.
pub struct Fixed<T>(UnsafeCell<T>);

// SAFETY: there is no other thread to share it with.
unsafe impl<T> Sync for Fixed<T> {}

impl<T> Fixed<T> {
    pub const fn new(value: T) -> Self {
        Fixed(UnsafeCell::new(value))
    }

    /// All of it, for the one export that is running.
    #[expect(clippy::mut_from_ref, reason = "fixed memory that JavaScript writes to as well")]
    pub fn get(&self) -> &mut T {
        // SAFETY: exports do not call each other, and each asks once.
        unsafe { &mut *self.0.get() }
    }
}
