//! Where a surface lies in the world: from positions and normals to the directions that a BRDF takes, and
//! back.

use crate::geometry::Direction;
use crate::geometry::vec3::{cross, difference, dot, scaled, to_unity, unit};

/// The frame of a surface in the world, right-handed: z is along the normal, x and y in the surface.
/// Positions and vectors of the world are `[f32; 3]`; a [`Direction`] is in this frame, with its zenith at
/// the normal.
///
/// ```
/// use nanospectra::matter::{Brdf, Conductor, Microfacet, TrowbridgeReitz};
/// use nanospectra::geometry::{Direction, Frame};
/// use nanospectra::radiometry::{Intensity, PointSource, Radiance, Radiant};
///
/// // A lamp of 2 W/sr, a plate of rough copper (in green) that leans, and a camera.
/// let lamp = PointSource { position_m: [0.0, 1.0, 2.0], intensity: Intensity::new(Radiant(2.0)) };
/// let (camera_m, point_m, normal) = ([1.0, 0.0, 2.0], [0.0; 3], [0.0, 0.5, 2.0]);
/// let copper =
///     Microfacet { facets: TrowbridgeReitz::new(0.3), boundary: Conductor { eta: 1.15, k: 2.56 } };
///
/// let Some(frame) = Frame::from_normal(normal) else { return };
/// let ways = (frame.towards(point_m, camera_m), frame.towards(point_m, lamp.position_m));
/// let (Some(wo), Some(wi)) = ways else { return };
/// let arriving = lamp.irradiance(point_m, normal); // W/m2, its cosine included
/// let seen = Radiance::new(arriving.value() * copper.f(wo, wi));
/// assert_eq!(format!("{arriving:.4}"), "0.3905 W/m2"); // 2 / 5 times the cosine 4.5 / sqrt(5 * 4.25)
/// assert_eq!(format!("{seen:.4}"), "0.0975 W/(m2 sr)");
/// ```
///
/// # Accuracy
/// Lengths and right angles of the axes to 2e-7, and so what is taken there and back
/// (`tests/radiometry/frames.rs`).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Frame {
    /// x, y and z of the surface, in the world.
    axes: [[f32; 3]; 3],
}

/// A tangent this near to the normal, in radians, says nothing about directions in the surface.
const LEAST_ANGLE: f32 = 1e-5;

impl Frame {
    /// A frame around a normal of any length but 0; `None` for that, and for what is not finite.
    ///
    /// How x and y are turned about the normal is arbitrary, with a seam between normals above and below z =
    /// 0. It matters only to surfaces that are brushed or woven: see [`with_tangent`](Self::with_tangent).
    ///
    /// # Reference
    /// T. Duff et al., "Building an orthonormal basis, revisited", JCGT 6 (2017).
    ///
    /// ```
    /// # use nanospectra::geometry::{Direction, Frame};
    /// let floor = Frame::from_normal([0.0, 0.0, 9.0]);
    /// assert_eq!(floor.and_then(|floor| floor.to_local([0.0, 0.0, 0.2])), Some(Direction::NORMAL));
    /// assert_eq!(Frame::from_normal([0.0; 3]), None);
    /// ```
    #[must_use]
    pub fn from_normal(normal: [f32; 3]) -> Option<Self> {
        let normal @ [x, y, z] = axis(normal)?;
        // Not the sign bit: 0 and -0 are one normal.
        let sign = if z < 0.0 { -1.0 } else { 1.0 };
        let a = -x / (sign + z);
        Self::around(normal, [1.0 + sign * (x * a), sign * (y * a), -sign * x])
    }

    /// A frame around a normal with x along what a tangent has in the surface: the way a metal is brushed.
    /// `None` if one of them has no length or is not finite, or where the tangent is along the normal (within
    /// 1e-5 rad).
    ///
    /// ```
    /// # use nanospectra::geometry::Frame;
    /// let Some(wall) = Frame::with_tangent([0.0, -1.0, 0.0], [1.0, 0.0, 0.0]) else { return };
    /// assert_eq!(wall.axes(), [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]); // y is up
    /// ```
    #[must_use]
    pub fn with_tangent(normal: [f32; 3], tangent: [f32; 3]) -> Option<Self> {
        let normal = axis(normal)?;
        let leaning = within(normal, axis(tangent)?);
        if dot(leaning, leaning) < LEAST_ANGLE * LEAST_ANGLE {
            return None;
        }
        // What rounding left along the normal grows as a short remainder is brought to length 1: hence once
        // more.
        Self::around(normal, axis(leaning)?)
    }

    /// From a normal of length 1 and a tangent that is nearly at right angles to it. (Without this last step
    /// a normal whose length is 1e-7 off would be 3e-7 off the right angle.)
    fn around(normal: [f32; 3], tangent: [f32; 3]) -> Option<Self> {
        let tangent = axis(within(normal, tangent))?;
        Some(Frame { axes: [tangent, axis(cross(normal, tangent))?, normal] })
    }

    /// x, y and z (the normal) of the surface, as unit vectors of the world.
    #[must_use]
    pub const fn axes(self) -> [[f32; 3]; 3] {
        self.axes
    }

    /// The direction of a vector of the world, of any length but 0; `None` for no length, and for what is not
    /// finite.
    #[must_use]
    pub fn to_local(self, vector: [f32; 3]) -> Option<Direction> {
        let vector = scaled(vector, to_unity(vector));
        Direction::from_vector(self.axes.map(|axis| dot(axis, vector)))
    }

    /// The direction in which a target is seen from a point, both in m in the world; `None` where they are
    /// one place.
    #[must_use]
    pub fn towards(self, point_m: [f32; 3], target_m: [f32; 3]) -> Option<Direction> {
        let k = to_unity(point_m.into_iter().chain(target_m));
        self.to_local(difference(scaled(target_m, k), scaled(point_m, k)))
    }

    /// A direction as a unit vector of the world.
    #[must_use]
    pub fn to_world(self, direction: Direction) -> [f32; 3] {
        let [[tx, ty, tz], [bx, by, bz], [nx, ny, nz]] = self.axes;
        let w = direction.to_array();
        [dot([tx, bx, nx], w), dot([ty, by, ny], w), dot([tz, bz, nz], w)]
    }
}

/// What a vector has at right angles to a normal.
fn within(normal: [f32; 3], vector: [f32; 3]) -> [f32; 3] {
    difference(vector, scaled(normal, dot(vector, normal)))
}

/// The vector of length 1 in this direction; none for no length, and for what is not finite.
fn axis(vector: [f32; 3]) -> Option<[f32; 3]> {
    let axis = unit(vector);
    (dot(axis, axis) > 0.5).then_some(axis)
}
