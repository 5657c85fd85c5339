//! What turns basic counts into color or a spectrum: matrices, and the responsivities or patches that they
//! come from.

mod calibration;
mod decimal;
mod fit;
mod gaussians;
mod nonnegative;
mod prior;
mod qr;
mod reconstruction;
mod responsivities;
mod uncertainty;
mod vector;

pub(in crate::sensor) use calibration::positive;
pub use calibration::{Calibration, CrosstalkError};
pub use fit::{Fit, FitError};
pub use gaussians::gaussian_responsivities;
pub use nonnegative::nonnegative_spectrum;
pub use prior::covariance_of;
pub use reconstruction::{DEFAULT_ALPHA, Reconstruction};
pub use responsivities::{ResponsivityError, ResponsivityErrorKind, read_responsivities, responsivities};
pub use uncertainty::{CctUncertainty, XyzCovariance};
