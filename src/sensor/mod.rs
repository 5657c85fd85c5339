//! Turns the raw counts of color sensors and mini-spectrometers into XYZ, illuminance, color temperature and
//! spectra.
//!
//! The guide to [sensors and calibration](crate::guide::sensors) goes through it step by step, from a first
//! reading to an instrument.
//!
//! # Example
//!
//! This is an AS7341 with the nominal responsivities of its data sheet. The compiler works out the
//! calibration, which has 96 bytes. What runs on the device is a division by gain and time and one matrix
//! product.
//!
//! ```
//! use nanospectra::color::Cct;
//! use nanospectra::observer::CIE_1931;
//! use nanospectra::sensor::{Calibration, ReadingError, Reconstruction, chip::as7341};
//! use nanospectra::{Curve, Nodes, Observer, Power, const_unwrap};
//!
//! type Grid = Nodes<400, 700>;
//! static CHIP: Observer<8, 31, Power, Grid> = as7341::NOMINAL.fold(Curve::Step);
//! static EYE: Observer<3, 31, Power, Grid> = CIE_1931.fold(Curve::Step);
//! /// Counts to spectrum to XYZ, as one matrix.
//! static TO_XYZ: Calibration<8> = const_unwrap!(Reconstruction::smooth(&CHIP, 0.95, 0.01)).seen_by(&EYE);
//!
//! let exposure = as7341::exposure(16.0, 29, 599); // gain 16, 50 ms
//! // Simulated counts of F1 to F8 under a white LED, CIE illuminant LED-B3.
//! let counts: [u16; 8] = [416, 3675, 2876, 4434, 6022, 6825, 6864, 3069];
//! let xyz = TO_XYZ.xyz(&exposure.basic_counts(&counts)?)?;
//! let Some(Cct::Near { cct_k, .. }) = xyz.cct() else { return Ok(()) };
//! assert!((cct_k / 4103.0 - 1.0).abs() < 0.01); // CIE 15:2018: 4103 K
//! # Ok::<(), ReadingError>(())
//! ```
//!
//! # The steps
//!
//! 1. An [`Exposure`] divides counts by gain and time, and refuses readings that are saturated or too dark.
//!    [`DarkCounts`] and [`BasicCounts::without`] remove dark counts and drift.
//! 2. A [`Calibration`] turns the result into XYZ. It comes from the responsivities of the chip by way of a
//!    [`Reconstruction`], or from measured patches of known color by a [`Fit`]. [`Meter`] joins both steps
//!    for an exposure that stays.
//! 3. [`Noise`] and [`Calibration::covariance`] tell how uncertain the results are, [`AutoExposure`] which
//!    exposure to take next, [`Flicker`] how much the light flickers, and [`LightFlickermeter`] how severe
//!    that is to the eye.
//!
//! What data sheets say of a chip stands in [`chip`], one module for each. It is enough for a first look; an
//! instrument is made from what is measured of your own chip: a table of its responsivities
//! ([`responsivities`]) or measured patches. [`PixelWavelengths`] puts the pixels of a mini-spectrometer into
//! the bins of a spectrum.
//!
//! A step that a program does not call costs nothing: dark counts, drift, cross-talk and glass are calls of
//! their own, and corrections that are linear and constant become part of the [`Calibration`]. Without an
//! FPU, use [`fixed`]: the same calibration, computed in integers that cannot overflow.

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
#[cfg(feature = "libm")]
pub use time::stroboscopic_visibility;
pub use time::{
    Advice, AutoExposure, Flicker, LadderError, LightFlickermeter, MAINS_FLICKER_HZ, MAINS_PERIODS_MS,
    PstLmError, amplitude_at, mean_over_periods, stroboscopic_visibility_with, whole_periods_ms,
};
