//! Memory at fixed addresses, which JavaScript can also read and write.

use core::cell::UnsafeCell;

/// The memory of one module, which has a single thread.
pub struct Fixed<T>(UnsafeCell<T>);

// SAFETY: there is no other thread to share it with.
unsafe impl<T> Sync for Fixed<T> {}

impl<T> Fixed<T> {
    pub const fn new(value: T) -> Self {
        Fixed(UnsafeCell::new(value))
    }

    /// Returns all of it, for the one export that is running.
    #[expect(clippy::mut_from_ref, reason = "fixed memory that JavaScript writes to as well")]
    pub fn get(&self) -> &mut T {
        // SAFETY: exports do not call each other, and each calls this once.
        unsafe { &mut *self.0.get() }
    }
}
