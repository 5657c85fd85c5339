//! The CIE's test samples, as constants that the build script makes from the files in `tables/samples`. It
//! writes `samples.rs` into the build directory, which this file includes.

#![expect(clippy::approx_constant, reason = "measured numbers that happen to look like 1/pi")]

use crate::grid::Nodes;
use crate::spectrum::{Factor, Fine, Interpolation, Spectrum};

include!(concat!(env!("OUT_DIR"), "/samples.rs"));

/// The samples of [`TCS`] as tabulated, every 5 nm over the CIE's range. The last one is tabulated from 380
/// to 780 nm and keeps its end values beyond.
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

/// Holds the reflectances of the CIE 13.3 test color samples 1 to 14, and of TCS15 (Japanese skin) as the
/// last, at every nanometer of 360..=830 nm.
///
/// The tables give a value every 5 nm; Sprague's interpolation brings them to 1 nm, and beyond a table its
/// end values are held. A program that reads this static contains all 15 samples, 28 KB.
///
/// # Reference
/// CIE 13.3-1995, Table A7.1 (doi 10.25039/CIE.DS.wuiuu9cz), and the CIE's data set of TCS15 after JIS Z 8726
/// (doi 10.25039/CIE.DS.7chm7z5h); CC BY-SA 4.0. The numbers are those of `tables/samples/cri_tcs14_5nm.csv`
/// and `tables/samples/cri_tcs15_5nm.csv`; `tables/build.rs` turns these files into constants.
///
/// # Example
/// ```
/// use nanospectra::{Factor, FineObserver, light::C, matter::TCS, observer::CIE_1931};
///
/// // Sample 1 is the Munsell color 7.5 R 6/4, whose value 6 means Y = 30.05 under illuminant C.
/// static EYE: FineObserver<3, Factor> = CIE_1931.under(&C.fine()).with_white_y(100.0);
/// let [_, y, _] = EYE.sees(&TCS[0]);
/// assert!((y - 30.05).abs() < 1.0, "{y}");
/// ```
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
