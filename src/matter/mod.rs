//! What light meets, and what leaves: surfaces that reflect and refract, and their BRDFs; thin films; volumes
//! that absorb and scatter; matter that fluoresces, glows on or polarizes; and the reflectances that color
//! rendering is judged by.

mod effect;
mod film;
mod fluorescent;
mod polarizing;
mod surface;
mod volume;

pub use crate::test_samples::{CES, TCS};
pub use effect::{Effect, Foldable, Glows};
pub use film::*;
pub use fluorescent::*;
pub use polarizing::*;
pub use surface::*;
pub use volume::*;
