//! The sums for targets where the compiler vectorizes: an array of eight lanes becomes two registers of 128
//! bits, or one of 256 bits.
//!
//! Small changes of such code make LLVM's vectorizer up to five times slower. The form of these functions was
//! found by timing (three rows over N = 8..701, x86-64): the final reduction is out of line, what remains
//! after whole eights is filled up with zeros, and the rows are zipped inside the loop over the spectrum.

use crate::sum::reduce;

/// All rows against one spectrum. This takes one pass if the lanes of all rows fit into the 16 registers of a
/// baseline x86-64; otherwise it goes row by row.
#[inline]
pub(crate) fn rows<const C: usize, const N: usize>(rows: &[[f32; N]; C], s: &[f32; N]) -> [f32; C] {
    if C >= 2 && C <= 6 {
        return one_pass(rows, s);
    }
    let mut sums = [0.0; C];
    for (sum, row) in sums.iter_mut().zip(rows) {
        *sum = one_row(row, s);
    }
    sums
}

#[inline(never)]
fn one_row<const N: usize>(row: &[f32; N], s: &[f32; N]) -> f32 {
    let mut lanes = [0.0; 8];
    let (row8, row_rest) = row.as_chunks::<8>();
    let (s8, s_rest) = s.as_chunks::<8>();
    for (row, s) in row8.iter().zip(s8) {
        add(&mut lanes, row, s);
    }
    if !N.is_multiple_of(8) {
        add(&mut lanes, &filled_up(row_rest), &filled_up(s_rest));
    }
    let [sum] = reduce_apart(&[lanes]);
    sum
}

/// Each value of the spectrum is loaded once for all rows. Three rows at N = 401 take 63 ns in this way and
/// 90 ns row by row.
#[inline(never)]
fn one_pass<const C: usize, const N: usize>(rows: &[[f32; N]; C], s: &[f32; N]) -> [f32; C] {
    let mut lanes = [[0.0; 8]; C];
    let (s8, s_rest) = s.as_chunks::<8>();
    for (k, s) in s8.iter().enumerate() {
        for (lanes, row) in lanes.iter_mut().zip(rows) {
            let (row8, _) = row.as_chunks::<8>();
            if let Some(row) = row8.get(k) {
                add(lanes, row, s);
            }
        }
    }
    if !N.is_multiple_of(8) {
        // Adding 0 * 0 does not change a sum.
        let s = filled_up(s_rest);
        for (lanes, row) in lanes.iter_mut().zip(rows) {
            let (_, row_rest) = row.as_chunks::<8>();
            add(lanes, &filled_up(row_rest), &s);
        }
    }
    reduce_apart(&lanes)
}

/// This is out of line because LLVM would otherwise shuffle the lanes within the loop.
#[inline(never)]
fn reduce_apart<const C: usize>(lanes: &[[f32; 8]; C]) -> [f32; C] {
    let mut sums = [0.0; C];
    for (sum, lanes) in sums.iter_mut().zip(lanes) {
        *sum = reduce(lanes);
    }
    sums
}

#[inline]
fn add(lanes: &mut [f32; 8], a: &[f32; 8], b: &[f32; 8]) {
    for (lane, (a, b)) in lanes.iter_mut().zip(a.iter().zip(b)) {
        *lane += a * b;
    }
}

/// Up to eight values, followed by zeros.
#[inline]
fn filled_up(rest: &[f32]) -> [f32; 8] {
    let mut eight = [0.0; 8];
    for (slot, value) in eight.iter_mut().zip(rest) {
        *slot = *value;
    }
    eight
}
