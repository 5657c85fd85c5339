//! Computes XYZ, illuminance, CCT and Duv from raw counts in integers, for cores without an FPU.
//!
//! # Example
//!
//! The calibration is the same as for floats. The compiler turns it into integers; the device only multiplies
//! and adds.
//!
//! ```
//! use nanospectra::sensor::{Calibration, Exposure};
//! use nanospectra::sensor::fixed::{FixedCct, FixedMeter};
//!
//! // A sensor whose three channels are X, Y and Z relative to daylight D65, calibrated in lux.
//! static TO_XYZ: Calibration<3> = Calibration::from_rows([
//!     [0.95, 0.00, 0.00],
//!     [0.00, 1.00, 0.00],
//!     [0.00, 0.00, 1.09],
//! ]);
//! static METER: FixedMeter<3> =
//!     FixedMeter::new(&Exposure::new(1.0, 10.0, 65_535), &TO_XYZ).unwrap();
//!
//! let xyz = METER.xyz(&[10_000_u16, 10_000, 10_000])?; // 1000 lx of daylight
//! assert_eq!(xyz.lux(), 1000);
//! let Some(FixedCct::Near { cct_k, duv_e6, .. }) = xyz.cct() else { return Ok(()) };
//! assert!((6450..6550).contains(&cct_k) && (2900..3700).contains(&duv_e6)); // D65: 6503 K, Duv 0.0032
//! # Ok::<(), nanospectra::sensor::ReadingError>(())
//! ```
//!
//! # How it works
//!
//! A Cortex-M0 multiplies 32 bits in one instruction and takes a hundred for a float. The weights of the
//! matrix are integers here, scaled so that no sum can overflow whatever the counts, and the sums stay exact
//! to a few units of 2^-30.
//!
//! [`FixedMeter`] takes the place of [`Meter`](crate::sensor::Meter), [`FixedXyz`] that of
//! [`Xyz`](crate::color::Xyz), and [`FixedObserver`] that of an [`Observer`](crate::Observer) which looks at
//! samples of 16 bits.

mod cct;
mod meter;
mod observer;
mod xyz;

pub use cct::FixedCct;
pub use meter::FixedMeter;
pub use observer::FixedObserver;
pub use xyz::FixedXyz;
