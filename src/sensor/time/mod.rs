//! Readings one after the other: which exposure comes next, the last few of them, and light that flickers.

mod auto_exposure;
mod classes;
mod filter;
mod flicker;
mod light_flickermeter;
mod stroboscopic;
#[cfg(feature = "heapless")]
mod window;

pub use auto_exposure::{Advice, AutoExposure, LadderError};
pub use flicker::{
    Flicker, MAINS_FLICKER_HZ, MAINS_PERIODS_MS, amplitude_at, mean_over_periods, whole_periods_ms,
};
pub use light_flickermeter::{LightFlickermeter, PstLmError};
#[cfg(feature = "libm")]
pub use stroboscopic::stroboscopic_visibility;
pub use stroboscopic::stroboscopic_visibility_with;
#[cfg(feature = "heapless")]
pub use window::Window;
