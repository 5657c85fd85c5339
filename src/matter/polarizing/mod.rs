//! Matter that acts differently on the two polarizations of light: mirrors, polarizers and retarders.

mod mirror;
mod mueller;
mod polarizer;
mod retarder;

pub use mirror::Mirror;
pub use mueller::Mueller;
pub use polarizer::Polarizer;
pub use retarder::Retarder;
