//! For what the compiler vectorises: an array of eight lanes becomes two 128-bit registers, or
//! one of 256 bits.

use super::reduce;

/// All rows against one spectrum, one row after the other: LLVM mixes the lanes of several.
#[inline]
pub(in crate::observer) fn rows<const C: usize, const N: usize>(
    rows: &[[f32; N]; C],
    s: &[f32; N],
) -> [f32; C] {
    let mut sums = [0.0; C];
    for (sum, row) in sums.iter_mut().zip(rows) {
        *sum = dot(row, s);
    }
    sums
}

/// The rest after whole eights is filled up with zeros, which leaves every sum as it is. Eight
/// named scalars are as fast at some `N` and take three times as long at 81.
#[inline(never)]
fn dot<const N: usize>(a: &[f32; N], b: &[f32; N]) -> f32 {
    let mut lanes = [0.0; 8];
    let (a8, a_rest) = a.as_chunks::<8>();
    let (b8, b_rest) = b.as_chunks::<8>();
    for (a, b) in a8.iter().zip(b8) {
        add(&mut lanes, a, b);
    }
    if !N.is_multiple_of(8) {
        add(&mut lanes, &filled_up(a_rest), &filled_up(b_rest));
    }
    reduce_apart(&lanes)
}

/// Out of line: seen together with the loop, the reduction makes LLVM shuffle the lanes there (34 ns
/// where these take 24, for three rows at N = 81).
#[inline(never)]
fn reduce_apart(lanes: &[f32; 8]) -> f32 {
    reduce(lanes)
}

#[inline]
fn add(lanes: &mut [f32; 8], a: &[f32; 8], b: &[f32; 8]) {
    for (lane, (a, b)) in lanes.iter_mut().zip(a.iter().zip(b)) {
        *lane += a * b;
    }
}

/// Up to eight values, then zeros.
#[inline]
fn filled_up(rest: &[f32]) -> [f32; 8] {
    let mut eight = [0.0; 8];
    for (slot, value) in eight.iter_mut().zip(rest) {
        *slot = *value;
    }
    eight
}
