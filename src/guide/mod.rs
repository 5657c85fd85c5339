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

#[doc = include_str!("first_steps.md")]
pub mod first_steps {}

#[doc = include_str!("bands.md")]
pub mod bands {}

#[doc = include_str!("sensors.md")]
pub mod sensors {}

#[doc = include_str!("rgb_to_spectrum.md")]
pub mod rgb_to_spectrum {}

#[doc = include_str!("paths.md")]
pub mod paths {}

#[doc = include_str!("renderer.md")]
pub mod renderer {}

#[doc = include_str!("hard_cases.md")]
pub mod hard_cases {}

#[doc = include_str!("conventions.md")]
pub mod conventions {}

#[doc = include_str!("same_bits.md")]
pub mod same_bits {}

#[doc = include_str!("microcontrollers.md")]
pub mod microcontrollers {}
