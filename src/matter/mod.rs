//! What light meets: the reflectances that colour rendering is judged by.

mod samples;

pub use samples::{CES, TCS};
