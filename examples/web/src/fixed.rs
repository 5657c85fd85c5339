//! Memory at fixed addresses, which JavaScript can also read and write.

use core::cell::{RefCell, RefMut};

// Modules of several threads would share this memory.
#[cfg(target_feature = "atomics")]
compile_error!("this memory belongs to a module with a single thread, which the feature `atomics` gives up");

/// The memory of one module, which has a single thread. JavaScript uses it while no export is running.
pub struct Fixed<T>(RefCell<T>);

// SAFETY: there is no other thread to share it with.
unsafe impl<T> Sync for Fixed<T> {}

impl<T> Fixed<T> {
    pub const fn new(value: T) -> Self {
        Fixed(RefCell::new(value))
    }

    /// Returns where it is, for JavaScript.
    pub fn address(&self) -> *mut T {
        self.0.as_ptr()
    }

    /// Returns all of it, until what is returned is dropped. The module stops if it is in use already, which
    /// would be a mistake in the module.
    pub fn get(&self) -> RefMut<'_, T> {
        match self.0.try_borrow_mut() {
            Ok(all) => all,
            Err(_) => core::arch::wasm32::unreachable(),
        }
    }
}
