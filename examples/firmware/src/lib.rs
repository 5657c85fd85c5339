//! The code that the images for microcontrollers share. Each image in `src/bin` is a program that answers one
//! question about the crate. Two of them are examples to start from:
//!
//! | image | what it shows |
//! |---|---|
//! | `sensor` | how an instrument turns readings into color, smooths the last ones and logs them |
//! | `driver` | how a published driver of a sensor and this crate work together |
//!
//! The others measure, and print what they find:
//!
//! | image | question |
//! |---|---|
//! | `bits` | Does this target compute the same bits as the host? |
//! | `hard` | What are the results of the hard cases, with and without subnormal numbers? |
//! | `count` | How many instructions do public calls take? |
//! | `color_count` | How many instructions do appearance models and encodings take? |
//! | `yardsticks` | How many instructions do published methods of others take? |
//! | `backends` | How many instructions do the functions of each math backend take? |
//! | `price` | How many instructions and how much stack does each step of a reading take? |
//! | `price_whole` | How many instructions and how much stack does a whole reading take? |
//! | `large_rendering`, `large_scenes`, `large_sensor`, `large_spectra` | How much stack do calls with large arrays need? |
//! | `empty` | How much flash does a program need that computes no color? |
//! | `fold16` | How much more flash does it take to turn 16 bands into XYZ? |
//! | `counts_f32` | How much more does it take to turn 8 counts into XYZ, CCT and Lab? |
//! | `counts_fixed` | How much more does it take to turn 8 counts into XYZ and CCT in integers? |
//! | `upsample` | How much more does it take to find the spectrum of an RGB color? |
//! | `upsample_count` | How many instructions does it take to find the spectrum of an RGB color? |
//! | `surface_count` | How many instructions does light take over a surface, by the number of bands? |
//! | `path_count` | How many instructions does light take along a path? |
//! | `path_folded` | How many instructions does a path take that is folded into the observer? |
//! | `path_plain` | Does a path without fluorescence and polarization contain their code? |
//! | `no_panic`, `no_panic_constants` | Can any public function of the crate panic? |
//!
//! `tests/devices.sh` runs all of them, and `tests/on_target.rs` on a host and on every board.
#![no_std]

pub use nanospectra_bits as bits;

// The attribute of an image's first function: `#[nanospectra_firmware::entry] fn main() -> !`.
#[cfg(all(target_arch = "arm", target_os = "none"))]
pub use cortex_m_rt::entry;
#[cfg(all(target_arch = "riscv32", target_os = "none"))]
pub use riscv_rt::entry;

#[cfg(target_os = "none")]
pub mod clock;
pub mod large;
#[cfg(all(target_os = "none", feature = "instrument"))]
pub mod log;
pub mod mock_bus;
pub mod pipeline;
pub mod readings;
#[cfg(target_os = "none")]
pub mod stack;
pub mod steps;
pub mod vest;
