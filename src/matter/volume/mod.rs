//! Volumes that absorb and scatter light: glass and liquids, slabs, skin and milk, and air.

mod absorption;
mod burley;
mod diffuse_fresnel;
mod dipole;
mod rayleigh;
mod slab;

pub use absorption::{Absorber, AbsorberError};
#[cfg(feature = "libm")]
pub use burley::burley_distance;
pub use burley::{Burley, BurleyFit, burley_distance_with};
pub use diffuse_fresnel::{external_reflectance, internal_reflectance, internal_reflectance_fit};
pub use dipole::Dipole;
pub use rayleigh::{air_refractivity, king_factor, rayleigh_cross_section, rayleigh_per_m, rayleigh_phase};
pub use slab::{Slab, internal_transmittance};
