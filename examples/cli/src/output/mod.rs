//! Printing what was found: for people as text, for programs as JSON.

pub mod json;
pub mod plot;
mod progress;
pub mod report;
pub mod terminal;
pub mod tint;

pub use progress::Progress;
pub use report::Report;
