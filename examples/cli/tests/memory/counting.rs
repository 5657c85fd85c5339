//! An allocator that counts.

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// The allocator of the system, which counts the bytes that are in use, and the allocations.
pub struct Counting;

static IN_USE: AtomicUsize = AtomicUsize::new(0);
static MOST: AtomicUsize = AtomicUsize::new(0);
static ALLOCATIONS: AtomicUsize = AtomicUsize::new(0);

/// Returns the largest number of bytes that were in use, and the number of allocations.
pub fn said() -> String {
    format!("{} {}", MOST.load(Relaxed), ALLOCATIONS.load(Relaxed))
}

fn takes(bytes: usize) {
    ALLOCATIONS.fetch_add(1, Relaxed);
    let in_use = IN_USE.fetch_add(bytes, Relaxed) + bytes;
    MOST.fetch_max(in_use, Relaxed);
}

// SAFETY: each call is passed on to the allocator of the system as it is.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        takes(layout.size());
        // SAFETY: the caller keeps what `alloc` asks for.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        IN_USE.fetch_sub(layout.size(), Relaxed);
        // SAFETY: the caller keeps what `dealloc` asks for, and the pointer is one of the system's.
        unsafe { System.dealloc(pointer, layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, new_size: usize) -> *mut u8 {
        // Old and new are in use together while one is copied to the other.
        takes(new_size);
        IN_USE.fetch_sub(layout.size(), Relaxed);
        // SAFETY: the caller keeps what `realloc` asks for, and the pointer is one of the system's.
        unsafe { System.realloc(pointer, layout, new_size) }
    }
}
