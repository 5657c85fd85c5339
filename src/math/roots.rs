//! Square root and cube root in integer and `f32` arithmetic alone. They have the same bits on every target,
//! and do not need the emulated f64 that `libm::cbrtf` uses on a Cortex-M4F (1620 instructions there).

#[cfg(all(target_arch = "arm", target_os = "none", target_abi = "eabihf"))]
use crate::math::vsqrt::sqrt as quickest_sqrt;
#[cfg(all(
    feature = "libm",
    not(target_arch = "wasm32"),
    not(all(target_arch = "arm", target_os = "none", target_abi = "eabihf"))
))]
use libm::sqrtf as quickest_sqrt;
// (In WebAssembly `libm` brings a table of 256 bytes for this, which is more than many pages need of the rest
// of this crate.)
#[cfg(not(any(
    all(feature = "libm", not(target_arch = "wasm32")),
    all(target_arch = "wasm32", target_feature = "simd128"),
    all(target_arch = "arm", target_os = "none", target_abi = "eabihf")
)))]
use sqrt_by_digits as quickest_sqrt;

/// In stable Rust WebAssembly has a square root for vectors only.
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
fn quickest_sqrt(x: f32) -> f32 {
    use core::arch::wasm32::{f32x4_extract_lane, f32x4_splat, f32x4_sqrt};
    f32x4_extract_lane::<0>(f32x4_sqrt(f32x4_splat(x)))
}

/// Returns the correctly rounded square root of `x`, or NaN below zero.
///
/// The root of `-0.0` is `-0.0`. See the [example](crate::math#example).
///
/// # Accuracy
/// Half a unit in the last place, for every `f32` (compared with the hardware's root in
/// `tests/spectrum/every_f32.rs`).
///
/// # Cost
/// One instruction of the processor on an Arm microcontroller with FPU, in WebAssembly with simd128 and, with
/// the feature `libm`, on x86-64. Elsewhere it is `libm::sqrtf` with that feature; without the feature, and
/// in WebAssembly without vectors, the root is computed digit by digit. All of these are correctly rounded,
/// so they return the same number.
#[must_use]
#[inline]
pub fn sqrt(x: f32) -> f32 {
    quickest_sqrt(x)
}

/// Computes the root digit by digit in integers, which also works where a constant is computed.
pub(crate) const fn sqrt_by_digits(x: f32) -> f32 {
    let bits = x.to_bits();
    if bits >= 0x7f80_0000 || bits == 0 {
        // NaN, +inf and -0 are their own roots. Other negative numbers have no root.
        return if bits == 0x8000_0000 || bits <= 0x7f80_0000 || x.is_nan() { x } else { f32::NAN };
    }
    // With x = m * 2^e, where e is even and m lies in [2^23, 2^25), root(x) = root(m) * 2^(e/2).
    let mut exponent = (bits >> 23) as i32;
    let mut mantissa = bits & 0x007f_ffff;
    if exponent == 0 {
        let shift = mantissa.leading_zeros() as i32 - 8;
        mantissa <<= shift;
        exponent = 1 - shift;
    } else {
        mantissa |= 0x0080_0000;
    }
    exponent -= 127;
    if exponent & 1 != 0 {
        mantissa <<= 1;
    }
    // 25 bits of the root are found one by one: 24 are kept and one is for rounding. The remainder says
    // whether more would follow.
    let mut rest = mantissa << 1;
    let (mut root, mut sum, mut digit) = (0u32, 0u32, 0x0100_0000u32);
    while digit != 0 {
        let trial = sum + digit;
        if trial <= rest {
            sum = trial + digit;
            rest -= trial;
            root += digit;
        }
        rest <<= 1;
        digit >>= 1;
    }
    // A root never lies exactly half way between two numbers, so an odd last bit with a remainder rounds up.
    if rest != 0 {
        root += root & 1;
    }
    f32::from_bits((root >> 1).wrapping_add((((exponent >> 1) + 126) as u32) << 23))
}

/// Returns the cube root of any finite `x`, with the sign of `x`.
///
/// See the [example](crate::math#example).
///
/// # Accuracy
/// 2.4e-7 relative, which is four units of 2^-24 (`tests/spectrum/every_f32.rs`).
///
/// # Cost
/// 42 instructions on a Cortex-M4F, 61 at opt-level "s".
#[must_use]
pub fn cbrt(x: f32) -> f32 {
    let bits = x.to_bits() & 0x7fff_ffff;
    let sign = x.to_bits() & 0x8000_0000;
    if bits >= 0x7f80_0000 || bits == 0 {
        return x;
    }
    // Subnormals are multiplied by 2^24, and their root is divided by 2^8. For the largest numbers it is the
    // other way round, because the step below adds three cubes.
    let (size, scale) = if bits < 0x0080_0000 {
        (f32::from_bits(bits) * 16_777_216.0, 0.003_906_25)
    } else if bits >= 0x7e00_0000 {
        (f32::from_bits(bits) / 16_777_216.0, 256.0)
    } else {
        (f32::from_bits(bits), 1.0)
    };
    // A third of the exponent gives the root to 5 %. Halley's step cubes the error, and is done twice.
    let mut root = f32::from_bits(size.to_bits() / 3 + 0x2a51_19f2);
    let mut steps = 0;
    while steps < 2 {
        let cube = root * root * root;
        root *= (cube + size + size) / (cube + cube + size);
        steps += 1;
    }
    f32::from_bits((root * scale).to_bits() | sign)
}

#[cfg(test)]
mod tests {
    extern crate std;

    /// This compares two binades at a stride (every other root is one of theirs with another exponent), and
    /// numbers of all sizes at a larger stride.
    #[test]
    fn the_root_by_digits_is_the_hardwares() {
        let binades = (1.0f32.to_bits()..=4.0f32.to_bits()).step_by(5);
        let edges = [0, 1, 0x8000_0000, 0x8000_0001, 0x7f7f_ffff, 0x7f80_0000, 0xff80_0000, 0x7fc0_0000];
        let mut count = 0;
        for bits in binades.chain((0..=u32::MAX).step_by(1009)).chain(edges) {
            let x = f32::from_bits(bits);
            let (own, hardware) = (super::sqrt_by_digits(x), std::primitive::f32::sqrt(x));
            let same = own.to_bits() == hardware.to_bits() || own.is_nan() && hardware.is_nan();
            assert!(same, "{x:e} ({bits:#010x}): {own:e}, the hardware says {hardware:e}");
            count += 1;
        }
        assert!(count > 7_000_000, "{count}");
        const { assert!(super::sqrt_by_digits(2.0).to_bits() == core::f32::consts::SQRT_2.to_bits()) }
    }
}
