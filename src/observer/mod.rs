//! What looks at the light: rows of weights, the fold that makes them small, and [`Path`]: what they can look at.

mod cie;
mod fold;
mod path;
mod rows;

pub use cie::{
    ALPHA_OPIC, CIE_1931, CIE_1964, CIE_2006_LMS_2, CIE_2006_LMS_10, CIE_2015_2, CIE_2015_10, KM,
    KM_SCOTOPIC, StandardObserver, V_PHOTOPIC, V_SCOTOPIC,
};
pub use fold::Curve;
pub use path::Path;
pub use rows::{FineObserver, Observer};
