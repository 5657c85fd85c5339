//! Fluorescent and phosphorescent matter, which emits light at other wavelengths than it absorbs.

mod donaldson;
mod dye;
mod phosphor;

pub use donaldson::Donaldson;
pub use dye::{Dye, FluorescenceError};
pub use phosphor::Phosphor;
