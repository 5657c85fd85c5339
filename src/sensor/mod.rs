//! Color sensors and mini-spectrometers: from the counts of a chip to color.
//!
//! ```
//! use nanospectra::color::Cct;
//! use nanospectra::observer::CIE_1931;
//! use nanospectra::sensor::{Calibration, Reconstruction, chip::as7341};
//! use nanospectra::{Curve, Nodes, Observer, Power, const_unwrap};
//!
//! type Grid = Nodes<400, 700>;
//! static CHIP: Observer<8, 31, Power, Grid> = as7341::NOMINAL.fold(Curve::Step);
//! static EYE: Observer<3, 31, Power, Grid> = CIE_1931.fold(Curve::Step);
//! /// Counts to spectrum to XYZ, folded while compiling: 96 bytes.
//! static TO_XYZ: Calibration<8> = const_unwrap!(Reconstruction::smooth(&CHIP, 0.95, 0.01)).seen_by(&EYE);
//!
//! let exposure = as7341::exposure(16.0, 29, 599); // gain 16, 50 ms
//! let counts: [u16; 8] = [820, 2310, 3050, 4100, 5200, 6050, 7400, 6900];
//! let xyz = TO_XYZ.xyz(&exposure.basic_counts(&counts)?)?;
//! assert!(matches!(xyz.uv1960().map(|uv| uv.cct()), Some(Cct::Near { .. })));
//! # Ok::<(), nanospectra::sensor::ReadingError>(())
//! ```
//!
//! What data sheets say of a chip stands in [`chip`], one file for each. An instrument is made from what is
//! measured of your own: an [`Observer`](crate::Observer) with its responsivities, from a table
//! ([`responsivities`]), or patches of known color ([`Fit`]). A step that a program does not call costs
//! nothing: dark counts, drift, cross-talk and glass are calls of their own, and what is linear and constant
//! folds into the [`Calibration`]. Without an FPU, use [`fixed`]: the same calibration, computed in integers
//! that cannot overflow.

mod calibrate;
pub mod chip;
pub mod fixed;
mod meter;
mod reading;
mod spectrometer;
mod time;

pub use calibrate::{
    Calibration, CctUncertainty, CrosstalkError, DEFAULT_ALPHA, Fit, FitError, Reconstruction,
    ResponsivityError, ResponsivityErrorKind, XyzCovariance, covariance_of, gaussian_responsivities,
    nonnegative_spectrum, read_responsivities, responsivities,
};
pub use meter::Meter;
pub use reading::{
    BasicCounts, Channels, Count, DarkCounts, DeadTime, Drift, Exposure, Noise, Nonlinearity, ReadingError,
    Variances,
};
pub use spectrometer::{FirstPixel, PixelWavelengths, PixelWavelengthsError, Rebinned, above_dark_pixels};
#[cfg(feature = "heapless")]
pub use time::Window;
pub use time::{
    Advice, AutoExposure, Flicker, LadderError, MAINS_FLICKER_HZ, MAINS_PERIODS_MS, amplitude_at,
    mean_over_periods, whole_periods_ms,
};
