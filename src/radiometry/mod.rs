//! From power to what it does: lumens, non-visual stimulation, photons for plants.

mod alpha_opic;
mod luminous;
mod photon;

pub use alpha_opic::AlphaOpic;
pub use luminous::{illuminance, luminous_efficacy, scotopic_illuminance};
pub use photon::ppfd;
