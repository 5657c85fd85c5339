//! An independent f64 model of spectral colorimetry, for tests.
//!
//! Every function is the textbook definition written out naively: direct sums, bisection, dense
//! linear algebra. It shares no code with the crate, so where the two agree both are probably
//! right. `tests/goldens.rs` holds the model itself to published and precomputed values.

pub mod csv;
pub mod interpolation;
pub mod tables;

pub mod chromaticity;
pub mod tristimulus;

pub mod cct;
pub mod daylight;
pub mod planck;

pub mod appearance;
pub mod delta_e;
pub mod hdr;
pub mod lab;

pub mod cri;
pub mod photometry;
pub mod tm30;

pub mod adaptation;
pub mod dominant;
pub mod linear;
pub mod rgb;
pub mod solid;
pub mod transfer;

pub mod flicker;
pub mod light_flickermeter;
pub mod sensor;

pub mod fresnel;
pub mod geometry;
pub mod surface;

pub mod fine;
pub mod fold;

pub mod film;

pub mod allowed;
pub mod check;
pub mod lamps;
pub mod noise;
pub mod search;
