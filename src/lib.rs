//! What light looks like, for a microcontroller, a web page or a renderer: spectral color math
//! in fixed-size arrays, without std and without an allocator.
//!
//! ```
//! use nanospectra::color::{Cct, Xyz};
//! use nanospectra::observer::CIE_1931;
//! use nanospectra::{Curve, Fine, Observer, Power, Reflectance, light};
//!
//! // A measured lamp, every 5 nm (here a table's), to its color: interpolate to 1 nm, sum.
//! let lamp: Fine<Power> = light::FL11.fine();
//! let xyz = Xyz::from(CIE_1931.sees(&lamp));
//! let Some(Cct::Near { cct_k, duv }) = xyz.cct() else { return };
//! assert!((cct_k - 3998.0).abs() < 8.0 && duv.abs() < 1e-3); // CIE 15: FL11, 4000 K
//!
//! // The same lamp folded into the eye: 192 bytes that read a reflectance of 16 numbers.
//! static EYE: Observer<3, 16> = CIE_1931
//!     .under(&light::FL11.fine())
//!     .fold(Curve::Spline)
//!     .with_white_y(100.0);
//! let gray = Reflectance::flat(0.5);
//! let [_, y, _] = EYE.sees(&gray);
//! assert!((y - 50.0).abs() < 1e-4);
//! ```
//!
//! # The one idea
//!
//! **Light that meets matter and then a sensor is a linear chain, and a chain that does not change is a small
//! matrix.** [`Observer`] is that matrix. It is closed under [`through`](Observer::through),
//! [`looking_at`](Observer::looking_at), [`under`](Observer::under) and [`mixed`](Observer::mixed), all
//! `const fn`, and [`fold`](Observer::fold) brings it from the CIE's 1 nm to the few bins that a program can
//! afford. 16 folded bins show surfaces better than 60 averages do without the fold.
//!
//! # The road
//!
//! A number enters as a measured sample and leaves as a color. The modules are the stations:
//!
//! * [`Bands`]: what N numbers belong to. Of wavelengths a [`Grid`], [`Bins`] between edges or [`Nodes`]
//!   centered on wavelengths; or red, green and blue ([`RgbBands`](color::RgbBands)), by one alias for a
//!   whole program.
//! * [`Spectrum`]: N averages of [`Power`] or [`Factor`] on a grid, from samples, lines, tables.
//! * [`light`]: where power comes from: the CIE illuminants, daylight, black bodies.
//! * [`matter`]: what light meets: test samples; glasses, metals, matt and rough surfaces; films, absorbers,
//!   scatterers; dyes, mirrors, polarizers.
//! * [`observer`]: what looks: eyes, cones, V(lambda), any C-channel sensor; the fold.
//! * [`path`]: lamp, filter, surface, in that order; fluorescence and polarization where they are called for.
//! * [`color`]: what it means: chromaticity, CCT and Duv, Lab, differences, adaptation, RGB, CRI, TM-30.
//! * [`upsample`]: the way back: a spectrum for an RGB, exact, smooth and within 0..=1.
//! * [`radiometry`]: how much of it, where: radiance to lux with units, solid angles, form factors; melanopic
//!   stimulation, photons.
//! * [`sensor`]: how silicon sees it: raw counts to color, calibration, uncertainty, integers only.
//!
//! Below them all lie [`geometry`]: directions, frames and integrals over the hemisphere; and [`math`]: the
//! elementary functions, and the backends that provide them.
//!
//! # Conventions
//!
//! * Wavelengths are in nm. XYZ has Y = 100 for a perfect white surface and for relative lights, and Y in
//!   lx, lm or cd/m2 through [`KM`](observer::KM) = 683.002 lm/W for absolute ones.
//! * Measured samples: interpolate linearly to 1 nm (Sprague's way by name), sum over 360..=830 nm; outside
//!   the data zero for lights, the end values for reflectances. The choice of interpolation moves xy by up to
//!   3.4e-4.
//! * CCT, Duv and CRI are on the CIE 1931 observer with c2 = 1.4388e-2 m K, TM-30 on CIE 1964 with its
//!   CCT on 1931; [`light::blackbody`] uses today's constants. Duv is positive above the locus.
//! * NaN in gives NaN out; nothing panics (but indexing a spectrum beyond its end); a quantity that has no
//!   value is an enum or `None`, never a wrong number. What [`radiometry`] divides by zero is the largest
//!   f32.
//! * Values hold their accuracy between 1e-30 and 1e30; outside, products of f32 under- or overflow.
//! * Every finite result has the same bits on every target (x86-64, Arm, RISC-V, WebAssembly), with every
//!   feature. A feature adds an interface or speed and never changes a number.
//!
//! # Features
//!
//! `libm` (default): what needs exp, ln, pow or atan2 by its short name. `simd`: explicit vectors on hosts
//! other than x86-64, which has them always. `std`, `micromath`: more [`math`] backends ([`math::Fast`] needs
//! no feature: the `_with` forms take it). `heapless`: samples collected in fixed memory. `defmt`: logging.
//!
//! # Left out
//!
//! Files, text and plots (see `examples/cli` for these); spectra whose size is known only at run time;
//! f64 at run time; color appearance beyond what TM-30 needs.
#![no_std]
// On docs.rs, items that need a feature name it. The feature `std` also needs a target with an operating system,
// which that label leaves out.
#![cfg_attr(docsrs, feature(doc_cfg), doc(auto_cfg(hide(target_os = "none"))))]
#![deny(missing_docs, unsafe_code)]

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
