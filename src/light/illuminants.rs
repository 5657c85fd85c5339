//! CIE illuminants on the grid they were published on; constants made from `tables/illuminants`.
//!
//! A static costs flash only in a program that reads it. For 1 nm sums bring a table to the CIE
//! grid with [`Spectrum::interpolate`].

#![expect(clippy::approx_constant, reason = "measured numbers that happen to look like 1/pi")]

use crate::grid::Nodes;
use crate::spectrum::{Power, Spectrum};

include!(concat!(env!("OUT_DIR"), "/illuminants.rs"));
