//! One reading of a chip: raw counts, the light that they stand for, and the reasons why a reading may not be
//! a measurement.

mod basic_counts;
mod count;
mod dark;
mod exposure;
mod linearity;
mod noise;

pub use basic_counts::{BasicCounts, Drift};
pub use count::{Channels, Count, ReadingError};
pub use dark::DarkCounts;
pub use exposure::Exposure;
pub use linearity::{DeadTime, Nonlinearity};
pub(in crate::sensor) use noise::root;
pub use noise::{Noise, Variances};
