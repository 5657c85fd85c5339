//! What the numbers of a file are.

mod axis;
mod product;
mod value;
mod words;

pub use axis::{AxisUnit, names_axis};
pub use value::{Quantity, Unit};
pub(crate) use words::{brackets, plain};
