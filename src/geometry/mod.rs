//! Describes directions at a surface, relates them to the world, and integrates over the hemisphere.
//!
//! The surface models of [`matter`](crate::matter), such as every [`Brdf`](crate::matter::Brdf), take
//! directions in the frame of the surface, whose z axis is the normal. A program that keeps positions and
//! normals in world coordinates makes a [`Frame`] of the normal and obtains each [`Direction`] from it by
//! [`Frame::towards`] or [`Frame::to_local`].
//!
//! What a surface receives from all sides is an integral over the hemisphere above it. Choose a rule that
//! implements [`Hemisphere`] ([`GaussLegendre`] for smooth functions) and call
//! [`integrate_projected`](Hemisphere::integrate_projected) for irradiance, or
//! [`integrate`](Hemisphere::integrate) if there is no cosine.
//!
//! # Example
//! ```
//! use nanospectra::geometry::{Frame, GaussLegendre, Hemisphere};
//!
//! // A wall that faces south (towards -y), and the sun in the south, 30 degrees above the horizon.
//! let Some(wall) = Frame::from_normal([0.0, -1.0, 0.0]) else { return };
//! let Some(sun) = wall.to_local([0.0, -0.866_025_4, 0.5]) else { return };
//! assert!((sun.cos_theta() - 0.866_025_4).abs() < 1e-6); // the cosine of 30 degrees
//!
//! // The wall sees half of an even sky: pi / 2 of projected solid angle lies above the horizon.
//! let rule = GaussLegendre::<8, 32>;
//! let sky = rule.integrate_projected(|w| if wall.to_world(w)[2] > 0.0 { 1.0 } else { 0.0 });
//! assert!((sky - core::f32::consts::FRAC_PI_2).abs() < 1e-5);
//! ```

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
