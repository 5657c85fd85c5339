//! What light meets, folded into the eye: from the eye backwards along the path.

mod effect;
mod polarized;

pub use polarized::PolarizedObserver;
