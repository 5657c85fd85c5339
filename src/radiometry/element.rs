//! A small piece of a surface as a piece of the directions: integrals over directions become integrals over
//! area.

use crate::geometry::vec3::{difference, dot, scaled, to_unity, unit};
use crate::radiometry::carried::{finite, ratio};
use crate::radiometry::relations::in_front;

/// A small piece of a surface that looks to one side.
///
/// ```
/// use nanospectra::radiometry::SurfaceElement;
/// let window = SurfaceElement { position_m: [0.0, 0.0, 2.0], normal: [0.0, 0.0, -1.0], area_m2: 0.01 };
/// let (direction, solid_angle_sr) = window.seen_from([0.0; 3]);
/// assert_eq!((direction, solid_angle_sr), ([0.0, 0.0, 1.0], 0.0025)); // dA cos / r^2
/// assert_eq!(window.seen_from([0.0, 0.0, 3.0]).1, 0.0); // from behind
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SurfaceElement {
    /// Its middle, in m.
    pub position_m: [f32; 3],
    /// To the side from which it is seen; of any length but 0.
    pub normal: [f32; 3],
    /// Its area, in m2.
    pub area_m2: f32,
}

impl SurfaceElement {
    /// The direction from a point to it (a unit vector), and the solid angle in sr that it takes up there:
    /// dw = dA cos / r^2. Behind it 0; the element's own place has no direction, and there both are 0.
    ///
    /// Exact for a piece that is small against its distance: an integral over directions, sum of f(w) dw, is
    /// the integral over the area. (For a whole polygon or disk see
    /// [`solid_angle`](crate::radiometry::solid_angle).)
    #[must_use]
    pub fn seen_from(&self, point_m: [f32; 3]) -> ([f32; 3], f32) {
        let k = to_unity(self.position_m.into_iter().chain(point_m));
        let way = difference(scaled(self.position_m, k), scaled(point_m, k));
        let direction = unit(way);
        let cos = in_front(-dot(direction, unit(self.normal)));
        // Lengths were multiplied by k, and the area in two steps, so that it fades instead of overflowing.
        let distance = dot(direction, way);
        let area = finite(self.area_m2 * k * k);
        (direction, ratio(cos * area, distance * distance))
    }
}
