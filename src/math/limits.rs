//! Limits below and above a number, where NaN stays NaN.

/// Returns `x`, or `floor` if `x` is less; NaN stays NaN.
pub(crate) fn at_least(x: f32, floor: f32) -> f32 {
    if x < floor { floor } else { x }
}

/// Returns `x`, or `ceiling` if `x` is more; NaN stays NaN.
pub(crate) fn at_most(x: f32, ceiling: f32) -> f32 {
    if x > ceiling { ceiling } else { x }
}
