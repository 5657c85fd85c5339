//! A path that is chosen at run time.

mod bill;
mod budget;
mod fold;
mod part;
mod parts;
mod walk;

pub use bill::BillLine;
pub use budget::WithinBudget;
pub use fold::PolarizationError;
pub use part::{IntoPart, Part};
pub use parts::{Scene, SceneFullError};
