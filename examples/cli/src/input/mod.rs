//! Reading what a user gives: texts, tables, names of illuminants. Strict: nothing is guessed or dropped.

pub mod illuminants;
pub mod lines;
pub mod table;
pub mod text;
