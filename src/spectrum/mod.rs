//! A spectrum as `N` numbers: the type, what its numbers mean, and the ways to make one.

// The documentation of `Spectrum` lists methods in the order of these modules, so what one calls first stands
// first. Empty lines keep rustfmt from sorting them.
mod samples;

mod series;

mod interpolate;

mod resample;

mod lines;

mod arithmetic;

mod integrand;
mod quantity;

#[cfg(feature = "heapless")]
mod collect;

#[cfg(feature = "heapless")]
pub use collect::{PushError, Samples};
pub use interpolate::Interpolation;
pub use quantity::{Factor, Outside, PerBin, Power, Quantity, RefractiveIndex};
pub use samples::SamplesError;
pub use series::{Fine, Light, Reflectance, Spectrum};

#[cfg(feature = "libm")]
pub(crate) use interpolate::{BEYOND, quintic};
