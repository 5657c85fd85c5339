//! Silicon: from the counts of a chip to color.
//!
//! ```
//! use nanospectra::color::Cct;
//! use nanospectra::observer::CIE_1931;
//! use nanospectra::sensor::{Calibration, Exposure, Reconstruction, nominal};
//! use nanospectra::{Curve, Nodes, Observer, Power};
//!
//! type Grid = Nodes<400, 700>;
//! static CHIP: Observer<8, 31, Power, Grid> = nominal::AS7341.fold(Curve::Step);
//! static EYE: Observer<3, 31, Power, Grid> = CIE_1931.fold(Curve::Step);
//! /// Counts to spectrum to XYZ, folded while compiling: 96 bytes.
//! static TO_XYZ: Calibration<8> = match Reconstruction::smooth(&CHIP, 0.95, 0.01) {
//!     Ok(spectrum) => spectrum.seen_by(&EYE),
//!     Err(_) => panic!("the channels do not tell the spectrum"),
//! };
//!
//! let exposure = Exposure::as7341(16.0, 29, 599); // gain 16, 50 ms
//! let counts: [u16; 8] = [820, 2310, 3050, 4100, 5200, 6050, 7400, 6900];
//! let xyz = TO_XYZ.xyz(&exposure.basic_counts(&counts)?)?;
//! assert!(matches!(xyz.uv1960().map(|uv| uv.cct()), Some(Cct::Near { .. })));
//! # Ok::<(), nanospectra::sensor::Unusable>(())
//! ```
//!
//! What is known of a chip is data that the user supplies: an [`Observer`](crate::Observer) with its
//! responsivities, from a table ([`responsivities`]), or, for a first look, [`nominal`] Gaussians. A step that a
//! program does not call costs nothing: dark counts, drift, cross-talk and glass are calls of their own, and what
//! is linear and constant folds into the [`Calibration`].

mod auto_exposure;
mod basic_counts;
mod calibration;
mod count;
mod dark;
mod decimal;
mod exposure;
mod fit;
pub mod fixed;
mod flicker;
mod linearity;
mod meter;
mod noise;
pub mod nominal;
mod nonnegative;
mod prior;
mod qr;
mod reconstruction;
mod responsivities;
mod spectrometer;
mod vector;
#[cfg(feature = "heapless")]
mod window;

pub use auto_exposure::{AS7341_LADDER, Advice, AutoExposure, LadderError};
pub use basic_counts::{BasicCounts, Drift};
pub use calibration::{Calibration, Singular};
pub use count::{Channels, Count, Unusable};
pub use dark::Dark;
pub use exposure::Exposure;
pub use fit::{Fit, FitError};
pub use flicker::{
    Flicker, MAINS_FLICKER_HZ, MAINS_PERIODS_MS, amplitude_at, mean_over_periods, whole_periods_ms,
};
pub use linearity::{Bend, DeadTime};
pub use meter::Meter;
pub use noise::{CctUncertainty, Noise, Variances, XyzCovariance};
pub use nonnegative::nonnegative_spectrum;
pub use prior::covariance_of;
pub use reconstruction::{ALPHA, Reconstruction};
pub use responsivities::{ResponsivityError, ResponsivityProblem, read_responsivities, responsivities};
pub use spectrometer::{FirstPixel, NotRising, Rebinned, Wavelengths, above_dark_pixels};
#[cfg(feature = "heapless")]
pub use window::Window;
