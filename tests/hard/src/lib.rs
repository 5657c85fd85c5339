//! Formulas in f32 without std, which run on a host and on devices to compare the crate with textbooks and
//! with other methods.
//!
//! [`cases`] has inputs at which the textbook's form fails, with that form and the crate's. [`yardstick`] has
//! published methods of others, with which the crate is compared. The binary of this package compares the
//! cases with f64.
#![no_std]

pub mod cases;
pub mod yardstick;
