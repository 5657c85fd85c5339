//! What the numbers of a file are.

mod axis;
mod product;
mod value;
mod words;

pub use axis::{AxisUnit, names_axis};
pub use value::{Quantity, Unit};
pub(crate) use words::{brackets, plain};

/// The wavelengths in nm that are taken for such if nothing is said: from the shortest ultraviolet of
/// spectrometers to the end of solar tables.
pub(crate) const LIKELY: std::ops::RangeInclusive<f64> = 120.0..=4500.0;
