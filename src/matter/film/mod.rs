//! Thin films and stacks of films, where light interferes with itself.

mod airy;
mod multilayer;
mod shares;
mod thin_film;

#[cfg(feature = "libm")]
pub use multilayer::stack_bins;
pub use multilayer::{Layer, Medium, Stack, stack_bins_with};
pub use shares::PowerShares;
#[cfg(feature = "libm")]
pub use thin_film::FilmOnGrid;
pub use thin_film::{FilmIndices, ThinFilm};
