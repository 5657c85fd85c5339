//! Measures how much stack a call needs: fills the memory below the stack pointer with a pattern, calls, and
//! looks how far down the pattern was overwritten.
//!
//! This works on any board. Memory that a call reserves but never writes keeps the pattern, so the result can
//! be a little too small: of the [large calls](crate::large) by at most 48 bytes, which was found by
//! interrupting them every 251 instructions and noting the lowest stack pointer.

use crate::clock::{Erased, erase};
use core::arch::asm;
use core::hint::black_box;
use core::ptr::with_exposed_provenance_mut;

const PAINT: u32 = 0x5ac3_96e1;
/// How many words are filled at most, which are 64 KiB. The smallest board has fewer.
const WORDS: usize = 16 * 1024;

unsafe extern "C" {
    /// The first word behind the statics, by the linker scripts of both architectures.
    #[link_name = "__sheap"]
    static FREE: u32;
}

/// Returns the bytes of stack below the caller's that `f` takes to get from `input` to `output`, or `None` if
/// that is more than can be measured.
///
/// The apparent need of a function that does nothing is subtracted.
pub fn needs<A, R>(f: fn(&A, &mut R), input: &A, output: &mut R) -> Option<usize> {
    let none = depth(nothing, &(), &mut ())?;
    Some(depth(f, input, output)?.saturating_sub(none))
}

#[inline(never)]
fn nothing(_: &(), _: &mut ()) {}

fn depth<A, R>(f: fn(&A, &mut R), input: &A, output: &mut R) -> Option<usize> {
    painted(erase(f), (&raw const *input).cast(), (&raw mut *output).cast())
}

/// Fills the memory, calls a function and returns the bytes that it has overwritten, unless these are all.
/// Only `f` is called from this frame, so everything else stays above the pattern.
#[inline(never)]
fn painted(f: Erased, input: *const (), output: *mut ()) -> Option<usize> {
    let (f, input) = black_box((f, input));
    let top = stack_pointer();
    let words = ((top - (&raw const FREE).addr()) / 4).min(WORDS);
    for word in 1..=words {
        // SAFETY: the word is below the stack pointer and above the statics, and no interrupt that could use
        // it is enabled.
        unsafe { with_exposed_provenance_mut::<u32>(top - 4 * word).write_volatile(PAINT) };
    }
    f(input, output);
    let mut used = words;
    // SAFETY: as above.
    while used > 0 && unsafe { with_exposed_provenance_mut::<u32>(top - 4 * used).read_volatile() } == PAINT {
        used -= 1;
    }
    (used < words).then_some(4 * used)
}

#[inline(always)]
fn stack_pointer() -> usize {
    let top;
    // SAFETY: the instruction only reads a register.
    unsafe {
        #[cfg(target_arch = "arm")]
        asm!("mov {}, sp", out(reg) top, options(nomem, nostack, preserves_flags));
        #[cfg(target_arch = "riscv32")]
        asm!("mv {}, sp", out(reg) top, options(nomem, nostack, preserves_flags));
    }
    top
}
