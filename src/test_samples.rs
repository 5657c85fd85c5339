//! The standard's test samples; constants made from `tables/samples`.

#![expect(clippy::approx_constant, reason = "measured numbers that happen to look like 1/pi")]

use crate::grid::Nodes;
use crate::spectrum::{Factor, Fine, Interpolation, Spectrum};

include!(concat!(env!("OUT_DIR"), "/samples.rs"));

/// As tabulated, every 5 nm over the CIE's range; the last, which begins at 380 nm and ends at 780, held on.
#[cfg(feature = "libm")]
pub(crate) static TCS_5NM: [Spectrum<Factor, 95, Nodes<360, 830>>; 15] = {
    let mut samples = [Spectrum::flat(0.0); 15];
    let mut k = 0;
    while k < 14 {
        samples[k] = TCS14_5NM[k];
        k += 1;
    }
    samples[14] = TCS15_5NM[0].interpolate(Interpolation::Linear);
    samples
};

/// CIE 13.3 test color samples 1..=14, and TCS15 (Japanese skin) as the last, on the CIE grid:
/// the 5 nm tables by Sprague's interpolation, end values held.
pub static TCS: [Fine<Factor>; 15] = {
    let mut samples = [Spectrum::flat(0.0); 15];
    let mut k = 0;
    while k < 14 {
        samples[k] = TCS14_5NM[k].interpolate(Interpolation::Sprague);
        k += 1;
    }
    samples[14] = TCS15_5NM[0].interpolate(Interpolation::Sprague);
    samples
};
