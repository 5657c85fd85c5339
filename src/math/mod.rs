//! The elementary functions, as a type parameter.
//!
//! Two backends must fit in one program (to be compared, or because one step needs digits and another speed),
//! so a backend is a type and not a feature: [`Portable`] is what every short name uses, and leaf functions
//! have a `_with::<M>` form. [`Fast`] is always there, in own f32 kernels of half the instructions; features
//! only make more backends available, and no feature changes a number.

mod backend;
mod complex;
mod const_for;
mod const_unwrap;
mod double;
mod fast;
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
