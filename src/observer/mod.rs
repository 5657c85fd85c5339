//! What looks at the light: rows of weights, the fold that makes them small, and [`Path`]: what they can look at.

mod cie;
mod fold;
mod path;
mod rows;

pub use cie::*;
pub use fold::Curve;
pub use path::Path;
pub use rows::{FineObserver, Observer};
