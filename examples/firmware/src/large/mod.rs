//! The large calls: functions that put arrays on the stack, such as a spectrum at every nanometer or a
//! matrix. A program for a small part must know what they need before it calls them.
//!
//! As in [`steps`](crate::steps), each call is one function from memory to memory that is not inlined, and
//! one line in the list of its group. Each group is an image of its own, so that it fits into the flash of
//! the smallest part.

pub mod rendering;
pub mod scenes;
pub mod sensor;
pub mod spectra;
