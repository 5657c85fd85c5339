//! Finds a spectrum that has a given RGB or XYZ color: the reflectance of a surface, or a light.
//!
//! A renderer, a paint program or a lamp controller has an RGB and needs a spectrum. Infinitely many spectra
//! have the same color. The methods of this module find one that is smooth, that a surface can have (a
//! reflectance within 0..=1), and whose color is exact: the same observer under the same light sees that RGB,
//! to the last 8-bit code.
//!
//! # Example
//! ```
//! use nanospectra::color::{EncodedRgb, Srgb};
//! use nanospectra::light::D65;
//! use nanospectra::observer::CIE_1931;
//! use nanospectra::upsample::{Sigmoid, Status, Viewing};
//! use nanospectra::{Curve, Nodes, Reflectance};
//!
//! // The observer, the light, the grid and the RGB space: 31 bands under D65, for sRGB. The compiler
//! // computes both constants.
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
//! If you need no more than a reflectance or a light for an RGB,
//! [`Spectrum::from_rgb`](crate::Spectrum::from_rgb) is shorter. It takes the standard observer and the white
//! of the RGB space, on any grid.
//!
//! # Which method to choose
//!
//! | method | data, bytes | exact | within 0..=1 | linear | shape |
//! |---|---|---|---|---|---|
//! | [`Sigmoid`] | 16 N + 204 with [`CubicStart`] | every color that a sigmoid can have | always | in exposure | smoothest |
//! | [`Basis`] | 8 N | always | for sRGB | yes | three broad bands |
//! | [`Smits`] | 28 N | no: 0.9 CIEDE2000 in the mean | up to 1.015 | in pieces | ten steps |
//!
//! Take [`Sigmoid`] unless you need a spectrum that is linear in the RGB, or one in a few nanoseconds; then
//! take [`Basis`]. [`Smits`] is here to compare with and to reproduce older renderings.
//!
//! Under another light than the one it was made for, the color of a spectrum depends on its shape. Compared
//! with the measured reflectances of CES99, colors of the sigmoid are then off by 1.2 (LED-B3) to 2.2
//! CIEDE2000 (A) in the mean, and colors of the basis by 1.4 to 3.0. Three numbers do not say more about a
//! paint.
//!
//! # What a solution can stand for
//!
//! * [`SigmoidReflectance`] is the reflectance of a surface, within 0..=1.
//! * [`SigmoidUnbounded`] is a curve of the same kind times any number: a density, or a color that may be
//!   above 1.
//! * [`SigmoidIlluminant`] is a light: an unbounded curve times the white that RGB (1, 1, 1) stands for.
//!
//! Beside these methods there are [`Display`] (the light that a screen emits for an RGB), [`kubelka_munk()`]
//! (mixed paints) and [`CohenR`] (the part of a spectrum that an observer cannot see).
//!
//! # How the sigmoid is solved
//!
//! The spectrum is s = sigma(q0 x^2 + q1 x + q2), with sigma(p) = 1/2 + p / (2 sqrt(1 + p^2)) and x
//! proportional to the wavelength. The three components of the color give three equations for q0, q1 and q2,
//! which Newton's method solves. It converges in few steps from a starting point that a small polynomial
//! gives, because the equations are written for sigma^-1 of the observer's responses instead of the responses
//! themselves: for constant spectra, and towards black and white, they are then linear.
//!
//! # Reference
//! W. Jakob, J. Hanika, "A low-dimensional function space for efficient spectral upsampling", Computer
//! Graphics Forum 38 (2019); I. Mallett, C. Yuksel, "Spectral primary decomposition for rendering with sRGB
//! reflectance", EGSR 2019; B. Smits, "An RGB-to-spectrum conversion for reflectances", J. Graphics Tools 4
//! (1999).

mod basis;
mod descent;
mod display;
mod edges;
mod far;
mod from_rgb;
mod kubelka_munk;
mod meaning;
mod metamer;
mod newton;
mod problem;
mod rsqrt;
mod seen;
mod shape;
mod sigmoid;
mod simplex;
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
