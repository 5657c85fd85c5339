//! A spectrum as N numbers: the type, and the ways to make one.

mod arithmetic;
#[cfg(feature = "heapless")]
mod collect;
mod integrand;
mod interpolate;
mod lines;
mod quantity;
mod resample;
mod samples;
mod series;

#[cfg(feature = "heapless")]
pub use collect::{PushError, Samples};
pub use interpolate::Interpolation;
pub use quantity::{Factor, Outside, PerBin, Power, Quantity, RefractiveIndex};
pub use samples::SamplesError;
pub use series::{Fine, Light, Reflectance, Spectrum};

#[cfg(feature = "libm")]
pub(crate) use interpolate::{BEYOND, quintic};
