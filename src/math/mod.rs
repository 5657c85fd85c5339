//! Elementary functions such as exp, pow and the cube root, and the choice of how they are computed.
//!
//! Use this module to choose between accuracy and speed on a small processor. A type that implements [`Math`]
//! is a *backend*. Functions of this crate that need an elementary function come in two forms: the short
//! name, such as [`Xyz::lab`](crate::color::Xyz::lab), uses the backend [`Portable`], and the name that ends
//! in `_with`, such as [`Xyz::lab_with`](crate::color::Xyz::lab_with), takes a backend as its type parameter.
//! Because a backend is a type and not a feature, one program can use several of them. Features only make
//! more backends available, and no feature changes a number.
//!
//! | backend | needs the feature | choose it |
//! |---|---|---|
//! | [`Fast`] | | on a microcontroller: f32 kernels of this crate that take about half the instructions |
//! | [`Portable`] | `libm` (default) | to have accurate digits and the same bits on every target |
//! | [`Libm`] | `libm` (default) | to compare with: all functions of the `libm` crate, some in slow f64 |
//! | [`Std`][struct@Std] | `std` | on a host, for the functions of its standard library |
//! | [`Micromath`] | `micromath` | to see what that crate's approximations do to colors |
//!
//! # Example
//! ```
//! use nanospectra::color::Xyz;
//! use nanospectra::math::{Fast, Math, cbrt, cos_turns, sin_turns, sqrt};
//!
//! // CIELAB of a gray under D65 by `Fast`; L* of Y = 18.42 is 50 (CIE 15).
//! let white = Xyz::new(95.047, 100.0, 108.883);
//! let lab = white.scaled(0.1842).lab_with::<Fast>(white).ok_or("no white")?;
//! assert!((lab.l - 50.0).abs() < 0.01);
//!
//! // A function of your own that is generic over the backend: the transmittance of a depth.
//! fn transmittance<M: Math>(depth: f32) -> f32 {
//!     M::exp(-depth)
//! }
//! assert!((transmittance::<Fast>(1.0) - 0.367_879_44).abs() < 1e-7);
//! assert!((Fast::powf(0.5, 2.4) - 0.189_464_57).abs() < 1e-7);
//!
//! // Functions that need no backend.
//! assert_eq!((sqrt(2.0), cbrt(-27.0)), (core::f32::consts::SQRT_2, -3.0));
//! assert_eq!((cos_turns(0.5), sin_turns(0.25)), (-1.0, 1.0)); // 180 and 90 degrees
//! # Ok::<(), &str>(())
//! ```
#![cfg_attr(
    not(all(feature = "std", not(target_os = "none"))),
    doc = "\n[struct@Std]: https://docs.rs/nanospectra/latest/nanospectra/math/struct.Std.html"
)]
#![cfg_attr(
    not(feature = "micromath"),
    doc = "\n[`Micromath`]: https://docs.rs/nanospectra/latest/nanospectra/math/struct.Micromath.html"
)]

mod backend;
mod complex;
mod const_for;
mod const_unwrap;
mod double;
mod fast;
mod length;
#[cfg(feature = "libm")]
mod libm;
mod limits;
#[cfg(feature = "micromath")]
mod micromath;
mod operators;
mod roots;

#[cfg(all(feature = "std", not(target_os = "none")))]
mod std;
mod turns;
#[cfg(all(target_arch = "arm", target_os = "none", target_abi = "eabihf"))]
mod vsqrt;

pub use backend::Math;
pub use complex::Complex;
pub(crate) use const_for::const_for;
pub(crate) use double::Double;
pub use fast::Fast;
pub(crate) use length::length;
pub(crate) use limits::{at_least, at_most};
pub(crate) use operators::{assigning_operator, linear_operators, operator};
pub(crate) use roots::sqrt_by_digits;
pub use roots::{cbrt, sqrt};
pub use turns::{cos as cos_turns, sin as sin_turns};

#[cfg(feature = "libm")]
pub use self::libm::{Libm, Portable};
#[cfg(feature = "micromath")]
pub use self::micromath::Micromath;
#[cfg(all(feature = "std", not(target_os = "none")))]
pub use self::std::Std;
