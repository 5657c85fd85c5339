//! Computes form factors (view factors), which say how much light a surface sends to another or to a point.
//!
//! Between two surfaces, F12 is the share of the light leaving the first, diffuse surface that reaches the
//! second one. It obeys `A1 F12 = A2 F21` ([`reciprocal`]). The functions are [`coaxial_disks`],
//! [`parallel_rectangles`] and [`perpendicular_rectangles`].
//!
//! From a point with a normal, F is the irradiance that a surface causes over the irradiance that the whole
//! hemisphere would cause with the same radiance (also called configuration factor). The irradiance by a
//! Lambertian surface of radiance L is `pi L F`, which
//! [`through_form_factor`](crate::radiometry::Radiance::through_form_factor) returns. The functions are
//! [`to_disk`], [`to_sphere`] and [`to_polygon`].
//!
//! Lengths are in m, or in any other unit that is the same for all of them. All results are within 0..=1
//! except for rounding.
//!
//! # Example
//! ```
//! use nanospectra::radiometry::{Nit, form_factor};
//!
//! // A round lamp of 2000 cd/m2 and 0.2 m radius, 1 m above a desk: F = r^2 / (r^2 + d^2).
//! let f = form_factor::to_disk(0.2, 1.0, 0.0);
//! assert!((f - 0.04 / 1.04).abs() < 1e-7);
//! assert_eq!(format!("{:.1}", Nit::from(2000.0).through_form_factor(f)), "241.7 lx");
//! ```

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

/// Returns the form factor F21 of the opposite direction, from F12 and the two areas.
///
/// It uses the reciprocity A1 F12 = A2 F21. Areas are in m2, or in any other unit that is the same for both.
///
/// # Example
/// ```
/// use nanospectra::radiometry::form_factor::{coaxial_disks, reciprocal};
/// let (lamp, table) = (0.1, 1.0); // radii; areas are as their squares
/// let there = coaxial_disks(lamp, table, 2.0);
/// let back = reciprocal(there, lamp * lamp, table * table);
/// assert!((back / coaxial_disks(table, lamp, 2.0) - 1.0).abs() < 5e-7);
/// ```
#[must_use]
pub fn reciprocal(f12: f32, area_1_m2: f32, area_2_m2: f32) -> f32 {
    f12 * ratio(area_1_m2, area_2_m2)
}
