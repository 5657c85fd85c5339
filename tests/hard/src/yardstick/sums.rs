//! Sums of products, in the order that comes to mind and in the order that textbooks advise.
//!
//! # Reference
//! N. J. Higham, "The accuracy of floating point summation", SIAM J. Sci. Comput. 14 (1993): the error grows
//! with the number of terms one after the other, and with its logarithm pairwise.

/// One after the other; of two slices of one length.
#[must_use]
pub fn naive(a: &[f32], b: &[f32]) -> f32 {
    let mut sum = 0.0;
    for (a, b) in a.iter().zip(b) {
        sum += a * b;
    }
    sum
}

/// The sum of the halves, down to 32 terms or fewer, which go one after the other: with fewer the calls cost
/// more than the sums.
#[must_use]
pub fn pairwise(a: &[f32], b: &[f32]) -> f32 {
    let half = a.len() / 2;
    match (a.split_at_checked(half), b.split_at_checked(half)) {
        (Some((a0, a1)), Some((b0, b1))) if a.len() > 32 => pairwise(a0, b0) + pairwise(a1, b1),
        _ => naive(a, b),
    }
}
