//! Describes sources of simple shapes, and computes the irradiance that they cause at a point.

use crate::geometry::vec3::{difference, dot, scaled, sum, to_unity, unit};
use crate::math::Math;
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::radiometry::carried::{finite, ratio};
use crate::radiometry::form_factor::{to_disk, to_polygon_with, to_sphere_with};
use crate::radiometry::relations::in_front;
use crate::radiometry::{Carried, Intensity, Irradiance, Radiance};

/// A source that is too small to have a shape and that emits equally to all sides.
///
/// Call [`irradiance`](Self::irradiance) for the light that it brings to a surface.
///
/// # Example
/// ```
/// use nanospectra::radiometry::{Candela, Lux, PointSource};
/// let lamp = PointSource { position_m: [0.0, 3.0, 4.0], intensity: Candela::from(1000.0) };
/// // The floor below is 5 m away, at a cosine of 4/5: 1000 cd / 25 m2 * 4/5.
/// assert_eq!(lamp.irradiance([0.0; 3], [0.0, 0.0, 1.0]), Lux::from(32.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointSource<V> {
    /// The position at which the source stands, in m.
    pub position_m: [f32; 3],
    /// The intensity that it emits in every direction.
    pub intensity: Intensity<V>,
}

impl<V: Carried> PointSource<V> {
    /// Returns the irradiance at a point, given in m, on a surface with this normal.
    ///
    /// The normal may have any length other than 0. The result is 0 if the source lies behind the surface,
    /// and at the source's own position. See the [example](Self#example).
    ///
    /// # Accuracy
    /// The error is at most 8 units of 2^-24 of the irradiance at normal incidence.
    #[must_use]
    pub fn irradiance(&self, point_m: [f32; 3], normal: [f32; 3]) -> Irradiance<V> {
        let (way, k) = way(point_m, self.position_m);
        let cos = in_front(dot(unit(way), unit(normal)));
        let share = if cos == 0.0 { 0.0 } else { ratio(cos, dot(way, way)) };
        // Multiply by k twice, since k^2 may overflow or underflow where the product does not.
        Irradiance::new(self.intensity.value().map(|value| finite(finite(finite(value * k) * share) * k)))
    }
}

/// A sphere whose surface has the same radiance everywhere and into every direction, such as an opal globe.
///
/// Call [`irradiance`](Self::irradiance) for the light that it brings to a surface.
///
/// # Example
/// ```
/// # #[cfg(feature = "libm")] {
/// use nanospectra::radiometry::{Nit, SphereSource};
/// let globe = SphereSource { position_m: [0.0, 0.0, 2.0], radius_m: 0.25, radiance: Nit::from(1000.0) };
/// let straight_below = globe.irradiance([0.0; 3], [0.0, 0.0, 1.0]);
/// assert_eq!(format!("{straight_below:.2}"), "49.09 lx"); // pi L (r / d)^2
/// # }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereSource<V> {
    /// The position at which its center lies, in m.
    pub position_m: [f32; 3],
    /// The radius that the sphere has, in m.
    pub radius_m: f32,
    /// The radiance that its surface has, on its outside and on its inside.
    pub radiance: Radiance<V>,
}

impl<V: Carried> SphereSource<V> {
    /// Returns the irradiance at a point, given in m, on a surface with this normal.
    ///
    /// The normal may have any length other than 0 and any direction: the part of the sphere below the
    /// surface's horizon does not count. Within the sphere the result is pi L. See the
    /// [example](Self#example).
    ///
    /// # Accuracy
    /// The error is at most 7e-7 of the irradiance on a surface that faces the sphere, divided by the cosine
    /// of the sphere's angular radius. This holds from 1.0001 radii on; nearer, rounding of the distance
    /// decides whether the point lies within the sphere.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn irradiance(&self, point_m: [f32; 3], normal: [f32; 3]) -> Irradiance<V> {
        self.irradiance_with::<Portable>(point_m, normal)
    }

    /// Does the same as [`irradiance`](Self::irradiance) with a math backend of your choice.
    #[must_use]
    pub fn irradiance_with<M: Math>(&self, point_m: [f32; 3], normal: [f32; 3]) -> Irradiance<V> {
        let (way, k) = way(point_m, self.position_m);
        let direction = unit(way);
        let cos = dot(direction, unit(normal));
        let factor = to_sphere_with::<M>(finite(self.radius_m * k), dot(direction, way), cos);
        self.radiance.through_form_factor(factor)
    }
}

/// A disk whose front has the same radiance from every direction, such as the port of an integrating sphere.
///
/// Call [`irradiance`](Self::irradiance) for the light on a surface that faces it.
///
/// # Example
/// ```
/// use nanospectra::radiometry::{DiskSource, Nit};
/// // The port of an integrating sphere, 5 cm wide, seen from 0.5 m.
/// let port = DiskSource { radius_m: 0.025, radiance: Nit::from(1e4) };
/// assert_eq!(format!("{:.2}", port.irradiance(0.5, 0.0)), "78.34 lx"); // pi L r^2 / (r^2 + d^2)
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiskSource<V> {
    /// The radius that the disk has, in m.
    pub radius_m: f32,
    /// The radiance that its front has.
    pub radiance: Radiance<V>,
}

impl<V: Carried> DiskSource<V> {
    /// Returns the irradiance on a surface that is parallel to the disk and faces it.
    ///
    /// `distance_m` is the distance of the point from the plane of the disk, and `offset_m` its distance from
    /// the disk's axis. See the [example](Self#example).
    ///
    /// # Accuracy
    /// The relative error is at most 1e-6.
    #[must_use]
    pub fn irradiance(&self, distance_m: f32, offset_m: f32) -> Irradiance<V> {
        self.radiance.through_form_factor(to_disk(self.radius_m, distance_m, offset_m))
    }
}

/// A rectangle or parallelogram whose front has the same radiance from every direction, such as a light
/// panel.
///
/// Call [`irradiance`](Self::irradiance) for the light that it brings to a surface.
///
/// # Example
/// ```
/// # #[cfg(feature = "libm")] {
/// use nanospectra::radiometry::{Nit, RectangleSource};
/// // A panel of 1 m x 1 m in the ceiling that faces the floor 1 m below. Its form factor is 0.239456.
/// let panel = RectangleSource {
///     corner_m: [-0.5, -0.5, 1.0],
///     edges_m: [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]],
///     radiance: Nit::from(4000.0),
/// };
/// let floor = panel.irradiance([0.0; 3], [0.0, 0.0, 1.0]);
/// assert_eq!(format!("{floor:.1}"), "3009.1 lx"); // pi L F
/// # }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RectangleSource<V> {
    /// The position of the corner at which both edges begin, in m.
    pub corner_m: [f32; 3],
    /// The two edges that begin at that corner, in m.
    ///
    /// The front is the side from which the second edge is seen to the left of the first.
    pub edges_m: [[f32; 3]; 2],
    /// The radiance that its front has.
    pub radiance: Radiance<V>,
}

impl<V: Carried> RectangleSource<V> {
    /// Returns the irradiance at a point, given in m, on a surface with this normal.
    ///
    /// The normal may have any length other than 0 and any direction: the part of the rectangle below the
    /// surface's horizon does not count. Behind the rectangle the result is 0. See the
    /// [example](Self#example).
    ///
    /// # Accuracy
    /// The error is that of [`to_polygon`](crate::radiometry::form_factor::to_polygon).
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn irradiance(&self, point_m: [f32; 3], normal: [f32; 3]) -> Irradiance<V> {
        self.irradiance_with::<Portable>(point_m, normal)
    }

    /// Does the same as [`irradiance`](Self::irradiance) with a math backend of your choice.
    #[must_use]
    pub fn irradiance_with<M: Math>(&self, point_m: [f32; 3], normal: [f32; 3]) -> Irradiance<V> {
        let [u, v] = self.edges_m;
        let a = self.corner_m;
        let vertices = [a, sum(a, u), sum(sum(a, u), v), sum(a, v)].map(|vertex| vertex.map(finite));
        self.radiance.through_form_factor(to_polygon_with::<M>(point_m, normal, &vertices))
    }
}

/// Returns the vector between two points, scaled by a power of two so that its square is in range, and that
/// power.
fn way(from_m: [f32; 3], to_m: [f32; 3]) -> ([f32; 3], f32) {
    let k = to_unity(from_m.into_iter().chain(to_m));
    (difference(scaled(to_m, k), scaled(from_m, k)), k)
}
