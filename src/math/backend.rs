//! The trait of all math backends.

/// Provides the elementary functions on `f32` that this crate needs, as associated functions of a zero-sized
/// type.
///
/// Such a type is called a math backend. Give it as a type parameter to functions whose names end in `_with`,
/// as in `xyz.lab_with::<Fast>(white)`, or implement this trait to use the functions of another library.
///
/// In code that is generic over a backend `M` call the functions by name, as in `M::exp(x)`, and never as
/// methods: in a test build a method of the standard library silently takes the place of an extension method.
///
/// # Example
/// ```
/// use nanospectra::math::{Fast, Math};
///
/// /// A backend that takes the exponential function from elsewhere, and the rest from `Fast`.
/// #[derive(Clone, Copy)]
/// struct Mine;
///
/// impl Math for Mine {
///     fn exp(x: f32) -> f32 {
///         f64::from(x).exp() as f32
///     }
///     fn expm1(x: f32) -> f32 {
///         f64::from(x).exp_m1() as f32
///     }
///     fn sqrt(x: f32) -> f32 {
///         Fast::sqrt(x)
///     }
///     fn cbrt(x: f32) -> f32 {
///         Fast::cbrt(x)
///     }
///     fn ln(x: f32) -> f32 {
///         Fast::ln(x)
///     }
///     fn powf(x: f32, y: f32) -> f32 {
///         Fast::powf(x, y)
///     }
///     fn atan2(y: f32, x: f32) -> f32 {
///         Fast::atan2(y, x)
///     }
///     fn cos_turns(turns: f32) -> f32 {
///         Fast::cos_turns(turns)
///     }
///     fn sin_turns(turns: f32) -> f32 {
///         Fast::sin_turns(turns)
///     }
/// }
///
/// let depth = nanospectra::Reflectance::<16>::flat(-1.0);
/// assert_eq!(depth.exp_with::<Mine>()[0], 0.367_879_44);
/// ```
pub trait Math: Copy + 'static {
    /// Returns the square root of `x`, or NaN below zero. See the [example](crate::math#example).
    fn sqrt(x: f32) -> f32;
    /// Returns the cube root of `x`, with the sign of `x`. See the [example](crate::math#example).
    fn cbrt(x: f32) -> f32;
    /// Returns e to the power of `x`. See the [example](crate::math#example).
    fn exp(x: f32) -> f32;
    /// Returns `exp(x) - 1`, without the cancellation near zero.
    fn expm1(x: f32) -> f32;
    /// Returns the natural logarithm of `x`.
    fn ln(x: f32) -> f32;
    /// Returns `x` to the power of `y`, for `x >= 0`. See the [example](crate::math#example).
    fn powf(x: f32, y: f32) -> f32;
    /// Returns the angle of the point (`x`, `y`) in radians, from -pi to pi.
    fn atan2(y: f32, x: f32) -> f32;
    /// Returns the cosine of an angle that is given in turns, where 1 turn is 360 degrees. See the
    /// [example](crate::math#example).
    fn cos_turns(turns: f32) -> f32;
    /// Returns the sine of an angle that is given in turns, where 1 turn is 360 degrees. See the
    /// [example](crate::math#example).
    fn sin_turns(turns: f32) -> f32;
}
