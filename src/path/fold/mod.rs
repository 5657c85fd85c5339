//! Folds a path into an observer, from the observer backwards to the lamp.

mod effect;
mod polarized;

pub use polarized::PolarizedObserver;
