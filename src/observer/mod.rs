//! What looks at the light: rows of weights, the fold that makes them small, and [`Stimulus`]: what they can
//! look at.

mod cie;
mod fold;
mod rows;
mod stimulus;

pub use cie::*;
pub use fold::Curve;
pub use rows::{FineObserver, Observer};
pub use stimulus::Stimulus;
