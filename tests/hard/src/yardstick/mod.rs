//! What others do: published methods to measure the crate against, on a host and on devices. Plain f32 from
//! the formulas, without the crate's own shortcuts.

pub mod cct;
pub mod lobes;
pub mod product;
pub mod sums;
