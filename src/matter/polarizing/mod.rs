//! Matter that treats directions across the beam differently: mirrors, polarizers, retarders.

mod mirror;
mod mueller;
mod polarizer;
mod retarder;

pub use mirror::Mirror;
pub use mueller::Mueller;
pub use polarizer::Polarizer;
pub use retarder::Retarder;
