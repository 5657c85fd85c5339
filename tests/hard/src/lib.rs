//! What f32 makes of formulas, in plain f32 without std: a host runs it, and so does a device.
//!
//! [`cases`] are inputs at which the form of the textbook fails, with that form and the crate's.
//! [`yardstick`] has published methods of others, to measure the crate against. The binary of this package
//! compares the cases with f64.
#![no_std]

pub mod cases;
pub mod yardstick;
