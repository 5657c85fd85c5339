//! The way back: from an RGB or XYZ color to a spectrum that has exactly that color.
//!
//! A renderer, a paint program or a lamp has an RGB and needs a spectrum. Endless spectra have the same
//! color; what is asked for is one that is possible (a reflectance within 0..=1), smooth, and exact: seen
//! by the same eye under the same light it gives that RGB back, at every 8-bit code.
//!
//! ```
//! use nanospectra::color::{EncodedRgb, Srgb};
//! use nanospectra::light::D65;
//! use nanospectra::observer::CIE_1931;
//! use nanospectra::upsample::{Sigmoid, Status, Viewing};
//! use nanospectra::{Curve, Nodes, Reflectance};
//!
//! // Who looks, under what, on which grid: 31 bands under D65, for sRGB. All of it worked out by the compiler.
//! static VIEWING: Viewing<31, Nodes<400, 700>> =
//!     Viewing::new(&CIE_1931.under(&D65.fine()).fold(Curve::Step));
//! static SIGMOID: Sigmoid<31, Nodes<400, 700>> = Sigmoid::new(&VIEWING);
//!
//! # #[cfg(feature = "libm")] {
//! let orange = EncodedRgb::<Srgb>::from_u8([230, 120, 30]);
//! let solved = SIGMOID.reflectance(orange.decode());
//! let paint: Reflectance<31, Nodes<400, 700>> = solved.spectrum.on_grid();
//! assert_eq!(solved.status, Status::Exact);
//! assert!(paint.values().iter().all(|share| (0.0..=1.0).contains(share)));
//! assert_eq!(VIEWING.rgb(&paint).encode().to_u8(), [230, 120, 30]);
//! # }
//! ```
//!
//! # Which one
//!
//! | method | data, bytes | exact | within 0..=1 | linear | shape |
//! |---|---|---|---|---|---|
//! | [`Sigmoid`] | 16 N + 204 with [`CubicStart`] | every color that a sigmoid can have | always | in exposure | smoothest |
//! | [`Basis`] | 8 N | always | for sRGB | yes | three broad bands |
//! | [`Smits`] | 28 N | no: 0.9 CIEDE2000 in the mean | up to 1.015 | in pieces | ten steps |
//!
//! Under another lamp than the one it was made for, a spectrum shows its shape. Against the measured
//! reflectances of CES99 the sigmoid is off by 1.2 (LED-B3) to 2.2 CIEDE2000 (A) in the mean, the basis by
//! 1.4 to 3.0: nobody can know more of a paint from three numbers.
//!
//! # Three meanings
//!
//! * [`SigmoidReflectance`]: what a surface reflects, 0..=1.
//! * [`SigmoidUnbounded`]: the same shape times any number: a density, a color that may be above 1.
//! * [`SigmoidIlluminant`]: light: an unbounded one times the white that (1, 1, 1) stands for.
//!
//! [`Spectrum::from_rgb`](crate::Spectrum::from_rgb) is the short way to a reflectance or a light: by the
//! standard observer, under the white of the space, on any grid.
//!
//! Around it: [`Display`] (what a screen emits for an RGB), [`kubelka_munk()`] (mixed paints) and
//! [`CohenR`] (what of a spectrum an eye cannot see).
//!
//! # The idea
//!
//! A smooth spectrum is s = sigma(q0 x^2 + q1 x + q2), with sigma(p) = 1/2 + p / (2 sqrt(1 + p^2)) and x the
//! wavelength. Three numbers, three conditions: Newton's method. It converges from a start map of a few dozen
//! numbers because the conditions are asked of u = sigma^-1 (responses) and not of the responses: there a
//! constant spectrum is a straight line, and the way to black or white is straight as well.
//!
//! # Reference
//! W. Jakob, J. Hanika, "A low-dimensional function space for efficient spectral upsampling", Computer
//! Graphics Forum 38 (2019); I. Mallett, C. Yuksel, "Spectral primary decomposition for rendering with sRGB
//! reflectance", EGSR 2019; B. Smits, "An RGB-to-spectrum conversion for reflectances", J. Graphics Tools 4
//! (1999).

mod basis;
mod display;
mod from_rgb;
mod kubelka_munk;
mod meaning;
mod metamer;
mod newton;
mod rsqrt;
mod shape;
mod sigmoid;
mod smits;
mod start;
mod status;
mod tables;
mod viewing;

pub use basis::Basis;
pub use display::Display;
pub use from_rgb::FromRgb;
pub use kubelka_munk::kubelka_munk;
pub use meaning::{SigmoidIlluminant, SigmoidReflectance, SigmoidUnbounded};
pub use metamer::CohenR;
pub use shape::Shape;
pub use sigmoid::Sigmoid;
pub use smits::{Smits, SmitsBins};
pub use start::{CubicStart, LinearStart, QuinticStart, StartMap};
pub use status::{Miss, Solved, Status};
pub use viewing::Viewing;
