//! Sums of products, taken one after the other and pairwise, as textbooks advise.
//!
//! # Reference
//! N. J. Higham, "The accuracy of floating point summation", SIAM J. Sci. Comput. 14 (1993): one after the
//! other the error grows with the number of terms, and pairwise with its logarithm.

/// Sums the products of two slices of the same length, one after the other.
#[must_use]
pub fn naive(a: &[f32], b: &[f32]) -> f32 {
    let mut sum = 0.0;
    for (a, b) in a.iter().zip(b) {
        sum += a * b;
    }
    sum
}

/// Sums the products of two slices by adding the sums of their halves, down to 32 terms or fewer, which are
/// summed one after the other. With smaller pieces the calls would cost more than the sums.
#[must_use]
pub fn pairwise(a: &[f32], b: &[f32]) -> f32 {
    let half = a.len() / 2;
    match (a.split_at_checked(half), b.split_at_checked(half)) {
        (Some((a0, a1)), Some((b0, b1))) if a.len() > 32 => pairwise(a0, b0) + pairwise(a1, b1),
        _ => naive(a, b),
    }
}
