//! Computes what light looks like, on a microcontroller, in a web page or in a renderer: spectral color math
//! in fixed-size arrays of `f32`, without `std` and without an allocator.
//!
//! A spectrum, or the counts of a color sensor, become XYZ, color temperature, Lab, CRI, TM-30 or lux, and an
//! RGB color becomes a spectrum again. The tables of the CIE are made when the crate is built.
//!
//! ```
//! use nanospectra::color::{Cct, Xyz};
//! use nanospectra::observer::CIE_1931;
//! use nanospectra::{Curve, Fine, Observer, Power, Reflectance, light};
//!
//! // A lamp from a table with a value every 5 nm: bring it to 1 nm, and sum.
//! let lamp: Fine<Power> = light::FL11.fine();
//! let xyz = Xyz::from(CIE_1931.sees(&lamp));
//! let Some(Cct::Near { cct_k, duv }) = xyz.cct() else { panic!("no white") };
//! // CIE 15 says 4000 K.
//! assert!((cct_k - 3998.0).abs() < 8.0 && duv.abs() < 1e-3);
//!
//! // An eye under this lamp that reads a reflectance of 16 numbers. The compiler makes it.
//! static EYE: Observer<3, 16> = CIE_1931
//!     .under(&light::FL11.fine())
//!     .fold(Curve::Spline)
//!     .with_white_y(100.0);
//! assert_eq!(size_of_val(&EYE), 192); // bytes
//! let gray = Reflectance::flat(0.5);
//! let [_, y, _] = EYE.sees(&gray);
//! assert!((y - 50.0).abs() < 1e-4);
//! ```
//!
//! **New here?** Begin with the guide to the [first steps](guide::first_steps). All guides are in [`guide`]:
//! how many bands to use, sensors, RGB to spectrum, filters and dyes, renderers, accuracy, conventions, flash
//! and stack.
//!
//! # The idea
//!
//! Light that meets matter and then a sensor is a linear chain, and a chain that does not change is a small
//! matrix. [`Observer`] is that matrix. The compiler multiplies the lamp, the filter and the color-matching
//! functions at 1 nm and [folds](Observer::fold) the result into the few bands that a program can afford. A
//! surface that is seen through 16 folded bands has a more accurate color than one that is sampled at 60
//! bands without the fold.
//!
#![doc = include_str!("guide/chain.svg")]
//!
//! # The modules
//!
//! They follow the light, from the numbers of a measured sample to a color:
//!
//! * [`Bands`] are what the N numbers of a spectrum belong to: a [`Grid`] of wavelengths ([`Bins`] between
//!   edges, [`Nodes`] around wavelengths), or red, green and blue ([`RgbBands`](color::RgbBands)).
//! * [`Spectrum`] holds N averages of a [`Power`] or of a [`Factor`], such as a reflectance or a
//!   transmittance.
//! * [`light`] has the illuminants of the CIE, daylight and black bodies.
//! * [`matter`] has what light meets: glasses, metals, matt and rough surfaces, films, absorbers, scatterers,
//!   dyes, mirrors and polarizers.
//! * [`observer`] has what looks: the standard observers, cones, V(λ) and your own sensors.
//! * [`path`] sends light through one after another, with fluorescence and polarization where you ask for
//!   them.
//! * [`color`] says what XYZ means: chromaticity, CCT and Duv, Lab, differences, adaptation, RGB, CRI and
//!   TM-30.
//! * [`upsample`] finds a smooth reflectance for an RGB color.
//! * [`radiometry`] has quantities with units, solid angles, form factors, lux, melanopic and photon
//!   quantities.
//! * [`sensor`] turns raw counts into color, with calibration and uncertainty, in floats or in integers.
//! * [`geometry`] has directions and integrals over the hemisphere, and [`math`] the elementary functions.
//!
//! # Conventions in brief
//!
//! * Wavelengths are in nm. XYZ has Y = 100 for a perfect white surface and for relative lights.
//! * NaN in gives NaN out. Nothing panics, except indexing a spectrum beyond its end, and a wrong table of
//!   [`responsivities`](sensor::responsivities) that stops the build.
//! * A quantity that has no value is `None` or a variant of an enum, never a wrong number.
//! * Every finite result has the same bits on every target, with every feature.
//!
//! The guide to the [conventions](guide::conventions) has all of them: observers, interpolation, what lies
//! outside the data, absolute units, whites.
//!
//! # Features
//!
//! A feature adds an interface or speed, and never changes a number.
//!
//! * `libm` (default) adds what needs exp, ln, pow or atan2 by its short name. Without it, the `_with` forms
//!   take a backend such as [`math::Fast`].
//! * `simd` adds explicit vectors on hosts other than x86-64, which has them always.
//! * `std` and `micromath` add more [`math`] backends.
//! * `heapless` adds the collection of samples in fixed memory, and `defmt` adds logging.
//!
//! # What is not there
//!
//! Files, text and plots (the program `nanospectra-cli` has them), spectra whose size is known only at run
//! time, and `f64` at run time.
#![no_std]
// On docs.rs, items that need a feature name it. The feature `std` also needs a target with an operating
// system, which that label leaves out.
#![cfg_attr(docsrs, feature(doc_cfg), doc(auto_cfg(hide(target_os = "none"))))]
#![deny(missing_docs, unsafe_code)]
// The guides use the default feature.
#![cfg_attr(not(feature = "libm"), allow(rustdoc::broken_intra_doc_links))]

// The x87 computes with more digits than f32 has, and where it drops them is up to the compiler.
#[cfg(all(target_arch = "x86", not(any(target_feature = "sse2", target_os = "uefi", nanospectra_x87))))]
compile_error!(
    "this target computes on the x87, where the last digits of results differ from those of every other \
     target, and no error bound of nanospectra was tested. Build for a target with SSE2, as i686-unknown-linux-gnu, \
     or with RUSTFLAGS=\"-Ctarget-feature=+sse2\". If results may differ, say so by \
     RUSTFLAGS=\"--cfg nanospectra_x87\"."
);

mod grid;

mod price;

mod spectrum;

mod sum;

mod test_samples;

mod tristimulus;

pub mod geometry;

pub mod light;

pub mod matter;

pub mod observer;

pub mod path;

pub mod color;

pub mod upsample;

pub mod radiometry;

pub mod sensor;

pub mod math;

// Its examples use the default feature.
#[cfg(any(feature = "libm", not(doctest)))]
pub mod guide;

pub use grid::{Bands, Bins, Grid, Nodes};
pub use observer::{Curve, FineObserver, Observer};
pub use spectrum::{
    Factor, Fine, Interpolation, Light, Outside, PerBin, Power, Quantity, Reflectance, RefractiveIndex,
    SamplesError, Spectrum,
};
#[cfg(feature = "heapless")]
pub use spectrum::{PushError, Samples};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
