//! Color appearance: the models CIECAM02 and CAM16, the conditions in which a color is seen, and the
//! attributes that the models give it there.

mod attributes;
mod conditions;
mod inverse;
mod model;

pub use attributes::{Appearance, CamUcs};
pub use conditions::ViewingConditions;
pub use model::{AppearanceModel, Cam16, Ciecam02, Surround};
