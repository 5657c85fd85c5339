//! Where power comes from: the tabulated illuminants, daylight, black bodies.

mod blackbody;
mod daylight;
mod illuminants;

#[cfg(feature = "libm")]
pub use blackbody::{blackbody, blackbody_relative};
pub use blackbody::{blackbody_exitance, blackbody_peak_nm, blackbody_relative_with, blackbody_with};
pub use daylight::{Daylight, daylight, daylight_xy};
pub use illuminants::*;

#[cfg(feature = "libm")]
pub(crate) use blackbody::{C2_COLOR_NM, relative as blackbody_shape};
#[cfg(feature = "libm")]
pub(crate) use daylight::{factors as daylight_factors, spectrum as daylight_at};
