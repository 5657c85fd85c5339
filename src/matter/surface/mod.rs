//! Surfaces: what a smooth boundary reflects and lets in, and the BRDFs of smooth, rough and matt surfaces.

mod brdf;
mod fresnel;
mod glass;
mod microfacet;
mod oren_nayar;
mod reflector;
pub mod scattering;
mod smooth;

pub use brdf::{Brdf, Lambert};
pub use fresnel::{Amplitudes, Components, Conductor, Dielectric};
pub use glass::{Cauchy, FUSED_SILICA, Glass, N_BK7, N_SF11, Sellmeier};
pub use microfacet::{Microfacet, TrowbridgeReitz, VisibleNormals};
pub use oren_nayar::OrenNayar;
pub use reflector::Reflector;
pub use smooth::{Smooth, Specular};
