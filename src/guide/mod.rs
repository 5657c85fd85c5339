//! Guides: what the crate can do for you, page by page, with examples that run.
//!
//! | You want to | Read |
//! |---|---|
//! | compute your first color from a spectrum | [first steps](first_steps) |
//! | decide how many numbers a spectrum needs | [how many bands](bands) |
//! | turn the counts of a color sensor into XYZ and lux | [sensors and calibration](sensors) |
//! | find a spectrum for an RGB color | [RGB to spectrum](rgb_to_spectrum) |
//! | send light through filters, dyes and films | [the light's path](paths) |
//! | use the crate in a path tracer | [in a renderer](renderer) |
//! | know how accurate the results are | [accuracy and hard cases](hard_cases) |
//! | know which scale, observer or white is meant | [conventions] |
//! | rely on equal results on every machine | [the same bits everywhere](same_bits) |
//! | fit it into flash and stack | [on a microcontroller](microcontrollers) |
//!
//! # Example
//! ```
//! use nanospectra::color::Xyz;
//! use nanospectra::light::FL11;
//! use nanospectra::observer::CIE_1931;
//!
//! // The chromaticity of a fluorescent lamp, which CIE 15 tabulates as (0.3805, 0.3769).
//! let xy = Xyz::from(CIE_1931.sees(&FL11.fine())).xy().unwrap();
//! assert!((xy.x - 0.3805).abs() < 5e-4 && (xy.y - 0.3769).abs() < 5e-4);
//! ```

/// Takes you from a measured lamp to its color, and to a surface under it, step by step.
#[doc = include_str!("first_steps.md")]
pub mod first_steps {}

/// Helps you choose how many numbers a spectrum needs, with the error and the cost of each choice.
///
#[doc = include_str!("frontier.svg")]
///
#[doc = include_str!("bands.md")]
pub mod bands {}

/// Turns the raw counts of a color sensor into XYZ, lux and color temperature, and calibrates them.
#[doc = include_str!("sensors.md")]
pub mod sensors {}

/// Finds a smooth reflectance for an RGB color, and shows which method suits which task.
#[doc = include_str!("rgb_to_spectrum.md")]
pub mod rgb_to_spectrum {}

/// Sends light through filters, dyes, films and mirrors, and shows what each effect costs.
#[doc = include_str!("paths.md")]
pub mod paths {}

/// Shows how a renderer uses the materials, the directions and the observers of this crate.
#[doc = include_str!("renderer.md")]
pub mod renderer {}

/// Says how accurate the results are, and what the crate does where `f32` makes formulas fail.
#[doc = include_str!("hard_cases.md")]
pub mod hard_cases {}

/// Lists which scale, observer, white or interpolation is meant where nothing else is said.
#[doc = include_str!("conventions.md")]
pub mod conventions {}

/// Explains what makes results equal to the last bit on every machine, and what does not.
#[doc = include_str!("same_bits.md")]
pub mod same_bits {}

/// Shows how to fit the crate into flash and stack, and which math backend to choose.
#[doc = include_str!("microcontrollers.md")]
pub mod microcontrollers {}
