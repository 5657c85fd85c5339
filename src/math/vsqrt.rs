//! The square root instruction of the Arm FPU, which `core` does not offer in stable Rust.

use core::arch::asm;

/// Executes VSQRT.F32. It is correctly rounded, so the result is the same as in every other way to take the
/// root.
#[expect(unsafe_code, reason = "one instruction without access to memory; `core` has no square root")]
#[inline]
pub(super) fn sqrt(x: f32) -> f32 {
    let mut bits = x.to_bits();
    // SAFETY: every target with the ABI `eabihf` has the FPU, and s0 is declared as overwritten. (Stable Rust
    // accepts an FPU register as a clobber but not as an operand, so the value goes through a core register.)
    unsafe {
        asm!(
            "vmov s0, {0}",
            "vsqrt.f32 s0, s0",
            "vmov {0}, s0",
            inout(reg) bits,
            out("s0") _,
            options(pure, nomem, nostack),
        );
    }
    f32::from_bits(bits)
}
