//! Directions at a surface, where the surface lies in the world, and integrals over the hemisphere above it.

mod direction;
mod frame;
pub(crate) mod gauss_legendre;
mod hemisphere;
mod integrand;
pub(crate) mod vec3;

pub use direction::Direction;
pub use frame::Frame;
pub use hemisphere::{Cosine, GaussLegendre, Hemisphere, Node, Uniform};
pub use integrand::Integrand;
pub(crate) use integrand::Total;
