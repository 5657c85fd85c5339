//! Sources of simple shapes, and the irradiance by them at a point with a normal.

use crate::geometry::vec3::{difference, dot, scaled, sum, to_unity, unit};
use crate::math::Math;
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::radiometry::carried::{finite, ratio};
use crate::radiometry::form_factor::{to_disk, to_polygon_with, to_sphere_with};
use crate::radiometry::relations::in_front;
use crate::radiometry::{Carried, Intensity, Irradiance, Radiance};

/// A source too small to have a shape, equally bright to all sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointSource<V> {
    /// Where it is, in m.
    pub position_m: [f32; 3],
    /// Its intensity.
    pub intensity: Intensity<V>,
}

impl<V: Carried> PointSource<V> {
    /// The irradiance at a point in m, on a surface with this normal (of any length but 0). Nothing at the
    /// source's own place, from which it has no direction.
    ///
    /// # Accuracy
    /// 8 units of 2^-24 of the irradiance at normal incidence.
    ///
    /// ```
    /// use nanospectra::radiometry::{Candela, Lux, PointSource};
    /// let lamp = PointSource { position_m: [0.0, 3.0, 4.0], intensity: Candela::from(1000.0) };
    /// // 5 m away, at a cosine of 4/5.
    /// assert_eq!(lamp.irradiance([0.0; 3], [0.0, 0.0, 1.0]), Lux::from(32.0));
    /// ```
    #[must_use]
    pub fn irradiance(&self, point_m: [f32; 3], normal: [f32; 3]) -> Irradiance<V> {
        let (way, k) = way(point_m, self.position_m);
        let cos = in_front(dot(unit(way), unit(normal)));
        let share = if cos == 0.0 { 0.0 } else { ratio(cos, dot(way, way)) };
        // k^2 may overflow, or vanish, where the product does not.
        Irradiance::new(self.intensity.value().map(|value| finite(finite(finite(value * k) * share) * k)))
    }
}

/// A Lambertian sphere: equally bright from everywhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereSource<V> {
    /// Its center, in m.
    pub position_m: [f32; 3],
    /// Its radius, in m.
    pub radius_m: f32,
    /// The radiance of its surface, the same on its inside.
    pub radiance: Radiance<V>,
}

impl<V: Carried> SphereSource<V> {
    /// The irradiance at a point in m, on a surface with this normal (of any length but 0), at any tilt, also
    /// with the sphere partly below the surface's horizon. Within the sphere it is pi L.
    ///
    /// # Accuracy
    /// 4e-7 of what it would be straight ahead.
    ///
    /// ```
    /// use nanospectra::radiometry::{Nit, SphereSource};
    /// let globe = SphereSource { position_m: [0.0, 0.0, 2.0], radius_m: 0.25, radiance: Nit::from(1000.0) };
    /// assert_eq!(format!("{:.2}", globe.irradiance([0.0; 3], [0.0, 0.0, 1.0])), "49.09 lx"); // pi L (r / d)^2
    /// ```
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn irradiance(&self, point_m: [f32; 3], normal: [f32; 3]) -> Irradiance<V> {
        self.irradiance_with::<Portable>(point_m, normal)
    }

    /// [`irradiance`](Self::irradiance) on another math backend.
    #[must_use]
    pub fn irradiance_with<M: Math>(&self, point_m: [f32; 3], normal: [f32; 3]) -> Irradiance<V> {
        let (way, k) = way(point_m, self.position_m);
        let direction = unit(way);
        let cos = dot(direction, unit(normal));
        let factor = to_sphere_with::<M>(finite(self.radius_m * k), dot(direction, way), cos);
        self.radiance.through_form_factor(factor)
    }
}

/// A Lambertian disk: equally bright from everywhere before it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiskSource<V> {
    /// Its radius, in m.
    pub radius_m: f32,
    /// The radiance of its front.
    pub radiance: Radiance<V>,
}

impl<V: Carried> DiskSource<V> {
    /// The irradiance on a surface parallel to the disk and facing it, at a distance from its plane and
    /// `offset_m` beside its axis.
    ///
    /// # Accuracy
    /// 1e-6, relative.
    ///
    /// ```
    /// use nanospectra::radiometry::{DiskSource, Nit};
    /// // An integrating sphere's port, 5 cm wide, from 0.5 m.
    /// let port = DiskSource { radius_m: 0.025, radiance: Nit::from(1e4) };
    /// assert_eq!(format!("{:.2}", port.irradiance(0.5, 0.0)), "78.34 lx"); // pi L r^2 / (r^2 + d^2)
    /// ```
    #[must_use]
    pub fn irradiance(&self, distance_m: f32, offset_m: f32) -> Irradiance<V> {
        self.radiance.through_form_factor(to_disk(self.radius_m, distance_m, offset_m))
    }
}

/// A Lambertian rectangle (or any parallelogram): equally bright from everywhere before it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RectangleSource<V> {
    /// One of its corners, in m.
    pub corner_m: [f32; 3],
    /// The edges that begin there, in m; seen from its front the second one is to the left of the first.
    pub edges_m: [[f32; 3]; 2],
    /// The radiance of its front.
    pub radiance: Radiance<V>,
}

impl<V: Carried> RectangleSource<V> {
    /// The irradiance at a point in m, on a surface with this normal (of any length but 0), at any tilt, also
    /// with the rectangle partly below the surface's horizon. Nothing from behind the rectangle.
    ///
    /// # Accuracy
    /// That of [`to_polygon`](crate::radiometry::form_factor::to_polygon).
    ///
    /// ```
    /// use nanospectra::radiometry::{Nit, RectangleSource};
    /// // A panel of 1 m x 1 m in the ceiling, 1 m above.
    /// let panel = RectangleSource {
    ///     corner_m: [-0.5, -0.5, 1.0],
    ///     edges_m: [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]],
    ///     radiance: Nit::from(4000.0),
    /// };
    /// assert_eq!(format!("{:.1}", panel.irradiance([0.0; 3], [0.0, 0.0, 1.0])), "3009.1 lx");
    /// ```
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn irradiance(&self, point_m: [f32; 3], normal: [f32; 3]) -> Irradiance<V> {
        self.irradiance_with::<Portable>(point_m, normal)
    }

    /// [`irradiance`](Self::irradiance) on another math backend.
    #[must_use]
    pub fn irradiance_with<M: Math>(&self, point_m: [f32; 3], normal: [f32; 3]) -> Irradiance<V> {
        let [u, v] = self.edges_m;
        let a = self.corner_m;
        let vertices = [a, sum(a, u), sum(sum(a, u), v), sum(a, v)].map(|vertex| vertex.map(finite));
        self.radiance.through_form_factor(to_polygon_with::<M>(point_m, normal, &vertices))
    }
}

/// From here to there, and the power of two that it was multiplied by so that its square is in range.
fn way(from_m: [f32; 3], to_m: [f32; 3]) -> ([f32; 3], f32) {
    let k = to_unity(from_m.into_iter().chain(to_m));
    (difference(scaled(to_m, k), scaled(from_m, k)), k)
}
