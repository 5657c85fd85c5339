//! Matter that moves light from one wavelength to another, at once or later.

mod donaldson;
mod dye;
mod phosphor;

pub use donaldson::Donaldson;
pub use dye::{Dye, FluorescenceError};
pub use phosphor::Phosphor;
