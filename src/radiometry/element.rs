//! Converts a small piece of a surface to the solid angle that it covers, and so integrals over directions to
//! integrals over area.

use crate::geometry::vec3::{difference, dot, scaled, to_unity, unit};
use crate::radiometry::carried::{finite, ratio};
use crate::radiometry::relations::in_front;

/// A small piece of a surface that is seen from one side, such as a patch of a lamp or a window.
///
/// Call [`seen_from`](Self::seen_from) for the direction and the solid angle that it covers.
///
/// # Example
/// ```
/// use nanospectra::radiometry::SurfaceElement;
/// let window = SurfaceElement { position_m: [0.0, 0.0, 2.0], normal: [0.0, 0.0, -1.0], area_m2: 0.01 };
/// let (direction, solid_angle_sr) = window.seen_from([0.0; 3]);
/// assert_eq!((direction, solid_angle_sr), ([0.0, 0.0, 1.0], 0.0025)); // area times cosine over distance^2
/// assert_eq!(window.seen_from([0.0, 0.0, 3.0]).1, 0.0); // from behind
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SurfaceElement {
    /// The position of its middle, given in m.
    pub position_m: [f32; 3],
    /// The normal, which points to the side from which the piece is seen and has any length other than 0.
    pub normal: [f32; 3],
    /// The area that it covers, in m2.
    pub area_m2: f32,
}

impl SurfaceElement {
    /// Returns the direction from a point to this piece, as a unit vector, and the solid angle that it covers
    /// there, in sr.
    ///
    /// The solid angle is dA cos / r^2, which is exact in the limit of a piece that is small against its
    /// distance. A sum of f(w) dw over all pieces of a surface approaches the integral of f over the
    /// directions in which that surface is seen. Behind the piece the solid angle is 0; at the piece's own
    /// position both results are 0. The solid angle of a whole polygon or disk is computed in
    /// [`solid_angle`](crate::radiometry::solid_angle).
    ///
    /// See the [example](Self#example).
    #[must_use]
    pub fn seen_from(&self, point_m: [f32; 3]) -> ([f32; 3], f32) {
        let k = to_unity(self.position_m.into_iter().chain(point_m));
        let way = difference(scaled(self.position_m, k), scaled(point_m, k));
        let direction = unit(way);
        let cos = in_front(-dot(direction, unit(self.normal)));
        // Lengths were multiplied by k. The area is multiplied by it twice, since k^2 alone could overflow.
        let distance = dot(direction, way);
        let area = finite(self.area_m2 * k * k);
        (direction, ratio(cos * area, distance * distance))
    }
}
