//! The larger and the smaller of two numbers, where NaN stays NaN.

/// `x`, or `floor` if it is less; NaN stays.
pub(crate) fn at_least(x: f32, floor: f32) -> f32 {
    if x < floor { floor } else { x }
}

/// `x`, or `ceiling` if it is more; NaN stays.
pub(crate) fn at_most(x: f32, ceiling: f32) -> f32 {
    if x > ceiling { ceiling } else { x }
}
