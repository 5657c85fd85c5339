//! Published methods of others, to compare the crate with on a host and on devices. They follow the published
//! formulas in f32, without the crate's own shortcuts.

pub mod cct;
pub mod lobes;
pub mod product;
pub mod sums;
