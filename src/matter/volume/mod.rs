//! Volumes that absorb and scatter light: glass and liquids, slabs, skin and milk, and air.

mod absorption;
mod diffuse_fresnel;
mod rayleigh;
mod slab;
mod subsurface;

pub use absorption::{Absorber, AbsorberError};
pub use diffuse_fresnel::{external_reflectance, internal_reflectance, internal_reflectance_fit};
pub use rayleigh::{air_refractivity, king_factor, rayleigh_cross_section, rayleigh_per_m, rayleigh_phase};
pub use slab::{Slab, internal_transmittance};
#[cfg(feature = "libm")]
pub use subsurface::burley_distance;
pub use subsurface::{Burley, BurleyFit, Dipole, burley_distance_with};
