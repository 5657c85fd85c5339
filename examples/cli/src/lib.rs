//! The program `nanospectra` as a library: each command is a module, and what commands share is in modules
//! beside.
//!
//! A command ([`measure`], [`sensor`], [`paint`] or [`scene`]) takes its options from the command line and
//! its data from [`input`]. It checks all of it, works out every answer, and only then prints through
//! [`output`] or draws with [`picture`], so that a mistake never leaves half a report behind. A [`Failure`]
//! is one line for a person.

mod command;
pub mod failure;
mod input;
mod measure;
pub mod output;
mod paint;
mod picture;
pub mod scene;
pub mod sensor;
pub mod usage;

pub use command::main;
pub use failure::Failure;
