//! Measures how much stack a call needs: fills the memory below the stack pointer with a pattern, calls, and
//! looks how far down the pattern was overwritten.
//!
//! This works on any board. Memory that a call reserves but never writes keeps the pattern, so the result can
//! be a little too small.

use crate::clock::{Erased, erase};
use core::arch::asm;
use core::hint::black_box;
use core::ptr::with_exposed_provenance_mut;

const PAINT: u32 = 0x5ac3_96e1;
/// How many words are filled: 4 KiB, which the smallest board can spare.
const WORDS: usize = 1024;

/// Returns the bytes of stack below the caller's that `f` takes to get from `input` to `output`.
///
/// The apparent need of a function that does nothing is subtracted.
pub fn needs<A, R>(f: fn(&A, &mut R), input: &A, output: &mut R) -> usize {
    depth(f, input, output).saturating_sub(depth(nothing, &(), &mut ()))
}

#[inline(never)]
fn nothing(_: &(), _: &mut ()) {}

fn depth<A, R>(f: fn(&A, &mut R), input: &A, output: &mut R) -> usize {
    painted(erase(f), (&raw const *input).cast(), (&raw mut *output).cast())
}

/// Fills the memory, calls a function and returns the bytes that it has overwritten. Only `f` is called from
/// this frame, so everything else stays above the pattern.
#[inline(never)]
fn painted(f: Erased, input: *const (), output: *mut ()) -> usize {
    let (f, input) = black_box((f, input));
    let top = stack_pointer();
    for word in 1..=WORDS {
        // SAFETY: the word is below the stack pointer and above the statics, and no interrupt that could use
        // it is enabled.
        unsafe { with_exposed_provenance_mut::<u32>(top - 4 * word).write_volatile(PAINT) };
    }
    f(input, output);
    let mut used = WORDS;
    // SAFETY: as above.
    while used > 0 && unsafe { with_exposed_provenance_mut::<u32>(top - 4 * used).read_volatile() } == PAINT {
        used -= 1;
    }
    4 * used
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
