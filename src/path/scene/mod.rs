//! A path that is put together at run time.

mod parts;

mod walk;

mod fold;

mod bill;

mod budget;

mod part;

pub use bill::BillLine;
pub use budget::WithinBudget;
pub use fold::PolarizationError;
pub use part::{IntoPart, Part};
pub use parts::{Scene, SceneFullError};
