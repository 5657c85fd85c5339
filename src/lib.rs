//! Spectral colour maths for cores without an allocator.
#![no_std]
#![deny(missing_docs, unsafe_code)]

mod grid;

mod spectrum;

pub mod light;

pub mod matter;

pub mod observer;

pub mod color;

pub mod radiometry;

pub mod math;

pub use grid::{Bins, Grid, Nodes};
pub use observer::{Curve, FineObserver, Observer};
pub use spectrum::{
    Factor, Fine, Interpolation, Light, Outside, Power, Quantity, Reflectance, SamplesError, Spectrum,
};
#[cfg(feature = "heapless")]
pub use spectrum::{PushError, Samples};
