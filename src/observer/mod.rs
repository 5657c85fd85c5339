//! What looks at the light: rows of weights, the fold that makes them small, and [`Stimulus`]: what they can look at.

mod cie;
mod fold;
mod rows;
mod stimulus;

pub use cie::{
    ALPHA_OPIC, CIE_1931, CIE_1964, CIE_2006_LMS_2, CIE_2006_LMS_10, CIE_2015_2, CIE_2015_10, KM,
    KM_SCOTOPIC, V_PHOTOPIC, V_SCOTOPIC,
};
pub use fold::Curve;
pub use rows::{FineObserver, Observer};
pub use stimulus::Stimulus;
