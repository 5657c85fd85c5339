//! What a math backend has to provide.

/// Elementary functions on `f32`, as associated functions of a zero-sized type.
///
/// Call them by name, `M::exp(x)`, never as a method: in a test build an extension method
/// silently loses to the one of the standard library.
pub trait Math: Copy + 'static {
    /// Square root; NaN below zero.
    fn sqrt(x: f32) -> f32;
    /// Cube root, odd: `cbrt(-x) == -cbrt(x)`.
    fn cbrt(x: f32) -> f32;
    /// e to the power of `x`.
    fn exp(x: f32) -> f32;
    /// `exp(x) - 1` without the cancellation near zero.
    fn expm1(x: f32) -> f32;
    /// Natural logarithm.
    fn ln(x: f32) -> f32;
    /// `x` to the power of `y`, for `x >= 0`.
    fn powf(x: f32, y: f32) -> f32;
    /// The angle of the point (`x`, `y`), in radians, -pi..=pi.
    fn atan2(y: f32, x: f32) -> f32;
    /// The cosine of an angle given in turns (1 turn = 360 degrees).
    fn cos_turns(turns: f32) -> f32;
    /// The sine of an angle given in turns.
    fn sin_turns(turns: f32) -> f32;
}
