//! Form factors (view factors): the share of what one diffuse surface emits that reaches another, and of what
//! a point's hemisphere can send, the share that comes from a surface (then also called configuration
//! factor).
//!
//! From a surface to a surface, `A1 F12 = A2 F21` ([`reciprocal`]); from a point, the irradiance by a
//! Lambertian surface of radiance L is `pi L F`
//! ([`through_form_factor`](crate::radiometry::Radiance::through_form_factor)). Lengths are in m (any one
//! unit will do). All results are within 0..=1 but for rounding.

mod disk;
mod polygon;
mod quadrature;
mod rectangle;
mod sphere;

pub use disk::{coaxial_disks, to_disk};
#[cfg(feature = "libm")]
pub use polygon::to_polygon;
pub use polygon::to_polygon_with;
#[cfg(feature = "libm")]
pub use rectangle::{parallel_rectangles, perpendicular_rectangles};
pub use rectangle::{parallel_rectangles_with, perpendicular_rectangles_with};
#[cfg(feature = "libm")]
pub use sphere::to_sphere;
pub use sphere::to_sphere_with;

use crate::radiometry::carried::ratio;

/// The factor back, F21, from F12 and the two areas: A1 F12 = A2 F21.
///
/// ```
/// use nanospectra::radiometry::form_factor::{coaxial_disks, reciprocal};
/// let (lamp, table) = (0.1, 1.0);
/// let there = coaxial_disks(lamp, table, 2.0);
/// let back = reciprocal(there, lamp * lamp, table * table);
/// assert!((back / coaxial_disks(table, lamp, 2.0) - 1.0).abs() < 5e-7);
/// ```
#[must_use]
pub fn reciprocal(f12: f32, area_1_m2: f32, area_2_m2: f32) -> f32 {
    f12 * ratio(area_1_m2, area_2_m2)
}
