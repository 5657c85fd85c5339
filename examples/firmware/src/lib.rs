//! What the images share. Each image in `src/bin` answers one question about the crate:
//!
//! | image        | question |
//! |--------------|----------|
//! | `bits`       | does this target compute the same bits as the host? |
//! | `hard`       | what does an FPU make of the hard cases, with and without subnormal numbers? |
//! | `count`      | how many instructions does a call take? |
//! | `yardsticks` | how many do the methods of others take? |
//! | `backends`   | how many do the functions of each math backend take? |
//! | `price`      | how many does each step of a reading take, and how much stack? |
//! | `price_whole` | how many does a whole reading take? |
//! | `empty`      | how many bytes does a program need that measures nothing? |
//! | `fold16`     | how many more when it turns 16 bands into XYZ? |
//! | `counts_f32` | how many more when it turns 8 counts into XYZ, CCT and Lab? |
//! | `counts_fixed` | how many when it does so in integers? |
//! | `upsample` | how many when it finds the spectrum of an RGB? |
//! | `upsample_count` | how many instructions does that take? |
//! | `surface_count` | how many does light take over a surface, with how many bands? |
//! | `path_count` | how many instructions does light take along a path? |
//! | `path_folded` | how many when the path is folded into the eye? |
//! | `path_plain` | does a path without effects bring any of them along? |
//! | `no_panic`, `no_panic_light`, `no_panic_sensor` | can any step panic? |
//! | `sensor`     | what does an instrument look like, with a window and a log? |
//! | `driver`     | how do a published driver and this crate go together? |
//!
//! `tests/devices.sh` asks all of them, and runs `tests/on_target.rs` on a host and on every board.
#![no_std]

pub use nanospectra_bits as bits;

// What an image starts with: `#[nanospectra_firmware::entry] fn main() -> !`.
#[cfg(all(target_arch = "arm", target_os = "none"))]
pub use cortex_m_rt::entry;
#[cfg(all(target_arch = "riscv32", target_os = "none"))]
pub use riscv_rt::entry;

#[cfg(target_os = "none")]
pub mod clock;
#[cfg(all(target_os = "none", feature = "instrument"))]
pub mod log;
pub mod mock_bus;
pub mod pipeline;
pub mod readings;
#[cfg(target_os = "none")]
pub mod stack;
pub mod steps;
pub mod vest;
