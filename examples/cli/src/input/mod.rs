//! Reads what a user provides: texts, tables and names of illuminants.
//!
//! Reading is strict: nothing is guessed or dropped, and what is wrong is an error.

pub mod bands;
pub mod illuminants;
pub mod lines;
pub mod stream;
pub mod table;
pub mod text;
