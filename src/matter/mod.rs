//! What light meets, and what leaves: surfaces that reflect and refract, and their BRDFs; thin films; volumes
//! that absorb and scatter; matter that fluoresces, glows on or polarizes; and the reflectances that color rendering
//! is judged by.

mod brdf;
mod fresnel;
mod glass;
mod microfacet;
mod oren_nayar;
mod reflector;
pub mod scattering;
mod smooth;

mod airy;
mod complex;
mod multilayer;
mod shares;
mod thin_film;

mod absorption;
mod diffuse_fresnel;
mod rayleigh;
mod slab;
mod subsurface;

mod donaldson;
mod fluorescence;
mod phosphorescence;
mod polarization;

pub use crate::test_samples::{CES, TCS};

pub use brdf::{Brdf, Lambert};
pub use fresnel::{Amplitudes, Components, Conductor, Dielectric};
pub use glass::{Cauchy, FUSED_SILICA, Glass, N_BK7, N_SF11, Sellmeier};
pub use microfacet::{Microfacet, TrowbridgeReitz, VisibleNormals};
pub use oren_nayar::{Bands, OrenNayar};
pub use reflector::Reflector;
pub use smooth::{Smooth, Specular};

pub use complex::Complex;
#[cfg(feature = "libm")]
pub use multilayer::stack_bins;
pub use multilayer::{Layer, Medium, Stack, stack_bins_with};
pub use shares::Shares;
pub use thin_film::{FilmIndices, ThinFilm};

pub use absorption::{Absorber, AbsorberError};
pub use diffuse_fresnel::{external_reflectance, internal_reflectance, internal_reflectance_fit};
pub use rayleigh::{air_refractivity, king_factor, rayleigh_cross_section, rayleigh_per_m, rayleigh_phase};
pub use slab::{Slab, internal_transmittance};
#[cfg(feature = "libm")]
pub use subsurface::burley_distance;
pub use subsurface::{Burley, Dipole, SearchLight, burley_distance_with};

pub use donaldson::Donaldson;
pub(crate) use donaldson::applied;
pub use fluorescence::{Dye, FluorescenceError};
pub use phosphorescence::Phosphor;
pub use polarization::{Mirror, Mueller, Polarizer, Retarder};
