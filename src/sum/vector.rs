//! The sums in explicit vectors of the crate `wide`, with all rows in one pass over the spectrum.

use crate::sum::reduce;
use wide::f32x8;

/// All rows against one spectrum. Each lane adds the same numbers as a lane of the other kernels.
#[inline]
pub(crate) fn rows<const C: usize, const N: usize>(rows: &[[f32; N]; C], s: &[f32; N]) -> [f32; C] {
    let mut sums = [f32x8::ZERO; C];
    let (s8, s_rest) = s.as_chunks::<8>();
    for (k, s) in s8.iter().enumerate() {
        let s = f32x8::new(*s);
        for (sum, row) in sums.iter_mut().zip(rows) {
            let (row8, _) = row.as_chunks::<8>();
            if let Some(row) = row8.get(k) {
                *sum += f32x8::new(*row) * s;
            }
        }
    }
    let mut totals = [0.0; C];
    for (total, (sum, row)) in totals.iter_mut().zip(sums.iter().zip(rows)) {
        let mut lanes = sum.to_array();
        let (_, row_rest) = row.as_chunks::<8>();
        for (lane, (a, b)) in lanes.iter_mut().zip(row_rest.iter().zip(s_rest)) {
            *lane += a * b;
        }
        *total = reduce(&lanes);
    }
    totals
}
