//! The crate's own backend on micromath, also where the feature of that name is off.

use nanospectra::math::Math;

#[path = "../../../src/math/micromath.rs"]
mod backend;

pub use backend::Micromath;
