//! Prints results, as text for people and as JSON for programs, and writes files.

mod files;
pub mod json;
pub mod number;
pub(crate) mod plot;
mod progress;
pub(crate) mod report;
mod spool;
pub mod table;
pub mod terminal;
pub(crate) mod tint;

pub(crate) use files::Files;
pub(crate) use progress::Progress;
pub(crate) use report::Report;
pub(crate) use spool::Spool;
