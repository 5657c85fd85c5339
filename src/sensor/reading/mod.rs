//! One reading of a chip: raw counts, what they are worth, and why they may be worth nothing.

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
