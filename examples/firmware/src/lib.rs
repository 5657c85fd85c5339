//! What the images share. Each image in `src/bin` answers one question about the crate:
//!
//! | image    | question |
//! |----------|----------|
//! | `bits`   | does this target compute the same bits as the host? |
//! | `count`  | how many instructions does a call take? |
//! | `empty`  | how many bytes does a program need that measures nothing? |
//! | `fold16` | how many more when it turns 16 bands into XYZ? |
//!
//! `tests/devices.sh` of the main crate asks all of them.
#![no_std]

pub mod bits;
#[cfg(target_os = "none")]
pub mod clock;
