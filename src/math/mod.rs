//! The elementary functions, as a type parameter.
//!
//! Two backends must fit in one program (to be compared, or because one step needs digits
//! and another speed), so a backend is a type and not a feature: [`Portable`] is what every
//! short name uses, and leaf functions have a `_with::<M>` form. Features only make more
//! backends available; no feature changes a number.

mod backend;
#[cfg(feature = "libm")]
mod libm;
#[cfg(feature = "micromath")]
mod micromath;
mod roots;

#[cfg(all(feature = "std", not(target_os = "none")))]
mod std;
mod turns;

pub use backend::Math;
pub use roots::{cbrt, sqrt};
pub use turns::{cos as cos_turns, sin as sin_turns};

#[cfg(feature = "libm")]
pub use self::libm::{Libm, Portable};
#[cfg(feature = "micromath")]
pub use self::micromath::Micromath;
#[cfg(all(feature = "std", not(target_os = "none")))]
pub use self::std::Std;
