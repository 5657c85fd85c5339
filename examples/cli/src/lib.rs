//! The program `nanospectra` as a library, with a module for each command and modules that the commands
//! share.
//!
//! A command ([`measure`], [`sensor`], [`flicker`], [`paint`] or [`scene`]) takes its options from the
//! command line and its data from [`input`]. It checks all of its input and computes every answer before it
//! prints anything through [`output`] or draws with [`picture`], so that a mistake never leaves half a report
//! behind. A [`Failure`] is one line for a person.

mod command;
pub mod failure;
mod flicker;
mod input;
mod measure;
pub mod output;
mod paint;
pub mod picture;
pub mod scene;
pub mod sensor;
pub mod usage;

pub use command::main;
pub use failure::Failure;
