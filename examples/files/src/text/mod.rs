//! From bytes to lines and numbers.

pub mod encoding;
pub mod lines;
pub mod number;
