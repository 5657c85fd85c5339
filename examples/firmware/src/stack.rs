//! How much stack a call needs: paint what lies below, call, and see how deep the paint is gone.
//!
//! Works on any board. What a call reserves but never writes keeps its paint, so a little may be missing.

use crate::clock::{Erased, erase};
use core::arch::asm;
use core::hint::black_box;
use core::ptr::with_exposed_provenance_mut;

const PAINT: u32 = 0x5ac3_96e1;
/// 4 KiB: what the smallest board has to spare.
const WORDS: usize = 1024;

/// Bytes of stack below the caller's that `f` takes to get from `input` to `output`.
///
/// What a function that does nothing seems to take is taken off.
pub fn needs<A, R>(f: fn(&A, &mut R), input: &A, output: &mut R) -> usize {
    depth(f, input, output).saturating_sub(depth(nothing, &(), &mut ()))
}

#[inline(never)]
fn nothing(_: &(), _: &mut ()) {}

fn depth<A, R>(f: fn(&A, &mut R), input: &A, output: &mut R) -> usize {
    painted(erase(f), (&raw const *input).cast(), (&raw mut *output).cast())
}

/// One frame for every call that is measured. Nothing but `f` is called from it: all else stays above the
/// paint.
#[inline(never)]
fn painted(f: Erased, input: *const (), output: *mut ()) -> usize {
    let (f, input) = black_box((f, input));
    let top = stack_pointer();
    for word in 1..=WORDS {
        // SAFETY: below the stack pointer and above the statics; no interrupt is enabled that could be there.
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
    // SAFETY: reads a register.
    unsafe {
        #[cfg(target_arch = "arm")]
        asm!("mov {}, sp", out(reg) top, options(nomem, nostack, preserves_flags));
        #[cfg(target_arch = "riscv32")]
        asm!("mv {}, sp", out(reg) top, options(nomem, nostack, preserves_flags));
    }
    top
}
