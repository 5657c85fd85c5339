//! What the crate promises about programs that use it: what compiles, what gets into an image, what it costs,
//! and that the documentation says so. These tests build programs.

mod claims;
mod damaged_tables;
mod doc_claims;
#[cfg(feature = "libm")]
mod errors;
mod face;
mod image;
mod matter;
mod modules;
mod names;
mod order;
mod pages;
mod path_cost;
mod programs;
mod refusals;
